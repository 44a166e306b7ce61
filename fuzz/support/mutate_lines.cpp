// SPDX-License-Identifier: MIT
#include <fuzz/support/mutate_lines.h>

#include <sstream>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace lightcuts::fuzz {
namespace {

using Words = std::vector<std::string>;

std::vector<Words> lines_of(const std::string& text) {
  std::vector<Words> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    Words& all = lines.emplace_back();
    for (std::string word; words >> word;) all.push_back(word);
  }
  return lines;
}

std::string number(gen::Dice& dice) {
  switch (dice.below(4)) {
  case 0:
    return std::to_string(dice.between(-6, 12));
  case 1:
    return dice.pick<const char*>({"nan", "inf", "-inf", "1e39", "1e-46", "0x10", "1.", ".5", "+1",
                                   "4294967296", "-2147483649", "9223372036854775808", "1e", ""});
  case 2:
    return fmt::format("{}/{}/{}", dice.between(-4, 6), dice.between(-4, 6), dice.between(-4, 6));
  default:
    return fmt::format("{}", dice.finite_float());
  }
}

template <class List>
auto& any_of(gen::Dice& dice, List& list) {
  return list[std::size_t(dice.bits() % list.size())];
}

void change_word(gen::Dice& dice, std::vector<Words>& lines, Words& line,
                 const Bytewise& bytewise) {
  if (line.empty()) return;
  std::string& word = any_of(dice, line);
  Words& other = any_of(dice, lines);
  switch (dice.below(5)) {
  case 0:
    word = bytewise(word);
    return;
  case 1:
    if (!other.empty()) word = std::string(any_of(dice, other));
    return;
  case 2:
    line.push_back(std::string(word));
    return;
  case 3:
    line.pop_back();
    return;
  default:
    word = number(dice);
  }
}

void change_once(gen::Dice& dice, std::vector<Words>& lines, const Bytewise& bytewise) {
  const std::size_t at = std::size_t(dice.bits() % lines.size());
  switch (dice.below(8)) {
  case 0:
    if (lines.size() > 1) lines.erase(lines.begin() + std::ptrdiff_t(at));
    return;
  case 1:
    lines.push_back(Words(lines[at]));
    return;
  case 2:
    std::swap(lines[at], any_of(dice, lines));
    return;
  default:
    change_word(dice, lines, lines[at], bytewise);
  }
}

} // namespace

std::string mutated_lines(const std::string& input, gen::Dice& dice, const Bytewise& bytewise) {
  std::vector<Words> lines = lines_of(input);
  if (lines.empty()) return bytewise(input);
  for (int i = dice.between(1, 4); i > 0; --i) change_once(dice, lines, bytewise);
  std::string text;
  for (const Words& words : lines) text += fmt::format("{}\n", fmt::join(words, " "));
  return text;
}

} // namespace lightcuts::fuzz

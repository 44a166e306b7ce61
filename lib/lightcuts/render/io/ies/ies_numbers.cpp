// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/ies/ies_numbers.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include <lightcuts/render/files/text.h>

namespace lightcuts {
namespace {

// As the standard has them, and what editors leave behind.
constexpr std::string_view delimiters = " ,\t\r\n\v\f\x1a";

constexpr std::size_t longest_quote = 40;

std::string quoted(std::string_view word) {
  const std::string text(word.substr(0, longest_quote));
  return one_line(fmt::format("'{}{}'", text, word.size() > longest_quote ? "..." : ""));
}

} // namespace

std::string_view IesNumbers::next_line(const char* expected) {
  read_line_ = line_;
  if (rest_.empty()) refuse(InputFault::malformed_file, fmt::format("ends before {}", expected));
  // Lines end by \n, \r\n or \r.
  const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
  std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(end);
  if (rest_.starts_with("\r\n"))
    rest_.remove_prefix(2);
  else if (!rest_.empty())
    rest_.remove_prefix(1);
  ++line_;
  const std::size_t begin = std::min(line.find_first_not_of(" \t"), line.size());
  line.remove_prefix(begin);
  return line.substr(0, line.find_last_not_of(" \t") + 1);
}

std::string_view IesNumbers::next_word() {
  while (!rest_.empty() && delimiters.find(rest_.front()) != std::string_view::npos) {
    const bool ends_line =
        rest_.front() == '\n' || (rest_.front() == '\r' && !rest_.starts_with("\r\n"));
    if (ends_line) ++line_;
    rest_.remove_prefix(1);
  }
  const std::string_view word = rest_.substr(0, rest_.find_first_of(delimiters));
  rest_.remove_prefix(word.size());
  read_line_ = line_;
  return word;
}

double IesNumbers::number(const char* what, double least, double most) {
  std::string_view word = next_word();
  if (word.empty()) refuse(InputFault::malformed_file, fmt::format("ends before {}", what));
  const std::string_view digits = word.starts_with('+') ? word.substr(1) : word;
  double value = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value))
    refuse(InputFault::malformed_file,
           fmt::format("{} is {}, expected a number", what, quoted(word)));
  if (value < least || value > most)
    refuse(value < 0 && least == 0 ? InputFault::negative : InputFault::out_of_domain,
           fmt::format("{} is {}, expected {} to {}", what, value, least, most));
  return value;
}

std::size_t IesNumbers::whole(const char* what, std::size_t least, std::size_t most) {
  const double value = number(what, double(least), double(most));
  if (value != std::floor(value))
    refuse(InputFault::malformed_file,
           fmt::format("{} is {}, expected a whole number", what, value));
  return std::size_t(value);
}

std::vector<double> IesNumbers::numbers(const char* what, std::size_t count, double least,
                                        double most) {
  std::vector<double> list;
  // No more at once than the file can have.
  list.reserve(std::min(count, rest_.size() / 2 + 1));
  while (list.size() < count) list.push_back(number(what, least, most));
  return list;
}

std::vector<double> IesNumbers::increasing(const char* what, std::size_t count, double least,
                                           double most) {
  std::vector<double> list;
  list.reserve(std::min(count, rest_.size() / 2 + 1));
  while (list.size() < count) {
    const double value = number(what, least, most);
    if (!list.empty() && !(value > list.back()))
      refuse(InputFault::malformed_file,
             fmt::format("{} is {}, expected more than {} before it", what, value, list.back()));
    list.push_back(value);
  }
  return list;
}

std::size_t IesNumbers::words_left() const {
  IesNumbers copy = *this;
  std::size_t count = 0;
  while (!copy.next_word().empty()) ++count;
  return count;
}

void IesNumbers::refuse(InputFault fault, const std::string& why) const {
  throw InputError(fault, one_line(fmt::format("{}:{}: {}", file_, read_line_, why)));
}

} // namespace lightcuts

// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/models/obj/obj_lines.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>

#include <lightcuts/render/files/text.h>

namespace lightcuts {
namespace {

constexpr std::string_view blanks = " \t\r\v\f";

bool is_blank(char c) { return blanks.find(c) != std::string_view::npos; }

/// Statements of numbers only, in which a '#' cannot be part of a name.
bool has_numbers_only(std::string_view line) {
  const std::size_t begin = std::min(line.find_first_not_of(blanks), line.size());
  return begin < line.size() && (line[begin] == 'v' || line[begin] == 'f') &&
         line.substr(begin, 2).find_first_not_of("vtnf \t") == std::string_view::npos;
}

std::string_view without_comment(std::string_view line) {
  const bool anywhere = has_numbers_only(line);
  for (std::size_t at = line.find('#'); at != std::string_view::npos; at = line.find('#', at + 1))
    if (anywhere || at == 0 || is_blank(line[at - 1])) return line.substr(0, at);
  return line;
}

} // namespace

ObjLines::ObjLines(const std::filesystem::path& file)
    : file_(file.string()), text_(read_text(file)) {
  // As old Macintoshes end lines.
  if (text_.find('\n') == std::string::npos) std::replace(text_.begin(), text_.end(), '\r', '\n');
}

void ObjLines::rewind() { position_ = number_ = 0; }

bool ObjLines::next() {
  words_.clear();
  while (words_.empty() && position_ < text_.size()) {
    first_number_ = number_ + 1;
    while (read_line() && position_ < text_.size()) {
    }
  }
  return !words_.empty();
}

bool ObjLines::read_line() {
  const std::size_t end = std::min(text_.find('\n', position_), text_.size());
  std::string_view line = std::string_view(text_).substr(position_, end - position_);
  position_ = end + 1;
  ++number_;
  const std::size_t last = line.find_last_not_of(blanks);
  const bool continues = last != std::string_view::npos && line[last] == '\\';
  split(without_comment(continues ? line.substr(0, last) : line));
  return continues;
}

void ObjLines::split(std::string_view line) {
  const char* at = line.data();
  const char* const end = at + line.size();
  while (true) {
    while (at != end && is_blank(*at)) ++at;
    if (at == end) return;
    const char* const begin = at;
    while (at != end && !is_blank(*at)) ++at;
    words_.emplace_back(begin, at - begin);
  }
}

std::string ObjLines::rest(std::size_t first_word) const {
  if (first_word >= words_.size()) return {};
  // Words are views of the text: the last one on the first word's line ends it.
  const char* const begin = words_[first_word].data();
  const char* end = begin;
  for (std::size_t i = first_word; i < words_.size(); ++i) {
    if (std::find(end, words_[i].data(), '\n') != words_[i].data()) break;
    end = words_[i].data() + words_[i].size();
  }
  return {begin, end};
}

void ObjLines::refuse(const std::string& why) const {
  throw InputError(InputFault::malformed_file,
                   one_line(fmt::format("{}:{}: {}", file_, first_number_, why)));
}

bool ObjLines::read_number(std::string_view word, float& result) const {
  std::string_view digits = word;
  if (!digits.empty() && digits[0] == '+') digits.remove_prefix(1);
  // By way of double a float could be rounded twice.
  const char* const last = digits.data() + digits.size();
  const auto [end, error] = std::from_chars(digits.data(), last, result);
  if (error == std::errc::invalid_argument || end != last) return false;
  if (error == std::errc{}) return true;
  const std::size_t exponent = digits.find_first_of("eE");
  const bool tiny = exponent != std::string_view::npos
                        ? digits.substr(exponent + 1, 1) == "-"
                        : digits.find_first_of("123456789") > digits.find('.');
  if (!tiny) refuse(fmt::format("{} is out of range", word));
  double wide = 0; // subnormal floats may be counted as out of range, or are 0
  std::from_chars(digits.data(), last, wide);
  result = static_cast<float>(wide);
  return true;
}

const std::vector<float>& ObjLines::numbers(std::size_t least, std::size_t most) {
  const std::size_t count = words_.size() - 1;
  if (count < least || count > most)
    refuse(fmt::format("'{}' with {} values, expected {}", key(), count, least));
  numbers_.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    if (!read_number(words_[i + 1], numbers_[i]))
      refuse(fmt::format("'{}' is not a number", words_[i + 1]));
  return numbers_;
}

} // namespace lightcuts

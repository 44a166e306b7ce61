// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace lightcuts {

/// The statements of an `.obj` or `.mtl` file as words. A line that ends in a backslash goes on in
/// the next; what follows a '#' is left out, of statements that name things only where the '#'
/// begins a word.
class ObjLines {
public:
  /// Reads the file; throws as read_text() does.
  explicit ObjLines(const std::filesystem::path& file);

  /// Goes on to the next line that has words; false at the end.
  bool next();
  /// Begins anew.
  void rewind();

  [[nodiscard]] const std::vector<std::string_view>& words() const { return words_; }
  [[nodiscard]] std::string_view key() const { return words_[0]; }

  /// The line's text from that word on, blanks between words as they are, none at the end; empty
  /// where there is no such word. Of a statement on several lines, the first.
  [[nodiscard]] std::string rest(std::size_t first_word = 1) const;

  /// Throws InputError as `file:line: why`.
  [[noreturn]] void refuse(const std::string& why) const;

  /// Whether the word is a number; refuses one beyond float's range. "nan" and "inf" are.
  bool read_number(std::string_view word, float& value) const;

  /// The words after the first as numbers; refuses other words, and less or more than these.
  const std::vector<float>& numbers(std::size_t least, std::size_t most);

private:
  bool read_line();
  void split(std::string_view line);

  std::string file_, text_;
  std::size_t position_ = 0, number_ = 0, first_number_ = 0;
  std::vector<std::string_view> words_;
  std::vector<float> numbers_;
};

} // namespace lightcuts

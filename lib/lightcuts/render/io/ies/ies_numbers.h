// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <lightcuts/core/input_error.h>

namespace lightcuts {

/// The numbers of a file after IES LM-63, wherever its lines end. Every reader throws InputError as
/// `file:line: what is wrong`.
class IesNumbers {
public:
  IesNumbers(const std::string& file, std::string_view text) : file_(file), rest_(text) {}

  /// The next line, without blanks around it. Refuses the end of the file.
  std::string_view next_line(const char* expected);
  /// Whether nothing is left.
  [[nodiscard]] bool is_at_end() const { return rest_.empty(); }

  /// The next number: finite, and between these.
  double number(const char* what, double least, double most);
  /// A number without a fraction.
  std::size_t whole(const char* what, std::size_t least, std::size_t most);
  std::vector<double> numbers(const char* what, std::size_t count, double least, double most);
  /// numbers(), each larger than the one before.
  std::vector<double> increasing(const char* what, std::size_t count, double least, double most);
  /// How many words are left.
  [[nodiscard]] std::size_t words_left() const;

  /// At the line of what was read last.
  [[noreturn]] void refuse(InputFault fault, const std::string& why) const;

private:
  std::string_view next_word();

  const std::string& file_;
  std::string_view rest_;
  std::size_t line_ = 1;      ///< where rest_ begins
  std::size_t read_line_ = 1; ///< of what was read last
};

} // namespace lightcuts

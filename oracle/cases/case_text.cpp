// SPDX-License-Identifier: MIT
#include <oracle/cases/case_text.h>

#include <algorithm>

#include <fmt/format.h>

namespace lightcuts::oracle {
namespace {

// Longer cases are counterexamples that could not be shrunk.
constexpr std::size_t most_lines = 40;

} // namespace

std::string wrapped(const std::string& text, std::size_t indent) {
  std::string result;
  std::size_t column = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    if (column > 0 && column + 1 + (end - at) > 100) {
      result += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (at > 0) {
      result += " ";
      ++column;
    }
    result += text.substr(at, end - at);
    column += end - at;
    at = end + 1;
  }
  return result + "\n";
}

std::string text_of(const Exact& value, int digits) {
  std::string text = value.str(digits);
  return text.size() <= 25 ? text : value.str(14);
}

std::string lines_of(const gen::View& view) {
  std::string text;
  for_each_line(view, [&text](const std::string& name, const std::string& value) {
    text += fmt::format("  {:<11}{}\n", name, value);
  });
  return text;
}

std::string text_of(const Case& on) {
  std::string text;
  for_each_field(on, Case{},
                 [&text]<class Value>(std::string name, const Value& value, const Value& usual,
                                      const Domain& domain) {
                   if (domain.optional && same_bits(value, usual)) return;
                   std::replace(name.begin(), name.end(), '_', ' ');
                   if constexpr (is_vector<Value>) {
                     name.pop_back(); // its plural
                     for (std::size_t i = 0; i < value.size() && i < most_lines; ++i)
                       text += wrapped(fmt::format("{} {}: {}", name, i, text_of(value[i])));
                     if (value.size() > most_lines)
                       text += fmt::format("... and {} more\n", value.size() - most_lines);
                   } else {
                     text += wrapped(fmt::format("{}: {}", name, text_of(value)));
                   }
                 });
  return text;
}

} // namespace lightcuts::oracle

// SPDX-License-Identifier: MIT
#include <oracle/counterexamples/as_test.h>

#include <cctype>
#include <string_view>

#include <fmt/format.h>

#include <oracle/cases/case_text.h>
#include <oracle/records/record_literal.h>

namespace lightcuts::oracle {
namespace {

/// "BoundIsFinite" or "bound_is_finite" of "bound-is-finite".
std::string camel_case(std::string_view name) {
  std::string text;
  bool start = true;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      text += start ? char(std::toupper(static_cast<unsigned char>(c))) : c;
    start = std::isalnum(static_cast<unsigned char>(c)) == 0;
  }
  return text;
}

std::string snake_case(std::string text) {
  for (char& c : text)
    if (c == '-') c = '_';
  return text;
}

/// Of a property's value; see Property.
std::string assertion(const char* comparison, const std::string& subject,
                      const std::string& property) {
  return fmt::format("  EXPECT_{}(failure_of(*{},\n                       Property::{}, on),\n"
                     "            std::nullopt);\n",
                     comparison, subject, property);
}

std::string string_literal(const std::string& text) {
  std::string literal = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') literal += '\\';
    literal += c;
  }
  return literal + '"';
}

} // namespace

std::string statements_for(const Case& on) {
  std::string text = "  Case on;\n";
  for_each_field(
      on, Case{},
      [&text]<class Value>(const char* name, const Value& value, const Value& usual, Domain) {
        if (same_bits(value, usual)) return;
        if constexpr (is_vector<Value>) {
          text += fmt::format("  on.{} = {{\n", name);
          for (const auto& element : value)
            text += wrapped("      " + literal_of(element) + ",", 8);
          text += "  };\n";
        } else {
          text += wrapped(fmt::format("  on.{} = {};", name, literal_of(value)), 6);
        }
      });
  return text;
}

std::string as_test(const SavedCounterexample& saved) {
  constexpr std::string_view mutant = "mutant:";
  const bool is_mutant = saved.subject.starts_with(mutant);
  const std::string name = is_mutant ? saved.subject.substr(mutant.size()) : "";
  const char* property = info(saved.counterexample.property).name;
  std::string text = "#include <optional>\n\n#include <gtest/gtest.h>\n"
                     "#include <oracle/campaign/hunt.h>\n";
  text += is_mutant ? "#include <oracle/mutants/mutants.h>\n"
                      "#include <oracle/subjects/library_subject.h>\n"
                    : "#include <oracle/counterexamples/named_subjects.h>\n";
  text += fmt::format("\nnamespace lightcuts::oracle {{\nnamespace {{\n\n// {}\nTEST({}, {}) {{\n",
                      info(saved.counterexample.property).statement,
                      is_mutant ? camel_case(name) : "Counterexample", camel_case(property));
  text += statements_for(saved.counterexample.on);
  const std::string literal = string_literal(is_mutant ? name : saved.subject);
  if (is_mutant) {
    text += assertion("EQ", "library_subject()", snake_case(property));
    text += assertion("NE", "mutant_named(" + literal + ")->subject()", snake_case(property));
  } else {
    text += assertion("EQ", "subject_named(" + literal + ")", snake_case(property));
  }
  return text + "}\n\n} // namespace\n} // namespace lightcuts::oracle\n";
}

} // namespace lightcuts::oracle

// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/json/json_element.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <lightcuts/render/files/text.h>

namespace lightcuts {

void JsonElement::refuse_as(InputFault fault, const std::string& end) const {
  // The root's path is empty; say "the file" instead.
  const bool nameless = path_.empty() && end.compare(0, 1, "/") != 0;
  throw JsonError(fault,
                  one_line(fmt::format("{}: {}{}", file_, nameless ? "the whole" : path_, end)));
}

void JsonElement::refuse_type(const char* expected) const {
  const std::string type = json_->type_name();
  const bool vowel = type.find_first_of("aeiou") == 0;
  const std::string article = json_->is_null() ? "" : vowel ? "an " : "a ";
  refuse(InputFault::malformed_file, fmt::format("is {}{}, expected {}", article, type, expected));
}

void JsonElement::expect_keys(const std::vector<std::string>& known) const {
  if (!json_->is_object()) refuse_type("an object");
  for (const auto& [key, value] : json_->items())
    if (std::find(known.begin(), known.end(), key) == known.end())
      refuse_as(InputFault::unknown_name,
                fmt::format("/{} is unknown; known: {}", key, fmt::join(known, ", ")));
}

JsonElement JsonElement::operator[](const char* key) const {
  if (!has(key)) refuse_as(InputFault::missing, fmt::format("/{} is missing", key));
  return {file_, path_ + "/" + key, json_->at(key)};
}

JsonElement JsonElement::without(const char* key, nlohmann::json& copy) const {
  copy = *json_;
  copy.erase(key);
  return {file_, path_, copy};
}

JsonElement JsonElement::at(std::size_t i) const {
  return {file_, fmt::format("{}/{}", path_, i), json_->at(i)};
}

std::string JsonElement::string() const {
  if (!json_->is_string()) refuse_type("a string");
  return json_->get<std::string>();
}

std::string JsonElement::path() const {
  std::string text = string();
  if (text.empty() || text.find('\0') != std::string::npos)
    refuse(InputFault::malformed_file, "is not the name of a file");
  return text;
}

std::size_t JsonElement::one_of(std::span<const char* const> names) const {
  const std::string text = string();
  const auto found = std::find(names.begin(), names.end(), text);
  if (found == names.end())
    refuse(InputFault::unknown_name,
           fmt::format("is '{}', expected one of {}", text, fmt::join(names, ", ")));
  return std::size_t(found - names.begin());
}

bool JsonElement::boolean() const {
  if (!json_->is_boolean()) refuse_type("true or false");
  return json_->get<bool>();
}

float JsonElement::number(float least) const {
  if (!json_->is_number()) refuse_type("a number");
  const auto value = json_->get<double>();
  constexpr double largest = 3.4028235e38; // float's in as few digits as tell it from others
  if (!(std::abs(value) <= largest))
    refuse(InputFault::out_of_domain, fmt::format("is {}, out of range", value));
  if (value < least)
    refuse(least >= 0 ? fault_of(value) : InputFault::out_of_domain,
           least == 0 ? "is negative" : fmt::format("is {}, expected at least {}", value, least));
  return static_cast<float>(value);
}

double JsonElement::wide_number() const {
  if (!json_->is_number()) refuse_type("a number");
  return json_->get<double>(); // the parser knows no others
}

std::uint64_t JsonElement::whole_number(std::uint64_t least, std::uint64_t most) const {
  if (!json_->is_number()) refuse_type("a whole number");
  const bool whole = json_->is_number_unsigned();
  const std::uint64_t value = whole ? json_->get<std::uint64_t>() : 0;
  if (!whole || value < least || value > most)
    refuse(InputFault::out_of_domain,
           fmt::format("is {}, expected a whole number from {} to {}", json_->dump(), least, most));
  return value;
}

glm::vec3 JsonElement::vector(float least) const {
  if (!json_->is_array()) refuse_type("a list of three numbers");
  if (size() != 3)
    refuse(InputFault::malformed_file, fmt::format("has {} elements, expected three", size()));
  return {at(0).number(least), at(1).number(least), at(2).number(least)};
}

glm::vec3 JsonElement::colour() const { return is_number() ? glm::vec3(number(0)) : vector(0); }

glm::vec3 JsonElement::direction() const {
  const glm::vec3 v = vector();
  if (v == glm::vec3(0)) refuse(InputFault::out_of_domain, "is zero, expected a direction");
  return glm::vec3(glm::normalize(glm::dvec3(v)));
}

} // namespace lightcuts

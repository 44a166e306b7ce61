// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <lightcuts/core/input_error.h>
#include <nlohmann/json.hpp>

namespace lightcuts {

/// An error that says where in a JSON file it is.
struct JsonError : InputError {
  using InputError::InputError;
};

/// A value in a JSON file that knows where it is, so that errors can name it. Every reader throws
/// JsonError as `file: /path/to/it what is wrong`.
class JsonElement {
public:
  /// The file's root. `json` must outlive the element and all that come from it.
  JsonElement(std::string file, const nlohmann::json& json)
      : file_(std::move(file)), json_(&json) {}

  [[nodiscard]] bool is_list() const { return json_->is_array(); }
  [[nodiscard]] bool is_number() const { return json_->is_number(); }
  [[nodiscard]] bool is_string() const { return json_->is_string(); }
  [[nodiscard]] std::size_t size() const { return json_->size(); }
  [[nodiscard]] bool has(const std::string& key) const { return json_->contains(key); }

  /// Refuses what is not an object, and keys that are not among these.
  void expect_keys(const std::vector<std::string>& known) const;

  /// Member of an object; refuses its absence.
  [[nodiscard]] JsonElement operator[](const char* key) const;
  /// The same object without one of its members; `copy` keeps it and must outlive it.
  [[nodiscard]] JsonElement without(const char* key, nlohmann::json& copy) const;
  /// Element of a list.
  [[nodiscard]] JsonElement at(std::size_t i) const;

  [[nodiscard]] std::string string() const;
  /// The name of a file: a string without zeros, not empty.
  [[nodiscard]] std::string path() const;
  /// "scene.json: /geometry 'NAME'", of a string: how messages name a file that it names.
  [[nodiscard]] std::string label() const { return file_ + ": " + path_ + " '" + string() + "'"; }
  [[nodiscard]] bool boolean() const;
  /// A number within float's range that is at least `least`.
  [[nodiscard]] float number(float least = std::numeric_limits<float>::lowest()) const;
  /// A finite number.
  [[nodiscard]] double wide_number() const;
  [[nodiscard]] std::uint64_t whole_number(std::uint64_t least, std::uint64_t most) const;
  /// The index of the text among these.
  [[nodiscard]] std::size_t one_of(std::span<const char* const> names) const;
  /// Intensity, irradiance: a number or a list of three, each 0 or more.
  [[nodiscard]] glm::vec3 colour() const;
  /// A list of three numbers, made unit; not zero.
  [[nodiscard]] glm::vec3 direction() const;
  /// A list of three numbers.
  [[nodiscard]] glm::vec3 vector(float least = std::numeric_limits<float>::lowest()) const;

  [[noreturn]] void refuse(InputFault fault, const std::string& why) const {
    refuse_as(fault, " " + why);
  }
  /// Refuses by a message in which `end` follows the path directly.
  [[noreturn]] void refuse_as(InputFault fault, const std::string& end) const;

private:
  JsonElement(std::string file, std::string path, const nlohmann::json& json)
      : file_(std::move(file)), path_(std::move(path)), json_(&json) {}

  [[noreturn]] void refuse_type(const char* expected) const;

  std::string file_, path_;
  const nlohmann::json* json_;
};

} // namespace lightcuts

// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

namespace lightcuts {

/// What breaks glTF's rules; the file's name is added where it is known.
class GltfFault : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

namespace gltf {

using Json = nlohmann::json;

/// A whole number from 0 to 2^53. Throws GltfFault.
[[nodiscard]] std::size_t whole(const Json& value, const char* name);
/// A member that must be there.
[[nodiscard]] std::size_t whole_in(const Json& object, const char* key);
[[nodiscard]] std::size_t whole_in(const Json& object, const char* key, std::size_t otherwise);
/// Nothing where the member is not there.
[[nodiscard]] std::optional<std::size_t> index_in(const Json& object, const char* key);

[[nodiscard]] double number_in(const Json& object, const char* key, double otherwise);
[[nodiscard]] std::string text_in(const Json& object, const char* key,
                                  const std::string& otherwise);
[[nodiscard]] bool truth_in(const Json& object, const char* key, bool otherwise);

/// Lists of two, three and more numbers; a list may be longer.
[[nodiscard]] glm::dvec2 vector_in(const Json& object, const char* key,
                                   const glm::dvec2& otherwise);
[[nodiscard]] glm::dvec3 vector_in(const Json& object, const char* key,
                                   const glm::dvec3& otherwise);

/// A member that is a list; an empty one where it is not there.
[[nodiscard]] const Json& list_in(const Json& object, const char* key);
/// A member that is an object; an empty one where it is not there.
[[nodiscard]] const Json& object_in(const Json& object, const char* key);
/// object["extensions"][name]; nothing where it is not there.
[[nodiscard]] const Json* extension_of(const Json& object, const char* name);

} // namespace gltf
} // namespace lightcuts

// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/models/gltf/gltf_values.h>

#include <cmath>

#include <fmt/format.h>

namespace lightcuts::gltf {
namespace {

[[noreturn]] void refuse_type(const char* name, const char* expected) {
  throw GltfFault(fmt::format("'{}' is not {}", name, expected));
}

double number(const Json& value, const char* name) {
  if (!value.is_number()) refuse_type(name, "a number");
  return value.get<double>();
}

template <class Vector>
Vector vector(const Json& object, const char* key, const Vector& otherwise) {
  if (!object.contains(key)) return otherwise;
  const Json& list = object.at(key);
  if (!list.is_array() || list.size() < std::size_t(Vector::length()))
    throw GltfFault(fmt::format("'{}' is not a list of {} numbers", key, Vector::length()));
  Vector result(0);
  for (int i = 0; i < Vector::length(); ++i) result[i] = number(list[std::size_t(i)], key);
  return result;
}

const Json& member(const Json& object, const char* key, const Json& otherwise, const char* kind) {
  if (!object.contains(key)) return otherwise;
  const Json& value = object.at(key);
  if (value.type() != otherwise.type()) refuse_type(key, kind);
  return value;
}

} // namespace

std::size_t whole(const Json& value, const char* name) {
  constexpr double most = 0x1p53;
  const double x = number(value, name);
  if (!(x >= 0 && x <= most) || x != std::floor(x)) refuse_type(name, "a whole number");
  return static_cast<std::size_t>(x);
}

std::size_t whole_in(const Json& object, const char* key) {
  if (!object.contains(key)) throw GltfFault(fmt::format("'{}' is missing", key));
  return whole(object.at(key), key);
}

std::size_t whole_in(const Json& object, const char* key, std::size_t otherwise) {
  return object.contains(key) ? whole(object.at(key), key) : otherwise;
}

std::optional<std::size_t> index_in(const Json& object, const char* key) {
  if (!object.contains(key)) return std::nullopt;
  return whole(object.at(key), key);
}

double number_in(const Json& object, const char* key, double otherwise) {
  return object.contains(key) ? number(object.at(key), key) : otherwise;
}

std::string text_in(const Json& object, const char* key, const std::string& otherwise) {
  if (!object.contains(key)) return otherwise;
  if (!object.at(key).is_string()) refuse_type(key, "a text");
  return object.at(key).get<std::string>();
}

bool truth_in(const Json& object, const char* key, bool otherwise) {
  if (!object.contains(key)) return otherwise;
  if (!object.at(key).is_boolean()) refuse_type(key, "true or false");
  return object.at(key).get<bool>();
}

glm::dvec2 vector_in(const Json& object, const char* key, const glm::dvec2& otherwise) {
  return vector(object, key, otherwise);
}

glm::dvec3 vector_in(const Json& object, const char* key, const glm::dvec3& otherwise) {
  return vector(object, key, otherwise);
}

const Json& list_in(const Json& object, const char* key) {
  static const Json empty = Json::array();
  return member(object, key, empty, "a list");
}

const Json& object_in(const Json& object, const char* key) {
  static const Json empty = Json::object();
  return member(object, key, empty, "an object");
}

const Json* extension_of(const Json& object, const char* name) {
  const Json& extensions = object_in(object, "extensions");
  return extensions.contains(name) ? &object_in(extensions, name) : nullptr;
}

} // namespace lightcuts::gltf

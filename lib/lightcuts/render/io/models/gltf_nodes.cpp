// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/models/gltf_nodes.h>

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <string>
#include <system_error>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <nlohmann/json.hpp>

#include <lightcuts/render/files/text.h>
#include <lightcuts/render/io/json/json_text.h>

namespace lightcuts {
namespace {

using nlohmann::json;

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i)
    word |= std::uint32_t{static_cast<unsigned char>(bytes[at + i])} << (8 * i);
  return word;
}

/// The JSON chunk of a binary glTF: 12 bytes of header, length, type, text.
std::string json_chunk(const std::string& file, const std::string& bytes) {
  if (bytes.size() < 20 || bytes.compare(0, 4, "glTF") != 0)
    throw InputError(InputFault::malformed_file, fmt::format("{}: not a binary glTF file", file));
  const std::size_t total = word_at(bytes, 8), length = word_at(bytes, 12);
  if (total > bytes.size() || length > bytes.size() - 20)
    throw InputError(InputFault::malformed_file,
                     fmt::format("{}: truncated: {} bytes of {}", file, bytes.size(),
                                 std::max(total, length + 20)));
  return bytes.substr(20, length);
}

glm::dvec3 vector_of(const json& node, const char* key, const glm::dvec3& otherwise) {
  if (!node.contains(key)) return otherwise;
  const json& v = node.at(key);
  return {v.at(0).get<double>(), v.at(1).get<double>(), v.at(2).get<double>()};
}

glm::dmat4 transform_of(const json& node) {
  glm::dmat4 m(1);
  if (node.contains("matrix")) {
    for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = node.at("matrix").at(i).get<double>();
    return m;
  }
  glm::dquat rotation(1, 0, 0, 0);
  if (node.contains("rotation")) {
    const json& q = node.at("rotation"); // x, y, z, w
    rotation = glm::dquat(q.at(3).get<double>(), q.at(0).get<double>(), q.at(1).get<double>(),
                          q.at(2).get<double>());
  }
  m = glm::mat4_cast(glm::normalize(rotation));
  const glm::dvec3 scale = vector_of(node, "scale", glm::dvec3(1));
  for (int axis = 0; axis < 3; ++axis) m[axis] *= scale[axis];
  m[3] = glm::dvec4(vector_of(node, "translation", glm::dvec3(0)), 1);
  return m;
}

std::optional<LightKind> kind_of(const std::string& type) {
  if (type == "point") return LightKind::omni;
  if (type == "spot") return LightKind::spot;
  if (type == "directional") return LightKind::directional;
  return std::nullopt;
}

class Walker {
public:
  Walker(std::string file, const json& gltf)
      : file_(std::move(file)), gltf_(gltf),
        nodes_(gltf.contains("nodes") ? gltf.at("nodes") : json::array()),
        seen_(nodes_.size(), false) {}

  GltfNodes walk() {
    if (gltf_.contains("scenes") && !gltf_.at("scenes").empty()) {
      const json& scene = gltf_.at("scenes").at(gltf_.value("scene", std::size_t{0}));
      if (scene.contains("nodes"))
        for (const json& node : scene.at("nodes")) visit(node.get<std::size_t>(), glm::dmat4(1), 0);
    }
    return found_;
  }

private:
  static constexpr int deepest = 1000; // Assimp recurses as well

  void visit(std::size_t index, const glm::dmat4& parent, int depth) {
    const json& node = nodes_.at(index);
    if (seen_[index])
      throw InputError(InputFault::malformed_file,
                       fmt::format("{}: node {} has more than one parent", file_, index));
    if (depth > deepest)
      throw InputError(InputFault::too_large,
                       fmt::format("{}: nodes are nested too deeply", file_));
    seen_[index] = true;
    const glm::dmat4 world = parent * transform_of(node);
    if (node.contains("camera"))
      add_camera(gltf_.at("cameras").at(node.at("camera").get<std::size_t>()), world);
    if (node.contains("extensions") && node.at("extensions").contains("KHR_lights_punctual"))
      add_light(node.at("extensions").at("KHR_lights_punctual").at("light").get<std::size_t>(),
                world);
    if (node.contains("children"))
      for (const json& child : node.at("children"))
        visit(child.get<std::size_t>(), world, depth + 1);
  }

  void add_camera(const json& camera, const glm::dmat4& world) {
    if (camera.at("type").get<std::string>() != "perspective") {
      ++found_.orthographic;
      return;
    }
    if (found_.camera) return;
    const glm::dvec3 position(world[3]);
    const double yfov = camera.at("perspective").at("yfov").get<double>();
    // A glTF camera looks along its -z.
    found_.camera =
        Camera{glm::vec3(position), glm::vec3(position - glm::dvec3(world[2])),
               glm::vec3(glm::dvec3(world[1])), static_cast<float>(yfov * 180 / std::numbers::pi)};
  }

  void add_light(std::size_t index, const glm::dmat4& world) {
    const json& light = gltf_.at("extensions").at("KHR_lights_punctual").at("lights").at(index);
    const auto kind = kind_of(light.at("type").get<std::string>());
    if (!kind) return;
    GltfLight found{.kind = *kind};
    found.position = glm::vec3(glm::dvec3(world[3]));
    found.intensity =
        glm::vec3(light.value("intensity", 1.0) * vector_of(light, "color", glm::dvec3(1)));
    // Lights, too, shine along their -z.
    if (*kind != LightKind::omni)
      found.direction = glm::vec3(glm::normalize(-glm::dvec3(world[2])));
    if (*kind == LightKind::spot) {
      const json& spot = light.at("spot");
      found.inner_angle = static_cast<float>(spot.value("innerConeAngle", 0.0));
      found.outer_angle = static_cast<float>(spot.value("outerConeAngle", 0.25 * std::numbers::pi));
    }
    found_.lights.push_back(found);
  }

  std::string file_;
  const json& gltf_;
  json nodes_;
  std::vector<bool> seen_;
  GltfNodes found_;
};

/// Assimp 5.2 leaks the file's handle where a buffer's file is too short.
void check_buffers(const std::filesystem::path& file, const json& gltf) {
  if (!gltf.contains("buffers")) return;
  for (const json& buffer : gltf.at("buffers")) {
    const auto uri = buffer.value("uri", std::string());
    if (uri.empty() || uri.rfind("data:", 0) == 0 || uri.find('%') != std::string::npos) continue;
    const auto expected = buffer.at("byteLength").get<std::uintmax_t>();
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(file.parent_path() / uri, error);
    if (error)
      throw InputError(InputFault::unreadable_file,
                       fmt::format("{}: cannot open its buffer '{}'", file.string(), uri));
    if (size < expected)
      throw InputError(InputFault::malformed_file,
                       fmt::format("{}: its buffer '{}' is truncated: {} bytes of {}",
                                   file.string(), uri, size, expected));
  }
}

} // namespace

GltfNodes read_gltf_nodes(const std::filesystem::path& file) {
  const std::string bytes = read_file(file);
  const bool binary = lower_extension(file) == ".glb";
  const json gltf = parse_json(file.string(), binary ? json_chunk(file.string(), bytes) : bytes);
  try {
    if (gltf.at("asset").at("version").get<std::string>().rfind("2.", 0) != 0)
      throw InputError(InputFault::unsupported, fmt::format("{}: not glTF 2.0", file.string()));
    check_buffers(file, gltf);
    return Walker(file.string(), gltf).walk();
  } catch (const json::exception& error) {
    throw InputError(InputFault::malformed_file,
                     fmt::format("{}: not glTF 2.0: {}", file.string(), plain_message(error)));
  }
}

} // namespace lightcuts

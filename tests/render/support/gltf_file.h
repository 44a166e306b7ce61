// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <string>

#include <nlohmann/json.hpp>

namespace lightcuts::test {

inline std::string base64(const std::string& bytes) {
  const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t triple = 0;
    for (std::size_t k = 0; k < 3; ++k)
      triple = triple << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : digits[triple >> (18 - 6 * k) & 63];
  }
  return text;
}

/// One triangle: three positions, three normals, three 16-bit indices, two bytes of padding.
inline std::string buffer() {
  const std::array<float, 18> floats{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1};
  const std::array<std::uint16_t, 4> indices{0, 1, 2, 0};
  std::string bytes(80, '\0');
  std::memcpy(bytes.data(), floats.data(), 72);
  std::memcpy(bytes.data() + 72, indices.data(), 8);
  return bytes;
}

/// A triangle under two nodes; a camera under the first; point light 0 at two nodes of the same
/// name, a directional and a spot light.
inline nlohmann::json gltf(const std::string& bytes = buffer()) {
  nlohmann::json gltf = nlohmann::json::parse(R"({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 4, 5, 6]}],
    "extensionsUsed": ["KHR_lights_punctual"],
    "extensions": {"KHR_lights_punctual": {"lights": [
      {"type": "point", "color": [1, 0.5, 0.25], "intensity": 8},
      {"type": "directional"},
      {"type": "spot", "spot": {"outerConeAngle": 0.5}}]}},
    "nodes": [
      {"translation": [1, 2, 3], "children": [1, 2, 3]},
      {"mesh": 0, "scale": [2, 2, 2], "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476]},
      {"camera": 0, "translation": [0, 0, 5], "name": "twin"},
      {"translation": [3, 4, 5], "name": "twin",
       "extensions": {"KHR_lights_punctual": {"light": 0}}},
      {"matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, -1,0,0,1], "name": "twin",
       "extensions": {"KHR_lights_punctual": {"light": 0}}},
      {"extensions": {"KHR_lights_punctual": {"light": 1}}},
      {"extensions": {"KHR_lights_punctual": {"light": 2}}}],
    "cameras": [{"type": "perspective",
                 "perspective": {"yfov": 0.7, "aspectRatio": 1.5, "znear": 0.1}}],
    "materials": [{"name": "paint", "emissiveFactor": [0.1, 0.2, 0.3],
      "pbrMetallicRoughness": {"baseColorFactor": [0.8, 0.6, 0.4, 1], "metallicFactor": 0.25,
                               "roughnessFactor": 0.5}}],
    "meshes": [{"name": "shape", "primitives": [
      {"attributes": {"POSITION": 0, "NORMAL": 1}, "indices": 2, "material": 0}]}],
    "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36},
                    {"buffer": 0, "byteOffset": 36, "byteLength": 36},
                    {"buffer": 0, "byteOffset": 72, "byteLength": 6}],
    "accessors": [
      {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
       "min": [0, 0, 0], "max": [1, 1, 0]},
      {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC3"},
      {"bufferView": 2, "componentType": 5123, "count": 3, "type": "SCALAR"}]})");
  gltf["buffers"] = {{{"uri", "data:application/octet-stream;base64," + base64(bytes)},
                      {"byteLength", bytes.size()}}};
  return gltf;
}

inline std::string little_endian(std::size_t word) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(word >> (8 * i) & 255);
  return bytes;
}

/// A binary glTF with that buffer.
inline std::string glb(nlohmann::json gltf, const std::string& bytes = buffer()) {
  gltf["buffers"] = {{{"byteLength", bytes.size()}}};
  std::string text = gltf.dump();
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::string chunks = little_endian(text.size()) + "JSON" + text +
                             little_endian(bytes.size()) + std::string("BIN\0", 4) + bytes;
  return "glTF" + little_endian(2) + little_endian(12 + chunks.size()) + chunks;
}

/// A square, (0, 0, 0) to (1, 1, 0), that looks along +z: four positions, four texture coordinates
/// (v = 0 at the top, y = 1), six 16-bit indices.
inline std::string square_buffer() {
  const std::array<float, 20> floats{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 1, 1, 1, 1, 0, 0, 0};
  const std::array<std::uint16_t, 6> indices{0, 1, 2, 0, 2, 3};
  std::string bytes(92, '\0');
  std::memcpy(bytes.data(), floats.data(), 80);
  std::memcpy(bytes.data() + 80, indices.data(), 12);
  return bytes;
}

/// The square with a base colour of (0.8, 0.6, 0.4) times a texture, seen from the front by a
/// camera whose square image it just fills.
inline nlohmann::json textured_square(const nlohmann::json& image,
                                      const std::string& bytes = square_buffer()) {
  nlohmann::json gltf = nlohmann::json::parse(R"({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
    "nodes": [{"mesh": 0}, {"camera": 0, "translation": [0.5, 0.5, 1]}],
    "cameras": [{"type": "perspective", "perspective": {"yfov": 0.92729522, "znear": 0.1}}],
    "textures": [{"source": 0}],
    "materials": [{"name": "paint", "pbrMetallicRoughness": {"baseColorTexture": {"index": 0},
      "baseColorFactor": [0.8, 0.6, 0.4, 1], "metallicFactor": 0.25, "roughnessFactor": 0.5}}],
    "meshes": [{"name": "square", "primitives": [
      {"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}],
    "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48},
                    {"buffer": 0, "byteOffset": 48, "byteLength": 32},
                    {"buffer": 0, "byteOffset": 80, "byteLength": 12}],
    "accessors": [
      {"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3",
       "min": [0, 0, 0], "max": [1, 1, 0]},
      {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
      {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"}]})");
  gltf["images"] = {image};
  gltf["buffers"] = {{{"uri", "data:application/octet-stream;base64," + base64(bytes)},
                      {"byteLength", bytes.size()}}};
  return gltf;
}

} // namespace lightcuts::test

// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/models/gltf/gltf_extensions.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>

#include <lightcuts/render/files/text.h>

namespace lightcuts {
namespace {

constexpr std::array<std::string_view, 11> supported{
    "KHR_lights_punctual",   "KHR_materials_emissive_strength",
    "KHR_materials_ior",     "KHR_materials_pbrSpecularGlossiness",
    "KHR_mesh_quantization", "KHR_node_visibility",
    "KHR_texture_transform", "EXT_mesh_gpu_instancing",
    "EXT_lights_ies",        "EXT_texture_webp",
    "KHR_materials_variants"}; // the default one

/// Without them all looks the same: data about the file, animations, and compressed copies of what
/// is there plainly as well.
constexpr std::array<std::string_view, 12> harmless{"KHR_xmp",
                                                    "KHR_xmp_json_ld",
                                                    "KHR_animation_pointer",
                                                    "KHR_interactivity",
                                                    "KHR_node_selectability",
                                                    "KHR_node_hoverability",
                                                    "KHR_texture_basisu",
                                                    "KHR_draco_mesh_compression",
                                                    "EXT_meshopt_compression",
                                                    "KHR_meshopt_compression",
                                                    "EXT_texture_avif",
                                                    "MSFT_texture_dds"};

template <class List>
bool has(const List& list, const std::string& name) {
  return std::ranges::find(list, name) != list.end();
}

std::string text_of(const gltf::Json& name) {
  if (!name.is_string()) throw GltfFault("an extension's name is not a text");
  return one_line(name.get<std::string>());
}

/// The names in every "extensions" object below.
void collect(const gltf::Json& json, int depth, std::set<std::string>& names) {
  constexpr int deepest = 32; // no object of glTF's is deeper
  if (!json.is_structured() || depth > deepest) return;
  // Lists of numbers have none, and can be long.
  if (json.is_array() && !json.empty() && !json.front().is_structured()) return;
  if (json.is_object() && json.contains("extensions") && json.at("extensions").is_object())
    for (const auto& [name, value] : json.at("extensions").items()) names.insert(one_line(name));
  for (const gltf::Json& part : json) collect(part, depth + 1, names);
}

} // namespace

void check_extensions(const GltfFile& file, std::vector<std::string>& notes) {
  std::vector<std::string> refused;
  for (const gltf::Json& required : gltf::list_in(file.root(), "extensionsRequired"))
    if (const std::string name = text_of(required); !has(supported, name)) refused.push_back(name);
  if (!refused.empty())
    throw InputError(InputFault::unsupported,
                     fmt::format("{}: requires {}, which is not supported", file.path().string(),
                                 fmt::join(refused, ", ")));
  std::set<std::string> used;
  for (const gltf::Json& name : gltf::list_in(file.root(), "extensionsUsed"))
    used.insert(text_of(name));
  collect(file.root(), 0, used);
  for (const std::string& name : used)
    if (!has(supported, name) && !has(harmless, name))
      notes.push_back(fmt::format("{}: extension {} left out", file.path().string(), name));
}

} // namespace lightcuts

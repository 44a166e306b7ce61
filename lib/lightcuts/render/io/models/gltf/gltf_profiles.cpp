// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/models/gltf/gltf_profiles.h>

#include <utility>

#include <fmt/format.h>

namespace lightcuts {

IesLuminaire GltfProfiles::read(std::size_t index) const {
  const gltf::Json* extension = gltf::extension_of(file_.root(), "EXT_lights_ies");
  if (!extension) throw GltfFault("'EXT_lights_ies' is missing");
  const gltf::Json& profiles = gltf::list_in(*extension, "lights");
  if (index >= profiles.size())
    throw GltfFault(fmt::format("light profile {} is not there", index));
  const gltf::Json& profile = profiles[index];
  const std::string name = fmt::format("{}: light profile {}", file_.path().string(), index);
  if (const std::string uri = gltf::text_in(profile, "uri", ""); !uri.empty())
    return read_ies(is_data_uri(uri) ? name : (file_.path().parent_path() / uri).string(),
                    file_.bytes_of(uri, "light profile", access_));
  const auto view = gltf::index_in(profile, "bufferView");
  if (!view) throw GltfFault(fmt::format("light profile {} has no 'uri' or 'bufferView'", index));
  return read_ies(name, file_.view(*view));
}

const IesLuminaire& GltfProfiles::luminaire(std::size_t index) {
  if (const auto known = read_.find(index); known != read_.end()) return known->second;
  try {
    const IesLuminaire& fresh = read_[index] = read(index);
    notes_.insert(notes_.end(), fresh.notes.begin(), fresh.notes.end());
    return fresh;
  } catch (const InputError& error) {
    throw LuminaireError(error.fault(), error.what());
  }
}

} // namespace lightcuts

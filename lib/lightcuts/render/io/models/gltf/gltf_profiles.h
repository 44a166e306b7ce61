// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include <lightcuts/core/input_error.h>
#include <lightcuts/render/files/file_access.h>
#include <lightcuts/render/io/ies/ies_file.h>
#include <lightcuts/render/io/models/gltf/gltf_file.h>

namespace lightcuts {

/// What is wrong with a light profile: the message begins with its own name.
struct LuminaireError : InputError {
  using InputError::InputError;
};

/// The light profiles of a glTF file (EXT_lights_ies): files beside it, data URIs, or bufferViews.
/// Each is read once.
class GltfProfiles {
public:
  GltfProfiles(const GltfFile& file, const FileAccess& access, std::vector<std::string>& notes)
      : file_(file), access_(access), notes_(notes) {}

  /// Throws LuminaireError where it cannot be read or is broken, GltfFault where it is not there.
  [[nodiscard]] const IesLuminaire& luminaire(std::size_t index);

private:
  [[nodiscard]] IesLuminaire read(std::size_t index) const;

  const GltfFile& file_;
  const FileAccess& access_;
  std::vector<std::string>& notes_;
  std::map<std::size_t, IesLuminaire> read_;
};

} // namespace lightcuts

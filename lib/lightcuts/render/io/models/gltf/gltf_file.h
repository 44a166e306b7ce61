// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <lightcuts/render/files/file_access.h>
#include <lightcuts/render/io/models/gltf/gltf_values.h>

namespace lightcuts {

/// A glTF 2.0 file: its JSON, and the bytes of its buffers.
class GltfFile {
public:
  /// Reads a `.gltf` or `.glb` and the files of its buffers. Throws InputError with the file's name
  /// where one cannot be read or is truncated, and where the file is not glTF 2.0; GltfFault where
  /// a value is of the wrong type.
  GltfFile(const std::filesystem::path& file, const FileAccess& access);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] const gltf::Json& root() const { return root_; }

  /// An element of a list at the top, such as "meshes". Throws GltfFault where it is not there.
  [[nodiscard]] const gltf::Json& item(const char* list, std::size_t index) const;
  /// Its "name", or "KIND INDEX".
  [[nodiscard]] std::string name_of(const char* list, const char* kind, std::size_t index) const;

  /// The bytes of a bufferView. Throws GltfFault where it is not within its buffer.
  [[nodiscard]] std::string_view view(std::size_t index) const;

  /// What a "data:" URI has, or a file beside this one. `what` it is, for messages. Throws
  /// InputError where it cannot be read.
  [[nodiscard]] std::string bytes_of(const std::string& uri, const char* what,
                                     const FileAccess& access) const;

private:
  void read_buffers(const FileAccess& access, std::string chunk);

  std::filesystem::path path_;
  gltf::Json root_;
  std::vector<std::string> buffers_;
};

/// A "data:" URI: what it says that it is ("image/png"), and its bytes.
struct DataUri {
  std::string type, bytes;
};

[[nodiscard]] inline bool is_data_uri(std::string_view uri) { return uri.starts_with("data:"); }

/// Throws GltfFault where it is not one in base64.
[[nodiscard]] DataUri read_data_uri(std::string_view uri);

} // namespace lightcuts

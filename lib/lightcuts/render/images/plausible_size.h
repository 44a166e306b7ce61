// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>
#include <lightcuts/render/images/image_codec.h>

namespace lightcuts {

/// Refuses an image of more than 64 MiB whose file cannot hold it, before the memory for it is
/// asked for: no compression of these formats beats deflate's 1032 to 1 (its longest match, 258
/// bytes, in 2 bits), but OpenEXR's lossy DWA, which deflates one number for 64. Throws InputError
/// without the file's name.
inline void require_plausible_size(const ImageInfo& info, std::uintmax_t file_bytes) {
  constexpr std::uintmax_t small = 64UL << 20, most_packed = 1032;
  constexpr std::array<std::string_view, 9> known{"png",  "jpeg", "jpg",   "openexr", "exr",
                                                  "tiff", "hdr",  "targa", "bmp"};
  const std::uintmax_t needed = info.stored_bytes;
  bool is_known = false;
  for (const std::string_view name : known) is_known = is_known || name == info.format;
  const auto compression = info.attributes.find("compression");
  const bool lossy = compression != info.attributes.end() && compression->second.starts_with("dwa");
  if (!is_known || needed <= small || needed / (most_packed * (lossy ? 64 : 1)) <= file_bytes)
    return;
  throw InputError(InputFault::malformed_file, fmt::format("truncated: {} x {} pixels in {} bytes",
                                                           info.width, info.height, file_bytes));
}

} // namespace lightcuts

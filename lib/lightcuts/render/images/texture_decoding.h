// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

#include <lightcuts/render/scene/texture.h>

namespace lightcuts {

/// Decodes an image file in memory. `name` is its name, whose extension says what kind it is where
/// the bytes do not begin like a PNG or a JPEG. Integers are taken as sRGB, whatever the file says
/// of its colours, and decoded with the piecewise formula of IEC 61966-2-1; floats (EXR, HDR) are
/// linear. Grey counts for all three components; alpha does nothing, and pixels are not multiplied
/// by it. Throws InputError, saying why but not of which file, where the bytes are no image, are
/// truncated, or the image is larger than Texture allows.
[[nodiscard]] Texture decode_texture(std::string_view bytes, const std::string& name);

} // namespace lightcuts

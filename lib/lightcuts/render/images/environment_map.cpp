// SPDX-License-Identifier: MIT
#include <lightcuts/render/images/environment_map.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>
#include <lightcuts/core/input_error.h>
#include <lightcuts/render/scene/scene.h>

#include <lightcuts/render/files/text.h>
#include <lightcuts/render/images/image_file.h>
#include <lightcuts/render/images/plausible_size.h>

namespace lightcuts {
namespace {

[[noreturn]] void refuse(InputFault fault, const std::string& file, const std::string& why) {
  throw InputError(fault, one_line(fmt::format("{}: {}", file, why)));
}

void check(const std::string& file, const OIIO::ImageSpec& spec) {
  const auto side = static_cast<int>(max_image_side);
  if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.nchannels < 1 ||
      spec.width > side || spec.height > side)
    refuse(InputFault::out_of_domain, file,
           fmt::format("{} x {} pixels, expected 1 to {} each", spec.width, spec.height,
                       max_image_side));
  if (spec.x != spec.full_x || spec.y != spec.full_y || spec.width != spec.full_width ||
      spec.height != spec.full_height)
    refuse(InputFault::unsupported, file,
           "is cropped: an environment map has to cover all directions");
}

/// As Texture does; how many had to be changed.
std::size_t clamp(std::vector<glm::vec3>& pixels) {
  constexpr float largest_float = std::numeric_limits<float>::max();
  std::size_t changed = 0;
  for (glm::vec3& pixel : pixels) {
    glm::vec3 kept(0);
    for (int c = 0; c < 3; ++c)
      if (pixel[c] > 0) kept[c] = std::min(pixel[c], largest_float);
    if (pixel == kept) continue; // NaN differs
    pixel = kept;
    ++changed;
  }
  return changed;
}

} // namespace

EnvironmentMap read_environment(const std::filesystem::path& file) {
  std::error_code error; // a pipe may never end, nor a device
  if (std::filesystem::exists(file, error) && !std::filesystem::is_regular_file(file, error))
    refuse(InputFault::unreadable_file, file.string(), "cannot open: not a file");
  const auto input = OIIO::ImageInput::open(file.string());
  if (!input) refuse(opening_fault(file), file.string(), OIIO::geterror());
  const OIIO::ImageSpec spec = input->spec();
  check(file.string(), spec);
  try {
    require_plausible_size(spec, std::filesystem::file_size(file, error), input->format_name());
  } catch (const InputError& fault) {
    refuse(fault.fault(), file.string(), fault.what());
  }
  const auto stride = static_cast<std::size_t>(spec.nchannels);
  std::vector<float> values(spec.image_pixels() * stride);
  if (!input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data()))
    refuse(InputFault::malformed_file, file.string(), input->geterror());

  EnvironmentMap map;
  map.name = file.string();
  map.size = {spec.width, spec.height};
  map.radiance.resize(spec.image_pixels());
  for (std::size_t i = 0; i < map.radiance.size(); ++i)
    for (int c = 0; c < 3; ++c) map.radiance[i][c] = values[i * stride + (stride < 3 ? 0 : c)];
  if (const std::size_t clamped = clamp(map.radiance); clamped > 0)
    map.notes.push_back(
        fmt::format("{}: {} negative or not finite: clamped", map.name, counted(clamped, "pixel")));
  if (!spec.format.is_floating_point())
    map.notes.push_back(fmt::format("{}: integer pixels taken as linear, 0 to 1", map.name));
  validate(map);
  return map;
}

void validate(const EnvironmentMap& map) {
  if (map.radiance.empty() || map.radiance.size() != std::size_t{map.size.x} * map.size.y)
    refuse(InputFault::inconsistent, map.name,
           fmt::format("{} pixels for {} x {}", map.radiance.size(), map.size.x, map.size.y));
  for (std::size_t i = 0; i < map.radiance.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const float value = map.radiance[i][c];
      if (std::isfinite(value) && value >= 0) continue;
      refuse(fault_of(value), map.name,
             fmt::format("pixel ({}, {}): {} is {}, {}", i % map.size.x, i / map.size.x, "rgb"[c],
                         value, std::isfinite(value) ? "negative" : "not a finite number"));
    }
}

} // namespace lightcuts

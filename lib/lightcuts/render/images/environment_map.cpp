// SPDX-License-Identifier: MIT
#include <lightcuts/render/images/environment_map.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>
#include <lightcuts/render/scene/scene.h>

#include <lightcuts/render/files/text.h>
#include <lightcuts/render/images/image_codec.h>
#include <lightcuts/render/images/image_file.h>
#include <lightcuts/render/images/plausible_size.h>

namespace lightcuts {
namespace {

[[noreturn]] void refuse(InputFault fault, const std::string& file, const std::string& why) {
  throw InputError(fault, one_line(fmt::format("{}: {}", file, why)));
}

void check(const std::string& file, const ImageInfo& info) {
  const auto side = static_cast<int>(max_image_side);
  if (info.width < 1 || info.height < 1 || info.depth > 1 || info.channels.empty() ||
      info.width > side || info.height > side)
    refuse(InputFault::out_of_domain, file,
           fmt::format("{} x {} pixels, expected 1 to {} each", info.width, info.height,
                       max_image_side));
  if (info.cropped)
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
  const OpenedImage opened = image_codec().open(file.string());
  if (!opened.reader) refuse(opening_fault(file), file.string(), opened.failure.why);
  const ImageInfo& info = opened.reader->info();
  check(file.string(), info);
  try {
    require_plausible_size(info, std::filesystem::file_size(file, error));
  } catch (const InputError& fault) {
    refuse(fault.fault(), file.string(), fault.what());
  }
  const std::size_t stride = info.channels.size();
  std::vector<float> values(info.pixel_count() * stride);
  if (const auto failure =
          opened.reader->read(static_cast<int>(stride), SampleType::float32, values.data()))
    refuse(failure->fault, file.string(), failure->why);

  EnvironmentMap map;
  map.name = file.string();
  map.size = {info.width, info.height};
  map.radiance.resize(info.pixel_count());
  for (std::size_t i = 0; i < map.radiance.size(); ++i)
    for (int c = 0; c < 3; ++c) map.radiance[i][c] = values[i * stride + (stride < 3 ? 0 : c)];
  if (const std::size_t clamped = clamp(map.radiance); clamped > 0)
    map.notes.push_back(
        fmt::format("{}: {} negative or not finite: clamped", map.name, counted(clamped, "pixel")));
  if (info.type != SampleType::float32)
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

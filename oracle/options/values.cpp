// SPDX-License-Identifier: MIT
#include <oracle/options/values.h>

#include <charconv>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include <lightcuts/render/scene/scene.h>
#include <oracle/options/count.h>

namespace lightcuts::options {

std::optional<glm::uvec2> parse_pair(const std::string& text, char separator) {
  const std::size_t at = text.find(separator);
  if (at == std::string::npos) return std::nullopt;
  const std::string parts[] = {text.substr(0, at), text.substr(at + 1)};
  for (const std::string& part : parts)
    if (part.empty() || part.size() > 5 || part.find_first_not_of("0123456789") != part.npos)
      return std::nullopt;
  return glm::uvec2(std::stoul(parts[0]), std::stoul(parts[1]));
}

std::optional<glm::uvec2> parse_size(const std::string& text) {
  const auto size = parse_pair(text, 'x');
  const auto fits = [](unsigned side) { return side >= 1 && side <= max_image_side; };
  return size && fits(size->x) && fits(size->y) ? size : std::nullopt;
}

std::string check_size(const std::string& text) {
  if (parse_size(text)) return {};
  return fmt::format("'{}' is not WIDTHxHEIGHT, each from 1 to {} pixels", text, max_image_side);
}

std::optional<CameraRequest> parse_camera(const std::string& text) {
  std::vector<float> values;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (true) {
    float value = 0;
    const auto [rest, error] = std::from_chars(at, end, value);
    if (error != std::errc{} || !std::isfinite(value)) return std::nullopt;
    values.push_back(value);
    if (rest == end) break;
    if (*rest != ',') return std::nullopt;
    at = rest + 1;
  }
  if (values.size() != 6 && values.size() != 7) return std::nullopt;
  CameraRequest camera{{values[0], values[1], values[2]}, {values[3], values[4], values[5]}, {}};
  if (values.size() == 7) camera.vertical_fov = values[6];
  if (camera.position == camera.target) return std::nullopt;
  if (values.size() == 7 && !(values[6] > 0 && values[6] < 180)) return std::nullopt;
  return camera;
}

std::string check_camera(const std::string& text) {
  if (parse_camera(text)) return {};
  return fmt::format("'{}' is not X,Y,Z,TX,TY,TZ[,FOV]: two points that differ, and degrees above "
                     "0 and below 180",
                     text);
}

std::string camera_text(const Camera& camera) {
  const glm::vec3 &p = camera.position, &t = camera.target;
  return fmt::format("{},{},{},{},{},{},{}", p.x, p.y, p.z, t.x, t.y, t.z, camera.vertical_fov);
}

std::optional<float> parse_threshold(const std::string& text) {
  std::size_t used = 0;
  float value = NAN;
  try {
    value = std::stof(text, &used);
  } catch (const std::exception&) {
    return std::nullopt;
  }
  const std::string unit = text.substr(used);
  if (!(unit.empty() || unit == "%") || !(value >= 0) || std::isinf(value)) return std::nullopt;
  return unit == "%" ? static_cast<float>(std::stod(text) / 100) : value;
}

std::string check_threshold(const std::string& text) {
  return text == "auto" || parse_threshold(text)
             ? ""
             : "'" + text + "' is not a threshold such as 2%, 0.02 or auto";
}

std::string check_count(const std::string& text) {
  return parse_count(text) ? ""
                           : "'" + text +
                                 "' is not a whole number above 0 and below 2^64, such as 1000000 "
                                 "or 1e9";
}

std::string check_positive(const std::string& text) {
  const bool digits = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  const bool zero = text.find_first_not_of('0') == std::string::npos;
  return digits && !zero ? "" : "'" + text + "' is not a whole number above 0";
}

std::string check_not_negative(const std::string& text) {
  return text.starts_with('-') ? "'" + text + "' is negative" : "";
}

std::string check_memory(const std::string& text) {
  constexpr std::uint64_t least = std::uint64_t{64} << 20;
  return parse_memory(text).value_or(0) >= least
             ? ""
             : "'" + text + "' is not a size such as 512MiB or 4GiB, 64MiB at least";
}

std::string check_distance(const std::string& text) {
  float distance = 0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, distance);
  const bool whole = error == std::errc() && rest == end;
  return whole && distance > 0 && std::isfinite(distance)
             ? ""
             : "'" + text + "' is not a finite number above 0";
}

} // namespace lightcuts::options

// SPDX-License-Identifier: MIT
#include <oracle/cases/case_text.h>

#include <algorithm>

#include <fmt/format.h>

#include <oracle/cases/case_names.h>

namespace lightcuts::oracle {
namespace {

// Longer cases are counterexamples that could not be shrunk.
constexpr std::size_t most_lines = 40;

std::string text_of(const Lobe& lobe) {
  if (const auto* phong = std::get_if<Phong>(&lobe))
    return fmt::format("Phong, reflectance {}, exponent {:.9g}",
                       oracle::text_of(phong->reflectance), phong->exponent);
  if (const auto* ward = std::get_if<Ward>(&lobe))
    return fmt::format("Ward, reflectance {}, alpha {:.9g}", oracle::text_of(ward->reflectance),
                       ward->alpha);
  if (const auto* cook = std::get_if<CookTorrance>(&lobe))
    return fmt::format("Cook-Torrance, f0 {}, alpha {:.9g}", oracle::text_of(cook->f0),
                       cook->alpha);
  return "none";
}

template <class T, class Line>
std::string lines_of(const std::vector<T>& values, Line&& line) {
  std::string text;
  for (std::size_t i = 0; i < values.size() && i < most_lines; ++i) text += line(i, values[i]);
  if (values.size() > most_lines)
    text += fmt::format("... and {} more\n", values.size() - most_lines);
  return text;
}

} // namespace

std::string text_of(const glm::vec3& v) {
  return fmt::format("({:.9g}, {:.9g}, {:.9g})", v.x, v.y, v.z);
}

std::string wrapped(const std::string& text) {
  std::string result;
  std::size_t column = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(' ', at), text.size());
    if (column > 0 && column + 1 + (end - at) > 100) {
      result += "\n  ";
      column = 2;
    } else if (at > 0) {
      result += " ";
      ++column;
    }
    result += text.substr(at, end - at);
    column += end - at;
    at = end + 1;
  }
  return result + "\n";
}

std::string text_of(const Exact& value, int digits) {
  std::string text = value.str(digits);
  return text.size() <= 25 ? text : value.str(14);
}

std::string text_of(const Light& light) {
  const bool directional = light.kind == LightKind::directional;
  std::string text =
      fmt::format("{} {} {}, intensity {}", name_of(light.kind), directional ? "towards" : "at",
                  text_of(light.position), text_of(light.intensity));
  if ((only(light.kind) & kinds_with_axis) != 0)
    text += fmt::format(", axis {}", text_of(light.axis));
  if (light.kind == LightKind::spot)
    text += fmt::format(", cosines {:.9g} and {:.9g}", light.cos_inner, light.cos_outer);
  return text;
}

std::string text_of(const gen::View& view) {
  return fmt::format("  x          {}\n  n          {}\n  viewer     {}\n  diffuse    {}\n"
                     "  lobe       {}\n",
                     text_of(view.position), text_of(view.normal), text_of(view.to_viewer),
                     text_of(view.material.diffuse), text_of(view.material.lobe));
}

std::string text_of(const CutConfig& cut) {
  return fmt::format("threshold {:.9g}, at most {} cluster{}, black level {:.9g}", cut.threshold,
                     cut.max_size, cut.max_size == 1 ? "" : "s", cut.black_level);
}

std::string text_of(const Case& on) {
  std::string text = lines_of(on.lights, [](std::size_t i, const Light& light) {
    return wrapped(fmt::format("light {}: {}", i, text_of(light)));
  });
  if (on.min_distance > 0) text += fmt::format("least distance {:.9g}\n", on.min_distance);
  text += lines_of(on.views, [](std::size_t i, const CaseView& v) {
    std::string view = fmt::format("view {}\n{}", i, text_of(v.view));
    if (!v.hidden.empty())
      view += fmt::format("  hidden     {} light{}: {}{}\n", v.hidden.size(),
                          v.hidden.size() == 1 ? "" : "s",
                          fmt::join(v.hidden.begin(),
                                    v.hidden.begin() + std::min<std::ptrdiff_t>(
                                                           std::ptrdiff_t(v.hidden.size()), 12),
                                    " "),
                          v.hidden.size() > 12 ? " ..." : "");
    return view;
  });
  text += lines_of(on.triangles, [](std::size_t i, const CaseTriangle& t) {
    return wrapped(fmt::format("triangle {}, mesh {}: {} {} {}", i, t.mesh, text_of(t.corners[0]),
                               text_of(t.corners[1]), text_of(t.corners[2])));
  });
  if (!on.triangles.empty())
    text += wrapped(
        fmt::format("camera at {}, looking at {}, up {}, {:.9g} degrees; {} x {} pixels",
                    text_of(on.camera.position), text_of(on.camera.target), text_of(on.camera.up),
                    on.camera.vertical_fov, on.image_size.x, on.image_size.y));
  return text + fmt::format("cut: {}; seed {}\n", text_of(on.cut), on.seed);
}

} // namespace lightcuts::oracle

// SPDX-License-Identifier: MIT
#include <viz/panels/picture/pixel_text.h>

#include <array>
#include <cmath>

#include <fmt/format.h>
#include <imgui.h>

#include <viz/model/layers/kinds/certified_error.h>
#include <viz/model/layers/kinds/cut_size.h>
#include <viz/model/layers/kinds/error.h>
#include <viz/model/layers/value_text.h>
#include <viz/panels/gui/drawing.h>

namespace lightcuts::viz {
namespace {

/// Of a layer at the pixel, if it is known.
std::optional<float> value_of(Workbench& workbench, Layer layer, glm::uvec2 pixel) {
  const LayerSources sources = workbench.sources(workbench.state.display, layer);
  return layer_value(layer, sources, pixel);
}

std::string line(const char* name, const std::optional<float>& value) {
  return value ? fmt::format("\n{} {}", name, short_text(*value)) : std::string();
}

} // namespace

std::string pixel_text(Workbench& workbench, glm::uvec2 pixel) {
  std::string text = fmt::format("pixel {}, {}", pixel.x, pixel.y);
  const LayerSources sources = workbench.sources(workbench.state.display, layers::image);
  const std::uint32_t source = sources.frame->source_of(pixel);
  if (source == Picture::unknown) return text + "\nnot rendered yet";
  const Rendering& r = sources.frame->rendering();
  const glm::vec3 rgb = r.radiance[source] + r.emission[source];
  const std::uint32_t own = pixel.y * r.size.x + pixel.x;
  if (source != own) text += " (of a neighbour so far)";
  if (r.cut_size[source] == 0) return text + "\nsees no surface";
  text += fmt::format("\nRGB {} {} {}", short_text(rgb.r), short_text(rgb.g), short_text(rgb.b));
  text += line(sources.frame->sums_all_lights() ? "lights, all," : "clusters",
               value_of(workbench, layers::cut_size, pixel));
  text += line("true error", value_of(workbench, layers::error, pixel));
  text += line("certified error", value_of(workbench, layers::certified_error, pixel));
  return text;
}

void draw_value_in_pixel(const ShownPicture& shown, std::size_t i, const glm::dvec2& at,
                         float zoom) {
  const LayerValues& layer = shown.values();
  if (i >= layer.known.size() || layer.known[i] == 0) return;
  std::string text;
  if (!layer.image.empty())
    for (int c = 0; c < 3; ++c) text += (c > 0 ? "\n" : "") + short_text(layer.image[i][c]);
  else if (layer.surface[i] != 0)
    text = short_text(layer.values[i]);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  if (size.x > zoom - 2 || size.y > zoom - 2) return;
  // Black on bright pixels, white on dark ones.
  const Rgb8& c = shown.coloured().pixels[i];
  const bool bright = 2 * c.r + 5 * c.g + c.b > 8 * 128;
  ImGui::GetWindowDrawList()->AddText(
      {float(at.x) - size.x / 2, float(at.y) - size.y / 2},
      bright ? IM_COL32(0, 0, 0, 255) : IM_COL32(255, 255, 255, 255), text.c_str());
}

} // namespace lightcuts::viz

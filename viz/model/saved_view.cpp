// SPDX-License-Identifier: MIT
#include <viz/model/saved_view.h>

#include <limits>

#include <fmt/format.h>
#include <lightcuts/render/files/output_folder.h>
#include <lightcuts/version.h>

#include <viz/model/layers/all_layers.h>

namespace lightcuts::viz {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

void add_image(const LayerValues& layer, Film& film) {
  for (int c = 0; c < 3; ++c) {
    const auto channel = film.channel(std::string(1, "RGB"[c]));
    for (std::size_t i = 0; i < channel.size(); ++i)
      channel[i] = layer.own[i] != 0 ? layer.image[i][c] : nan;
  }
}

void add_values(const char* name, const LayerValues& layer, Film& film) {
  const auto channel = film.channel(name);
  for (std::size_t i = 0; i < channel.size(); ++i)
    channel[i] = layer.own[i] != 0 ? layer.values[i] : nan;
}

bool is_known(Layer layer, const LayerSources& sources) {
  if (const Picture* other = sources.instead_of_frame(layer)) return other->share() > 0;
  return sources.frame->share() > 0 && (!layer.needs_reference() || sources.reference->share() > 0);
}

} // namespace

Film film_of(Workbench& workbench, const LayerValues& shown) {
  Film film(workbench.scene()->scene().image_size);
  const DisplayMethod display = workbench.state.display;
  if (display.is_raster()) {
    film.metadata = {{"scene", workbench.scene()->scene().name},
                     {"method", name_of(display)},
                     {"version", version}};
    add_image(shown, film);
    return film;
  }
  for (const Layer layer : all_layers) {
    const LayerSources sources = workbench.sources(display, layer);
    if (layer.is_image())
      add_image(layer_values(layer, sources), film);
    else if (is_known(layer, sources))
      add_values(layer->name, layer_values(layer, sources), film);
  }
  const LayerSources sources = workbench.sources(display, layers::image);
  film.metadata = {{"scene", workbench.scene()->scene().name},
                   {"method", name_of(display)},
                   {"threshold", fmt::format("{}", sources.frame->cut().threshold)},
                   {"version", version}};
  return film;
}

void save_view(Workbench& workbench, const Coloured& shown, const LayerValues& values,
               const std::filesystem::path& folder, const std::string& name) {
  OutputFolder output(folder);
  write_png(output.stage(name + ".png"), shown.size, shown.pixels);
  write_exr(film_of(workbench, values), output.stage(name + ".exr"));
  write_file_atomically(output.stage(name + ".json"), view_state_json(workbench.state));
  output.commit();
}

} // namespace lightcuts::viz

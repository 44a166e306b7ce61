// SPDX-License-Identifier: MIT
#include <oracle/report/plots/pictures.h>

#include <algorithm>

#include <fmt/format.h>

#include <lightcuts/render/images/colour_map.h>
#include <lightcuts/version.h>
#include <oracle/report/image_error.h>

namespace lightcuts::oracle {
namespace {

void add_rgb(Film& film, const std::string& prefix, const Rendering& r) {
  for (int c = 0; c < 3; ++c) {
    const auto channel = film.channel(prefix + "RGB"[c]);
    for (std::size_t i = 0; i < channel.size(); ++i)
      channel[i] = r.radiance[i][c] + r.emission[i][c];
  }
}

void add_group(Film& film, const GroupPicture& group) {
  const std::string prefix = "group." + group.name + ".";
  const auto bound = film.channel(prefix + "bound");
  for (std::size_t i = 0; i < bound.size(); ++i)
    bound[i] = static_cast<float>(channel_sum(group.rendering.certified_error[i]));
  for (int c = 0; c < 3; ++c) {
    const auto channel = film.channel(prefix + "RGB"[c]);
    for (std::size_t i = 0; i < channel.size(); ++i) channel[i] = group.rendering.radiance[i][c];
  }
}

void add_values(Film& film, const char* name, const std::vector<float>& values) {
  std::copy(values.begin(), values.end(), film.channel(name).begin());
}

void add_errors(Film& film, const Rendering& r, const Rendering& reference) {
  const auto bound = film.channel("cut.bound");
  const auto error = film.channel("cut.error");
  const auto slack = film.channel("cut.slack");
  for (std::size_t i = 0; i < error.size(); ++i) {
    const glm::dvec3 difference = glm::dvec3(r.radiance[i]) - glm::dvec3(reference.radiance[i]);
    error[i] = static_cast<float>(channel_sum(glm::abs(difference)));
    slack[i] = error[i] > 0 ? bound[i] / error[i] : 0;
  }
}

std::vector<glm::vec3> picture_of(const Rendering& r) {
  std::vector<glm::vec3> picture = r.radiance;
  for (std::size_t i = 0; i < picture.size(); ++i) picture[i] += r.emission[i];
  return picture;
}

float largest_of(const std::vector<float>& values) {
  return values.empty() ? 1 : std::max(1e-30F, *std::max_element(values.begin(), values.end()));
}

} // namespace

Film film_of(const PictureSource& source) {
  Film film(source.rendering.size);
  film.metadata = {{"scene", source.scene},
                   {"seed", std::to_string(source.seed)},
                   {"threshold", fmt::format("{}", source.threshold)},
                   {"version", version}};
  add_rgb(film, "", source.rendering);
  if (source.reference != nullptr) add_rgb(film, "reference.", *source.reference);
  for (const GroupPicture& group : source.groups) add_group(film, group);
  add_values(film, "cut.size", source.rendering.cut_size);
  const auto bound = film.channel("cut.bound");
  for (std::size_t i = 0; i < bound.size(); ++i)
    bound[i] = static_cast<float>(channel_sum(source.rendering.certified_error[i]));
  if (source.reference != nullptr) add_errors(film, source.rendering, *source.reference);
  add_values(film, "rays.shadow", source.rendering.shadow_rays);
  add_values(film, "time.us", source.rendering.microseconds);
  return film;
}

std::vector<std::pair<std::string, std::string>> write_pictures(const PictureSource& source,
                                                                OutputFolder& folder) {
  const Rendering& r = source.rendering;
  std::vector<std::pair<std::string, std::string>> pictures;
  const auto add = [&](const std::string& caption, const std::string& name) {
    pictures.emplace_back(caption, name);
    return folder.stage(name);
  };
  write_exr(film_of(source), folder.stage("image.exr"));
  const float exposure =
      automatic_exposure(picture_of(source.reference != nullptr ? *source.reference : r));
  write_png(add("Picture", "image.png"), r.size, picture_of(r), exposure);
  if (source.reference != nullptr)
    write_png(add("Reference: every light on its own", "reference.png"), r.size,
              picture_of(*source.reference), exposure);
  write_heat_map(add("Lights evaluated per pixel (cut size)", "cut-size.png"), r.size, r.cut_size,
                 {0, largest_of(r.cut_size), false});
  write_heat_map(add("Shadow rays per pixel", "shadow-rays.png"), r.size, r.shadow_rays,
                 {0, largest_of(r.shadow_rays), false});
  write_heat_map(add("Time per pixel, microseconds", "time.png"), r.size, r.microseconds,
                 {1, std::max(2.0F, largest_of(r.microseconds)), true});
  if (source.reference == nullptr) return pictures;
  const auto errors = relative_errors(r, *source.reference, source.black_level);
  write_heat_map(add("Relative error per pixel", "error.png"), r.size, errors,
                 {0, largest_of(errors), false});
  return pictures;
}

} // namespace lightcuts::oracle

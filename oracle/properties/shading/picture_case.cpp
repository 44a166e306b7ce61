// SPDX-License-Identifier: MIT
#include <oracle/properties/shading/picture_case.h>

#include <fmt/format.h>

#include <lightcuts/core/tree/tree_builder.h>
#include <oracle/properties/point_case.h>

namespace lightcuts::oracle {
namespace {

CutConfig for_view(CutConfig config, const SceneView& view) {
  config.unoccluded = !view.may_occlude();
  return config;
}

} // namespace

PictureCase::PictureCase(const Subject& subject, const Case& on, const SceneView& view)
    : subject_(subject), view_(view), tree_(build(view.scene().lights, {on.seed})), config_(on.cut),
      select_(tree_, for_view(on.cut, view)) {}

glm::vec3 PictureCase::shown(glm::uvec2 pixel) const {
  if (!picture_) picture_ = subject_.render(view_, tree_, {.cut = config_, .threads = 1});
  return picture_->radiance[std::size_t(pixel.y) * view_.size().x + pixel.x];
}

glm::vec3 PictureCase::expected(glm::uvec2 pixel) const {
  const auto p = view_.at(pixel);
  if (!p) return glm::vec3(0);
  return select_(p->point, [&](std::uint32_t light) { return view_.sees(*p, light); }).radiance;
}

std::string PictureCase::text(glm::uvec2 pixel) const {
  return fmt::format("pixel ({}, {}): {}, its point has {}", pixel.x, pixel.y,
                     digits_of(shown(pixel)), digits_of(expected(pixel)));
}

} // namespace lightcuts::oracle

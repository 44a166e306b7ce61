// SPDX-License-Identifier: MIT
#include <lightcuts/core/lobes/shading_point.h>

#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <lightcuts/core/input_error.h>
#include <tests/support/float_limits.h>
#include <tests/support/generators.h>
#include <tests/support/precise.h>

namespace lightcuts {
namespace {

using precise::Quad;

std::string refusal(const gen::View& view) {
  try {
    (void)view.point();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

bool names(const gen::View& view, const std::string& field) {
  return refusal(view).find(field) != std::string::npos;
}

TEST(ShadingPoint, NamesTheFieldThatIsNotFinite) {
  for (int axis = 0; axis < 3; ++axis)
    for (const float bad : {nan, inf, -inf}) {
      gen::View position, normal, viewer;
      position.position[axis] = bad;
      normal.normal[axis] = bad;
      viewer.to_viewer[axis] = bad;
      EXPECT_TRUE(names(position, std::string("position.") + "xyz"[axis]));
      EXPECT_TRUE(names(normal, std::string("normal.") + "xyz"[axis]));
      EXPECT_TRUE(names(viewer, std::string("to_viewer.") + "xyz"[axis]));
    }
}

TEST(ShadingPoint, NamesTheDirectionThatIsNotUnit) {
  for (const float length : {0.0F, 0.9999F, 1.0001F, 2.0F, 3e38F}) {
    gen::View normal, viewer;
    normal.normal = {0, length, 0};
    viewer.to_viewer = {length, 0, 0};
    EXPECT_TRUE(names(normal, "normal"));
    EXPECT_TRUE(names(viewer, "to_viewer"));
  }
}

TEST(ShadingPoint, NamesTheMaterialsField) {
  gen::View view;
  view.material.lobe = Phong{glm::vec3(1), -1};
  EXPECT_TRUE(names(view, "exponent"));
}

RC_GTEST_PROP(ShadingPoint, KnowsTheLengthsOfItsDirections, ()) {
  const ShadingPoint point = (*gen::scene()).view.point();
  // Squares 2^-53, two sums, a root, a quotient: below 2^-50.
  RC_ASSERT(abs(Quad(point.inverse_normal_length()) * precise::length(point.normal()) - 1) <=
            Quad(0x1p-50));
  RC_ASSERT(abs(Quad(point.inverse_mirror_length()) * precise::length(point.mirror()) - 1) <=
            Quad(0x1p-50));
}

RC_GTEST_PROP(ShadingPoint, MirrorsTheViewerAtTheNormal, ()) {
  const gen::View view = (*gen::scene()).view;
  const ShadingPoint point = view.point();
  const glm::vec3 zero(0);
  const Quad n2(precise::dot(view.normal, zero, view.normal));
  const Quad scale = 2 * Quad(precise::dot(view.normal, zero, view.to_viewer)) / n2;
  const Quad length = precise::length(view.to_viewer); // mirroring keeps it
  for (int i = 0; i < 3; ++i) {
    const Quad exact = (scale * Quad(view.normal[i]) - Quad(view.to_viewer[i])) / length;
    // Components are at most 1: rounding to float is 2^-25, in double far less.
    RC_ASSERT(abs(Quad(point.mirror()[i]) - exact) <= Quad(0x1p-24));
  }
}

} // namespace
} // namespace lightcuts

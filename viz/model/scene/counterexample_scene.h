// SPDX-License-Identifier: MIT
#pragma once

#include <lightcuts/render/scene/scene.h>
#include <oracle/cases/case.h>

namespace lightcuts::viz {

/// A scene to see a case by: its triangles, or, without any, a square of the view's material around
/// its shading point, seen from the viewer's side; with all its lights. The picture is an
/// illustration: what is judged are the case's own numbers, and a point more than 10^15 m away is
/// drawn there. view: index of a view; there is one.
[[nodiscard]] Scene scene_of_case(const oracle::Case& on, std::size_t view);

} // namespace lightcuts::viz

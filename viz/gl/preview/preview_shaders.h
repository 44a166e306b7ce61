// SPDX-License-Identifier: MIT
#pragma once

namespace lightcuts::viz {

/// Draw surfaces into five textures: offset from the camera and whether there is a surface;
/// normal towards the viewer and alpha; diffuse reflectance; f0; emission.
extern const char* const surface_vertex_shader;
extern const char* const surface_fragment_shader;

/// A triangle that covers the picture; three vertices without attributes.
extern const char* const full_screen_vertex_shader;

/// Adds the radiance that is due to one batch of lights: the formulas of lightcuts::reflected and
/// lightcuts::emission in single precision.
extern const char* const lights_fragment_shader;

} // namespace lightcuts::viz

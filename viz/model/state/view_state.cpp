// SPDX-License-Identifier: MIT
#include <viz/model/state/view_state.h>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>
#include <lightcuts/render/files/text.h>

#include <oracle/records/record_file.h>
#include <oracle/records/require_camera.h>
#include <viz/model/layers/all_layers.h>

namespace lightcuts::viz {
namespace {

constexpr const char* view_schema = "lightcuts-viz/view/2";

// What a view demands beyond the domains of its fields.

void require_range(const JsonElement& root, const ColourSettings& c) {
  if (c.lo >= c.hi)
    root.refuse_as(InputFault::inconsistent,
                   fmt::format("/hi is {}, expected more than lo, {}", c.hi, c.lo));
  if (c.logarithmic && !c.automatic_range && c.lo <= 0)
    root.refuse_as(InputFault::out_of_domain,
                   fmt::format("/lo is {}, and the scale is logarithmic", c.lo));
}

} // namespace

std::string view_state_json(const ViewState& state) {
  return oracle::record_file(view_schema, state, oracle::Floats::decimal);
}

ViewState read_view_state(const std::string& name, const std::string& text) {
  ViewState state;
  oracle::read_record_file(name, text, view_schema, state, [&state](const JsonElement& root) {
    if (state.open.spec.empty()) root["scene"].refuse(InputFault::missing, "is empty");
    require_range(root, state.colours);
    if (state.camera) oracle::require_camera(root["camera"], *state.camera);
  });
  return state;
}

ViewState load_view_state(const std::filesystem::path& file) {
  return read_view_state(file.string(), read_file(file));
}

} // namespace lightcuts::viz

// SPDX-License-Identifier: MIT
#include <oracle/counterexamples/counterexample_json.h>

#include <fmt/format.h>

#include <lightcuts/render/files/text.h>
#include <oracle/records/record_file.h>
#include <oracle/records/require_camera.h>

namespace lightcuts::oracle {
namespace {

// What a case demands beyond the domains of its fields.

void require_cone(const JsonElement& element, const Light& light) {
  if (light.kind == LightKind::spot && !(light.cos_inner > light.cos_outer))
    element["cos_inner"].refuse(
        InputFault::inconsistent,
        fmt::format("is {}, expected more than cos_outer", light.cos_inner));
}

void require_indices(const JsonElement& element, std::size_t lights) {
  if (element.size() > 0 && lights == 0)
    element.refuse(InputFault::inconsistent, "names lights, but there are none");
  std::uint64_t least = 0;
  for (std::size_t i = 0; i < element.size(); ++i) {
    const std::uint64_t light = element.at(i).whole_number(0, lights - 1);
    if (light < least)
      element.at(i).refuse(InputFault::inconsistent,
                           fmt::format("is {}, expected more than the one before", light));
    least = light + 1;
  }
}

void require_valid(const JsonElement& element, const Case& on) {
  for (std::size_t i = 0; i < on.lights.size(); ++i)
    require_cone(element["lights"].at(i), on.lights[i]);
  for (std::size_t i = 0; i < on.views.size(); ++i)
    require_indices(element["views"].at(i)["hidden"], on.lights.size());
  if (element.has("camera")) require_camera(element["camera"], on.camera);
}

} // namespace

SavedCounterexample read_counterexample(const std::string& name, const std::string& text) {
  SavedCounterexample saved;
  read_record_file(name, text, counterexample_schema, saved, [&saved](const JsonElement& root) {
    if (saved.subject.empty()) root["subject"].refuse(InputFault::missing, "is empty");
    require_valid(root["case"], saved.counterexample.on);
  });
  return saved;
}

SavedCounterexample load_counterexample(const std::filesystem::path& file) {
  return read_counterexample(file.string(), read_file(file));
}

} // namespace lightcuts::oracle

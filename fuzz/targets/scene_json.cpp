// SPDX-License-Identifier: MIT
// A scene in JSON beside the files of tests/files/json, its lights generated. Counts are kept
// small: that a billion lights take long is no finding.
#include <nlohmann/json.hpp>

#include <lightcuts/render/io/open_scene.h>

#include <fuzz/support/files.h>
#include <fuzz/support/mutate_json.h>

namespace lightcuts::fuzz {
namespace {

/// Whether a count in it is so large that as many lights would be made.
bool wants_many(const nlohmann::json& json) {
  constexpr std::uint64_t few = 2000;
  for (const auto& [key, value] : json.items()) {
    const bool counts = key == "count" || key == "paths" || key == "bounces";
    if (counts && value.is_number_unsigned() && value.get<std::uint64_t>() > few) return true;
    if (value.is_structured() && wants_many(value)) return true;
  }
  return false;
}

/// An environment map of 2 x 1 pixels, Radiance's format.
constexpr const char* sky = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n\x40\x40\x40\x80\x80"
                            "\x40\x20\x81";

void run_scene_json(Bytes input) {
  static const WorkFolder folder("json");
  static const auto environment = folder.put("sky.hdr", sky);
  const std::string text = text_of(input);
  const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_discarded() && json.is_structured() && wants_many(json)) return;
  const auto file = folder.put("fuzzed.json", text);
  read_or_refused(folder.name(), [&] {
    const Scene scene = open_scene(file.string());
    require_valid(scene);
    require_lit(scene);
  });
}

const Registered scene_json({"scene_json", run_scene_json, mutated_json});

} // namespace
} // namespace lightcuts::fuzz

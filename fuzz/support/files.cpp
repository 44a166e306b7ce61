// SPDX-License-Identifier: MIT
#include <fuzz/support/files.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <stdexcept>

#include <stdlib.h>

#include <fmt/format.h>

#include <lightcuts/core/cut/cut_selector.h>
#include <lightcuts/core/tree/tree_builder.h>
#include <lightcuts/render/io/open_scene.h>
#include <lightcuts/render/view/scene_view.h>

namespace lightcuts::fuzz {
namespace {

/// In memory where that is possible: a file is written for each input.
std::filesystem::path new_folder() {
  std::string name = "/dev/shm/lightcuts-fuzz-XXXXXX";
  if (mkdtemp(name.data()) != nullptr) return name;
  name = (std::filesystem::temp_directory_path() / "lightcuts-fuzz-XXXXXX").string();
  if (mkdtemp(name.data()) != nullptr) return name;
  throw std::runtime_error("no folder for temporary files");
}

bool is_line(const std::string& text) {
  const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  return !text.empty() && std::none_of(text.begin(), text.end(), is_control);
}

} // namespace

WorkFolder::WorkFolder(const std::string& like) : path_(new_folder()) {
  if (like.empty()) return;
  std::filesystem::copy(std::filesystem::path(LIGHTCUTS_TEST_FILES) / like, path_,
                        std::filesystem::copy_options::recursive);
}

WorkFolder::~WorkFolder() {
  std::error_code error; // nobody to tell
  std::filesystem::remove_all(path_, error);
}

std::filesystem::path WorkFolder::put(const std::string& name, std::string_view content) const {
  const std::filesystem::path file = path_ / name;
  std::ofstream out(file, std::ios::binary);
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();
  if (!out) throw std::runtime_error(file.string() + ": cannot be written");
  return file;
}

void require_message(const std::string& message, const std::string& name) {
  if (!is_line(message)) finding(fmt::format("a message that is not one line: '{}'", message));
  if (message.find(name) == std::string::npos)
    finding(fmt::format("a message that does not name '{}': {}", name, message));
}

void require_valid(const Scene& scene) {
  validate(scene);
  for (const std::string& note : scene.notes)
    if (!is_line(note)) finding(fmt::format("a note that is not one line: '{}'", note));
}

void require_lit(const Scene& scene) {
  Scene small = scene;
  small.image_size = glm::uvec2(1);
  const SceneView view(small);
  const auto seen = view.at({0, 0});
  constexpr std::size_t few = 1000;
  if (!seen || scene.lights.empty() || scene.lights.size() > few) return;
  const LightTree tree = build(scene.lights);
  CutSelector select(tree, {});
  const Cut cut = select(seen->point, [&](std::uint32_t light) { return view.sees(*seen, light); });
  for (int c = 0; c < 3; ++c)
    if (!(cut.radiance[c] >= 0)) finding(fmt::format("a radiance of {}", cut.radiance[c]));
}

} // namespace lightcuts::fuzz

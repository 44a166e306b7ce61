// SPDX-License-Identifier: MIT
// An OBJ file beside the libraries and textures of tests/files/obj.
#include <lightcuts/render/io/open_scene.h>

#include <fuzz/support/files.h>
#include <fuzz/support/mutate_lines.h>

namespace lightcuts::fuzz {
namespace {

void run_obj(Bytes input) {
  static const WorkFolder folder("obj");
  const auto file = folder.put("fuzzed.obj", text_of(input));
  read_or_refused(folder.name(), [&] { require_valid(open_scene(file.string())); });
}

const Registered obj({"obj", run_obj, mutated_lines});

} // namespace
} // namespace lightcuts::fuzz

// SPDX-License-Identifier: MIT
// An MTL file, of which every material is used.
#include <sstream>

#include <lightcuts/render/io/open_scene.h>

#include <fuzz/support/files.h>
#include <fuzz/support/mutate_lines.h>

namespace lightcuts::fuzz {
namespace {

/// A triangle of each material that the library has, and one of a material that it has not.
std::string model_of(const std::string& library) {
  std::string model = "mtllib fuzzed.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n"
                      "usemtl none of them\nf 1/1 2/2 3/3\n";
  std::istringstream in(library);
  for (std::string line; std::getline(in, line);)
    if (const std::size_t at = line.find("newmtl "); at != std::string::npos)
      model += "usemtl " + line.substr(at + 7) + "\nf 1/1 2/2 3/3\nf 1 2 3\n";
  return model;
}

void run_mtl(Bytes input) {
  static const WorkFolder folder("obj");
  const std::string library = text_of(input);
  folder.put("fuzzed.mtl", library);
  const auto file = folder.put("fuzzed.obj", model_of(library));
  read_or_refused(folder.name(), [&] { require_valid(open_scene(file.string())); });
}

const Registered mtl({"mtl", run_mtl, mutated_lines});

} // namespace
} // namespace lightcuts::fuzz

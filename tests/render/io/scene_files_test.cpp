// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/scene_files.h>

#include <string>

#include <gtest/gtest.h>

#include <tests/support/readme.h>

namespace lightcuts {
namespace {

TEST(SceneFiles, are_known_by_their_extension_in_either_case) {
  for (const char* name : {"a.json", "b.OBJ", "folder.txt/c.gltf", "d.e.glb"})
    EXPECT_TRUE(is_scene_file(name)) << name;
  for (const char* name : {"", "a", "json", "a.json.txt", "a.fbx", "obj/a", ".obj"})
    EXPECT_FALSE(is_scene_file(name)) << name;
}

TEST(SceneFiles, are_listed_for_people) {
  EXPECT_EQ(scene_extensions_text(), ".json, .obj, .gltf or .glb");
  EXPECT_EQ(scene_extensions_text("'"), "'.json', '.obj', '.gltf' or '.glb'");
}

TEST(SceneFiles, are_listed_in_the_readme_wherever_it_speaks_of_them) {
  const std::string list = scene_extensions_text("`");
  for (const char* heading : {"## The window", "## Scenes"})
    EXPECT_NE(test::readme_section(heading).find(list), std::string::npos)
        << "README.md, " << heading << ", should have " << list;
}

} // namespace
} // namespace lightcuts

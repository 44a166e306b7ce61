// SPDX-License-Identifier: MIT
#include <filesystem>

#include <gtest/gtest.h>
#include <lightcuts/render/files/output_folder.h>
#include <oracle/counterexamples/counterexample_json.h>
#include <oracle/counterexamples/named_subjects.h>

#include <tests/render/support/temporary_folder.h>
#include <tests/viz/support/gui_robot.h>

namespace lightcuts::viz {
namespace {

/// A shrunk counterexample of the mutant, as a file.
std::filesystem::path counterexample_file(const TemporaryFolder& folder, const char* mutant) {
  const auto subject = oracle::subject_named(mutant);
  const oracle::HuntResult result = hunt(*subject, {.cases = 20'000});
  EXPECT_TRUE(result.found);
  const auto file = folder.path / "counterexample.json";
  write_file_atomically(file, oracle::counterexample_json({oracle::full_subject_name(mutant),
                                                           shrunk(*subject, *result.found)}));
  return file;
}

TEST(GuiCounterexample, OpensAtTheRightNodeWithBoundAndTruthSideBySide) {
  const TemporaryFolder folder;
  const auto file = counterexample_file(folder, "mutant:cosine-of-centre");
  Robot robot(small_room());
  robot.app().drop(file.string()); // as when it is dropped on the window
  robot.settle();
  const auto& scene = robot.workbench().scene();
  ASSERT_TRUE(scene->counterexample());
  const OpenedCounterexample& c = *scene->counterexample();
  EXPECT_TRUE(c.still_fails);
  EXPECT_EQ(c.saved.counterexample.property, oracle::Property::bound_dominates_contribution);
  ASSERT_EQ(c.node, 0U); // two lights: the root is the only cluster that is no light
  EXPECT_EQ(robot.state().node, c.node);
  // The bound is the mutant's, below what is true of the cluster in some channel.
  EXPECT_TRUE(c.bound.r < c.open_truth.r || c.bound.g < c.open_truth.g ||
              c.bound.b < c.open_truth.b);
  const auto row = robot.workbench().selected_row();
  ASSERT_TRUE(row);
  EXPECT_EQ(row->bound, c.bound);
  // At the case's own shading point, to the bit.
  EXPECT_EQ(robot.workbench().inspection()->inspection.position,
            c.saved.counterexample.on.views[c.view].view.position);
}

TEST(GuiCounterexample, BrokenFileLeavesTheLastGoodStateAndAMessage) {
  const TemporaryFolder folder;
  const auto file = folder.path / "broken.json";
  write_file_atomically(file, R"({"schema": "lightcuts-oracle/counterexample/1", "case": 3})");
  Robot robot(small_room());
  const auto scene = robot.workbench().scene();
  const auto picture = robot.app().image().shown().values().image;
  for (const std::string& bad : {file.string(), folder.path.string() + "/missing.obj",
                                 std::string("no-such-scene"), std::string("cloud?lights=none")}) {
    robot.workbench().clear_messages();
    robot.app().drop(bad);
    robot.settle();
    EXPECT_EQ(robot.workbench().scene(), scene) << bad;
    EXPECT_EQ(robot.app().image().shown().values().image, picture);
    ASSERT_EQ(robot.workbench().messages().size(), 1U) << bad;
    EXPECT_TRUE(robot.workbench().messages().front().error);
  }
}

} // namespace
} // namespace lightcuts::viz

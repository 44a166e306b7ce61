// SPDX-License-Identifier: MIT
#include <lightcuts/render/images/image_codec.h>

#include <gtest/gtest.h>

#include <tests/render/support/refusal.h>
#include <tests/render/support/temporary_folder.h>

namespace lightcuts {
namespace {

TEST(ImageCodec, IsOneHoweverOftenAskedFor) { EXPECT_EQ(&image_codec(), &image_codec()); }

TEST(ImageCodec, IsRefusedWhereItsModuleIsMissing) {
  const auto load = [] { (void)load_image_codec("/nowhere/codec.so"); };
  expect_refusal("images cannot be read or written without the module /nowhere/codec.so", load);
  expect_refusal("No such file", load);
  expect_fault(InputFault::unreadable_file, load);
}

TEST(ImageCodec, IsRefusedWhereItsModuleIsNone) {
  const TemporaryFolder folder;
  write(folder.path / "text.so", "not a library");
  expect_refusal("text.so, which cannot be loaded",
                 [&] { (void)load_image_codec(folder.path / "text.so"); });
  expect_refusal("libm.so.6, which cannot be loaded", [] { (void)load_image_codec("libm.so.6"); });
}

} // namespace
} // namespace lightcuts

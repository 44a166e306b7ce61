// SPDX-License-Identifier: MIT
#include <lightcuts/core/input_error.h>

#include <optional>

#include <gtest/gtest.h>

#include <lightcuts/core/cut/cut.h>
#include <lightcuts/core/lights/light_set.h>
#include <lightcuts/core/lobes/material.h>
#include <lightcuts/core/records/fields.h>
#include <lightcuts/core/shading/shading_frame.h>
#include <tests/support/float_limits.h>

namespace lightcuts {
namespace {

template <class Action>
std::optional<InputFault> fault_in(const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.fault();
  }
  return std::nullopt;
}

std::optional<InputFault> fault_in(const Material& material) {
  return fault_in([&] { validate(material); });
}

std::optional<InputFault> fault_in(const CutConfig& config) {
  return fault_in([&] { validate(config); });
}

TEST(InputError, SaysWhatIsWrongWithALight) {
  LightSet lights;
  EXPECT_EQ(fault_in([&] { lights.add_omni({0, nan, 0}, {1, 1, 1}); }), InputFault::not_finite);
  EXPECT_EQ(fault_in([&] { lights.add_omni({0, 0, 0}, {1, -1, 1}); }), InputFault::negative);
  EXPECT_EQ(fault_in([&] {
              lights.add_oriented({0, 0, 0}, {0, 0, 2}, {1, 1, 1});
            }),
            InputFault::not_unit);
  EXPECT_EQ(fault_in([&] {
              lights.add_spot({0, 0, 0}, {0, 0, 1}, {1, 1, 1}, 0, 4);
            }),
            InputFault::out_of_domain);
  EXPECT_EQ(fault_in([&] { lights.set_min_distance(-1); }), InputFault::negative);
  EXPECT_EQ(fault_in([&] { lights.set_min_distance(0); }), InputFault::out_of_domain);
  EXPECT_EQ(fault_in([&] { lights.add_omni({0, 0, 0}, {1, 1, 1}); }), std::nullopt);
}

TEST(InputError, SaysWhatIsWrongWithAMaterialAndACut) {
  EXPECT_EQ(fault_in(Material{{nan, 0, 0}, {}}), InputFault::not_finite);
  EXPECT_EQ(fault_in(Material{{}, Phong{{0, 0, -1}, 1}}), InputFault::negative);
  EXPECT_EQ(fault_in(Material{{}, Ward{{1, 1, 1}, 2}}), InputFault::out_of_domain);
  EXPECT_EQ(fault_in(CutConfig{.threshold = nan}), InputFault::not_finite);
  EXPECT_EQ(fault_in(CutConfig{.threshold = -1}), InputFault::negative);
  EXPECT_EQ(fault_in(CutConfig{.max_size = 0}), InputFault::out_of_domain);
}

TEST(InputError, SaysWhatIsWrongWithAShadingPoint) {
  const auto fault_of_frame = [](const glm::vec3& position, const glm::vec3& normal) {
    return fault_in([&] { (void)ShadingFrame(position, normal, glm::vec3(0, 0, 1)); });
  };
  EXPECT_EQ(fault_of_frame({nan, 0, 0}, {0, 0, 1}), InputFault::not_finite);
  EXPECT_EQ(fault_of_frame({0, 0, 0}, {0, 0, 2}), InputFault::not_unit);
  EXPECT_EQ(fault_of_frame({0, 0, 0}, {0, 0, 1}), std::nullopt);
}

TEST(InputError, HasANameForEachFault) {
  for (int i = 0; i < input_fault_count; ++i)
    EXPECT_EQ(value_named<InputFault>(name_of(InputFault(i))), InputFault(i));
  EXPECT_STREQ(name_of(InputFault::malformed_file), "malformed-file");
}

} // namespace
} // namespace lightcuts

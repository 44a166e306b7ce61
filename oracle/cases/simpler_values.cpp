// SPDX-License-Identifier: MIT
#include <oracle/cases/simpler_values.h>

namespace lightcuts::oracle {

std::vector<float> simpler_values(float value, float /*usual*/, const Domain& domain) {
  std::vector<float> list = gen::simpler(value);
  std::erase_if(list, [&domain](float v) { return v < domain.least || v > domain.most; });
  return list;
}

std::vector<glm::vec3> simpler_values(const glm::vec3& value, const glm::vec3& /*usual*/,
                                      const Domain& domain) {
  if (domain.unit) return gen::simpler_directions(value);
  std::vector<glm::vec3> list;
  for (int i = 0; i < 3; ++i)
    for (const float component : simpler_values(value[i], 0, domain)) {
      list.push_back(value);
      list.back()[i] = component;
    }
  return list;
}

std::vector<glm::uvec2> simpler_values(const glm::uvec2& value, const glm::uvec2& /*usual*/,
                                       const Domain& /*domain*/) {
  std::vector<glm::uvec2> list{glm::uvec2(1), {1, value.y}, {value.x, 1}};
  std::erase(list, value);
  return list;
}

std::vector<std::vector<std::uint32_t>> simpler_values(const std::vector<std::uint32_t>& value,
                                                       const std::vector<std::uint32_t>& /*usual*/,
                                                       const Domain& /*domain*/) {
  return with_fewer(value, 0);
}

std::vector<std::vector<Light>> simpler_values(const std::vector<Light>& value,
                                               const std::vector<Light>& /*usual*/,
                                               const Domain& /*domain*/) {
  std::vector<std::vector<Light>> list = with_fewer(value, 1);
  for (std::size_t i = 0; i < value.size(); ++i)
    for (const Light& light : gen::simpler(value[i])) {
      list.push_back(value);
      list.back()[i] = light;
    }
  return list;
}

std::vector<Profile> simpler_values(const Profile& value, const Profile& usual,
                                    const Domain& /*domain*/) {
  std::vector<Profile> list;
  if (value == usual) return list;
  list.push_back(usual);
  const ProfileTable& table = value.table();
  const auto add = [&](ProfileTable simpler) {
    if (simpler != table) list.emplace_back(std::move(simpler));
  };
  add({table.cosines, {1}, {0}, {table.shares.begin(), table.shares.begin() + table.rows()}});
  for (std::size_t row = 1; row + 1 < table.rows(); ++row) {
    ProfileTable fewer = table;
    fewer.cosines.erase(fewer.cosines.begin() + std::ptrdiff_t(row));
    for (std::size_t plane = table.planes(); plane-- > 0;)
      fewer.shares.erase(fewer.shares.begin() + std::ptrdiff_t(plane * table.rows() + row));
    add(fewer);
  }
  for (std::size_t i = 0; i < table.shares.size(); ++i)
    for (const float share : simpler_values(table.shares[i], 0, domain::within(0, 1))) {
      ProfileTable rounder = table;
      rounder.shares[i] = share;
      add(rounder);
    }
  return list;
}

} // namespace lightcuts::oracle

// SPDX-License-Identifier: MIT
#include <oracle/records/record_text.h>

namespace lightcuts::oracle {

std::string text_of(float value) { return fmt::format("{:.9g}", value); }

std::string text_of(const glm::vec3& value) {
  return fmt::format("({}, {}, {})", text_of(value.x), text_of(value.y), text_of(value.z));
}

std::string text_of(const glm::uvec2& value) { return fmt::format("{} x {}", value.x, value.y); }

std::string text_of(const std::vector<std::uint32_t>& value) {
  const auto shown = std::min<std::ptrdiff_t>(std::ptrdiff_t(value.size()), 12);
  std::string text = fmt::format("{}", fmt::join(value.begin(), value.begin() + shown, " "));
  if (value.empty()) text = "none";
  return value.size() > 12 ? text + fmt::format(" ... of {}", value.size()) : text;
}

} // namespace lightcuts::oracle

// SPDX-License-Identifier: MIT
#pragma once

#include <fstream>
#include <iterator>
#include <string>

namespace lightcuts::test {

/// The text of README.md.
inline std::string readme() {
  std::ifstream file(LIGHTCUTS_README);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The part of README.md from this heading, such as "## Scenes", to the next of its level; empty
/// where there is none.
inline std::string readme_section(const std::string& heading) {
  const std::string text = readme();
  const std::size_t begin = text.find("\n" + heading + "\n");
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find("\n## ", begin + 1) - begin);
}

} // namespace lightcuts::test

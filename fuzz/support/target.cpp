// SPDX-License-Identifier: MIT
#include <fuzz/support/target.h>

#include <cstdio>
#include <cstdlib>
#include <vector>

#include <fmt/format.h>

namespace lightcuts::fuzz {
namespace {

std::vector<Target>& list() {
  static std::vector<Target> targets;
  return targets;
}

} // namespace

Registered::Registered(const Target& target) { list().push_back(target); }

std::span<const Target> targets() { return list(); }

void finding(const std::string& what) {
  fmt::print(stderr, "finding: {}\n", what);
  std::abort();
}

} // namespace lightcuts::fuzz

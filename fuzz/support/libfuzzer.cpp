// SPDX-License-Identifier: MIT
// What libFuzzer calls in a program of one target.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include <fuzz/support/target.h>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

using namespace lightcuts;

const fuzz::Target& target() { return fuzz::targets().front(); }

std::string bytewise(const std::string& text) {
  constexpr std::size_t room = 64;
  std::string changed = text;
  changed.resize(text.size() + room);
  auto* data = reinterpret_cast<std::uint8_t*>(changed.data());
  changed.resize(LLVMFuzzerMutate(data, text.size(), changed.size()));
  return changed;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  target().run({data, size});
  return 0;
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  gen::Dice dice(seed);
  if (target().mutated == nullptr || dice.one_in(4)) return LLVMFuzzerMutate(data, size, most);
  const std::string changed = target().mutated(std::string(data, data + size), dice, bytewise);
  if (changed.size() > most) return LLVMFuzzerMutate(data, size, most);
  std::copy(changed.begin(), changed.end(), data);
  return changed.size();
}

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include <oracle/numbers/dice.h>

/// What is fuzzed: by libFuzzer, or, its inputs once more, by fuzz-replay.
namespace lightcuts::fuzz {

using Bytes = std::span<const std::uint8_t>;

/// How libFuzzer changes a text that it knows nothing of.
using Bytewise = std::function<std::string(const std::string& text)>;

struct Target {
  const char* name;
  /// Returns where the input is read, or refused as it should be; else ends the process, see
  /// finding(), or throws.
  void (*run)(Bytes input);
  /// The input changed so that most of it can still be read; default: null, bytewise.
  std::string (*mutated)(const std::string& input, gen::Dice& dice,
                         const Bytewise& bytewise) = nullptr;
};

/// Enters a target in the list of the program.
struct Registered {
  explicit Registered(const Target& target);
};
/// The targets that are linked into the program.
[[nodiscard]] std::span<const Target> targets();

[[nodiscard]] inline std::string text_of(Bytes bytes) { return {bytes.begin(), bytes.end()}; }

/// Says what is wrong with what came of the input, and ends the process by SIGABRT.
[[noreturn]] void finding(const std::string& what);

} // namespace lightcuts::fuzz

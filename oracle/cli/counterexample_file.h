// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>
#include <oracle/campaign/hunt.h>

namespace lightcuts::cli {

/// Shrinks the counterexample and writes it to DIR/counterexample-NAME.json.
class CounterexampleFile {
public:
  /// subject_name: as files remember it; name: by default that of the property. Throws InputError
  /// where the folder cannot be written.
  CounterexampleFile(const oracle::Subject& subject, const std::string& subject_name,
                     const oracle::Counterexample& found, const std::filesystem::path& folder,
                     const std::string& name = {});

  /// For readers: what is wrong, on how small a case, and the command that replays the file.
  [[nodiscard]] std::string text() const;
  [[nodiscard]] nlohmann::ordered_json json() const;

private:
  std::filesystem::path file_;
  oracle::Counterexample shrunk_;
};

/// The command that replays the file, to be pasted into a shell.
[[nodiscard]] std::string replay_command(const std::filesystem::path& file);

/// A word that a shell takes for this text.
[[nodiscard]] std::string quoted(const std::string& text);

} // namespace lightcuts::cli

// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include <nlohmann/json.hpp>
#include <oracle/campaign/check.h>

namespace lightcuts::cli {

/// Where a long check is kept, so that it can go on another day: --resume.
class CampaignFile {
public:
  /// what: all that a result depends on, by name; kept beside it.
  CampaignFile(std::filesystem::path file, nlohmann::ordered_json what);

  /// What the file has counted; nothing where there is no file. Throws InputError, naming the file
  /// and what differs, where it is of another check or cannot be read.
  [[nodiscard]] oracle::CheckResult load() const;
  /// Replaces the file as a whole. Throws InputError where that cannot be.
  void save(const oracle::CheckResult& result) const;

private:
  std::filesystem::path file_;
  nlohmann::ordered_json what_;
};

} // namespace lightcuts::cli

// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <string>

#include <gtest/gtest.h>
#include <oracle/counterexamples/counterexample_json.h>
#include <oracle/counterexamples/named_subjects.h>
#include <viz/model/scene/opened_scene.h>

#include <tests/render/support/temporary_folder.h>

namespace lightcuts::viz {

inline const char* const broken_bound = "mutant:cosine-of-centre";
inline const char* const broken_cut = "mutant:capacity-off-by-one";

/// What the oracle finds of a mutant, as simple as it gets.
inline oracle::Counterexample counterexample_of(const std::string& mutant) {
  const auto subject = oracle::subject_named(mutant);
  oracle::HuntConfig config;
  config.cases = 20'000;
  const oracle::HuntResult result = oracle::hunt(*subject, config);
  EXPECT_TRUE(result.found) << mutant;
  return oracle::shrunk(*subject, result.found.value());
}

/// A counterexample, saved, as long as the test lives.
class CounterexampleFile {
public:
  CounterexampleFile(const std::string& subject, const oracle::Counterexample& counterexample) {
    write(path(), oracle::counterexample_json({subject, counterexample}));
  }
  [[nodiscard]] std::string path() const { return (folder_.path / "found.json").string(); }
  [[nodiscard]] std::shared_ptr<const OpenedScene> open() const {
    SceneRequest request;
    request.spec = path();
    return std::make_shared<const OpenedScene>(request);
  }

private:
  TemporaryFolder folder_;
};

} // namespace lightcuts::viz

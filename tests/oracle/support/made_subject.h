// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <memory>
#include <utility>

#include <oracle/subjects/library_subject.h>

#include <tests/oracle/support/judged_point.h>

namespace lightcuts::oracle {

/// The library, but for trees that a test makes of the library's.
class MadeSubject : public KernelSubject {
public:
  using Make = std::function<std::unique_ptr<SubjectTree>(LightTree)>;

  explicit MadeSubject(Make make, Parts parts = library_parts)
      : KernelSubject("made"), make_(std::move(make)), parts_(parts) {}
  [[nodiscard]] Parts parts() const override { return parts_; }
  [[nodiscard]] std::unique_ptr<SubjectTree> build(const LightSet& lights,
                                                   std::uint64_t seed) const override {
    return make_(lightcuts::build(lights, {seed}));
  }

private:
  Make make_;
  Parts parts_;
};

/// One with trees of the given type, made of the library's.
template <class Tree>
MadeSubject subject_with() {
  return MadeSubject([](LightTree tree) { return std::make_unique<Tree>(std::move(tree)); });
}

} // namespace lightcuts::oracle

// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstdint>
#include <memory>
#include <type_traits>

#include <lightcuts/core/blocks/proven_visibility.h>

namespace lightcuts {

/// Refers to a function that tells whether light i of a LightSet is seen from point p of a group,
/// and to what proves it of many at once, if anything does; for the time of a call: both must
/// outlive it.
class BlockVisibility {
public:
  template <class F>
  requires(!std::same_as<std::remove_cvref_t<F>, BlockVisibility> &&
           std::is_invocable_r_v<bool, F&, std::uint32_t, std::uint32_t>)
      BlockVisibility(F&& f, // NOLINT(bugprone-forwarding-reference-overload)
                      ProvenVisibility* proven = nullptr)
      : object_(const_cast<void*>(static_cast<const void*>(std::addressof(f)))),
        call_([](void* object, std::uint32_t point, std::uint32_t light) -> bool {
          return (*static_cast<std::remove_reference_t<F>*>(object))(point, light);
        }),
        proven_(proven) {}

  bool operator()(std::uint32_t point, std::uint32_t light) const {
    return call_(object_, point, light);
  }
  /// Of the same points; null: nothing is proven.
  [[nodiscard]] ProvenVisibility* proven() const { return proven_; }

private:
  void* object_;
  bool (*call_)(void*, std::uint32_t, std::uint32_t);
  ProvenVisibility* proven_;
};

} // namespace lightcuts

// SPDX-License-Identifier: MIT
#pragma once

#include <concepts>
#include <cstdint>
#include <memory>
#include <type_traits>

namespace lightcuts {

/// Refers to a function that tells whether light i of a LightSet is seen, a shadow ray mostly, for
/// the time of a call: the callable must outlive it.
class Visibility {
public:
  template <class F>
  requires(!std::same_as<std::remove_cvref_t<F>, Visibility> &&
           std::is_invocable_r_v<bool, F&, std::uint32_t>)
      Visibility(F&& f) // NOLINT(bugprone-forwarding-reference-overload)
      : object_(address_of(f)), call_([](void* object, std::uint32_t light) -> bool {
          return (*reinterpret_cast<std::remove_reference_t<F>*>(object))(light);
        }) {}

  bool operator()(std::uint32_t light) const { return call_(object_, light); }

private:
  /// Of an object or a function.
  template <class F>
  static void* address_of(F& f) {
    if constexpr (std::is_function_v<F>)
      return reinterpret_cast<void*>(&f);
    else
      return const_cast<void*>(static_cast<const void*>(std::addressof(f)));
  }

  void* object_;
  bool (*call_)(void*, std::uint32_t);
};

} // namespace lightcuts

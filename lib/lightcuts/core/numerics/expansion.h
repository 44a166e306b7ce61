// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace lightcuts {

/// A sum of doubles without error: a nonoverlapping expansion in ascending order (Shewchuk 1997,
/// "Adaptive Precision Floating-Point Arithmetic"). Exact as long as nothing over- or underflows.
/// Takes up to Capacity numbers, a product counts for two.
template <std::size_t Capacity>
class Expansion {
public:
  void add(double value) {
    for (std::size_t i = 0; i < count_; ++i) {
      double& term = terms_[i];
      const double sum = value + term;
      const double term_seen = sum - value;
      const double value_seen = sum - term_seen;
      term = (value - value_seen) + (term - term_seen);
      value = sum;
    }
    terms_[count_++] = value;
  }

  void add_product(double a, double b) {
    const double product = a * b;
    add(std::fma(a, b, -product));
    add(product);
  }

  /// Within a few ulps; the sign is exact.
  [[nodiscard]] double rounded() const {
    double sum = 0;
    for (const double term : terms()) sum += term;
    return sum;
  }

  [[nodiscard]] std::span<const double> terms() const { return {terms_.data(), count_}; }

private:
  std::array<double, Capacity> terms_; // uninitialised beyond count_
  std::size_t count_ = 0;
};

} // namespace lightcuts

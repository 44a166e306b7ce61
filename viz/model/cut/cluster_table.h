// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <viz/model/cut/cluster_row.h>

namespace lightcuts::viz {

enum class ClusterColumn {
  node,
  depth,
  lights,
  share,
  sight,
  bound,
  estimate,
  truth,
  error,
  intensity,
  distance,
  representative
};
inline constexpr int cluster_column_count = 12;

struct ClusterColumnInfo {
  std::string_view name; ///< as filters call it
  std::string_view unit; ///< empty: a number without one
  std::string_view help; ///< what it is, with its formula
};
[[nodiscard]] const ClusterColumnInfo& info_of(ClusterColumn column);

/// The one number by which a row is sorted and filtered: of RGB quantities the sum of the channels
/// for intensity, estimate, truth and error, the largest for bound; of sight its place
/// in sight_names. Nothing where it is not known: an unsaid representative, a truth that is not
/// there yet.
[[nodiscard]] std::optional<double> scalar_of(const ClusterRow& row, ClusterColumn column);

/// Conditions on rows of the table; an empty filter accepts any row.
class RowFilter {
public:
  enum class Comparison { less, at_most, equal, unequal, at_least, greater };
  struct NumberCondition {
    ClusterColumn column;
    Comparison comparison;
    double value;
  };

  void require(const NumberCondition& condition) { numbers_.push_back(condition); }
  /// Requires that the cluster's representative is seen, or is not.
  void require_visible(bool visible) { (visible ? visible_ : hidden_) = true; }

  /// Whether all conditions hold; none does for a number that is NaN or not known.
  [[nodiscard]] bool accepts(const ClusterRow& row) const;

private:
  std::vector<NumberCondition> numbers_;
  bool visible_ = false, hidden_ = false;
};

struct FilterReading {
  RowFilter filter;  ///< of the words before the one that cannot be read
  std::string error; ///< names that word and what is wrong with it; empty: all is well
};

/// Reads conditions separated by white space, all of which must hold: a column's name, one of
/// < <= = != >= > and a number ("lights>10 error>=1e-3 node=17"; of sight one of sight_names,
/// "sight=share"), or "visible", or "hidden".
[[nodiscard]] FilterReading read_filter(std::string_view text);

/// Indices of the rows that the filter accepts, by the column's scalar; equal ones stay in their
/// order, and NaN and what is not known come last whichever way.
[[nodiscard]] std::vector<std::uint32_t> sorted_and_filtered(std::span<const ClusterRow> rows,
                                                             ClusterColumn column, bool descending,
                                                             const RowFilter& filter);

} // namespace lightcuts::viz

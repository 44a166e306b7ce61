// SPDX-License-Identifier: MIT
#include <viz/model/cut/cluster_table.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace lightcuts::viz {
namespace {

using Comparison = RowFilter::Comparison;

constexpr std::array<ClusterColumnInfo, cluster_column_count> columns{{
    {"node", "", "Index of the tree's node; 0 is the root."},
    {"depth", "", "Steps from the root, which has 0."},
    {"lights", "", "Number of lights in the cluster."},
    {"share", "",
     "How near the bound is to what is allowed; at most 1 where it obeys.\n"
     "max over R, G, B of bound / max(threshold * total, black level)"},
    {"sight", "",
     "How it is known whether the cluster is seen.\n"
     "seen, hidden: proven for all pixels of the block, without a ray\n"
     "ray: by the pixel's own shadow ray to the light that stands for it\n"
     "share: estimated by rays to some of its lights, of the pixel or of its block"},
    {"bound", "radiance",
     "Upper bound of the estimate's error.\n|estimate - truth| <= bound in each channel\n"
     "shown: the largest of R, G, B"},
    {"estimate", "radiance",
     "What the cluster is taken to contribute.\n"
     "material * cosine * geometric term * V(representative) * intensity,\n"
     "the first three at the centroid of intensity; at the representative where the method\n"
     "is paper or unscaled\n"
     "shown: sum of R, G, B"},
    {"truth", "radiance",
     "What the cluster does contribute.\nsum of all its lights' contributions, each with its own "
     "visibility\nshown: sum of R, G, B"},
    {"error", "radiance", "sum over R, G, B of |estimate - truth|"},
    {"intensity", "W/sr", "Total intensity of the cluster's lights.\nsum of R, G, B"},
    {"distance", "m",
     "From the shading point x to the nearest point of the cluster's box.\n"
     "min |y - x| over y in the box; 0 for directional lights"},
    {"representative", "", "Index of the light that stands for the cluster."},
}};

double sum(const glm::dvec3& v) { return v.x + v.y + v.z; }

/// NaN where one of them is.
double largest(const glm::vec3& v) {
  if (std::isnan(v.x + v.y + v.z)) return std::nan("");
  return std::max({v.x, v.y, v.z});
}

bool holds(double a, Comparison comparison, double b) {
  switch (comparison) {
  case Comparison::less:
    return a < b;
  case Comparison::at_most:
    return a <= b;
  case Comparison::equal:
    return a == b;
  case Comparison::unequal:
    return a != b && !std::isnan(a);
  case Comparison::at_least:
    return a >= b;
  case Comparison::greater:
    return a > b;
  }
  return false;
}

std::optional<Comparison> comparison_named(std::string_view text) {
  if (text == "<") return Comparison::less;
  if (text == "<=") return Comparison::at_most;
  if (text == "=") return Comparison::equal;
  if (text == "!=") return Comparison::unequal;
  if (text == ">=") return Comparison::at_least;
  if (text == ">") return Comparison::greater;
  return std::nullopt;
}

std::optional<ClusterColumn> column_named(std::string_view name) {
  for (int i = 0; i < cluster_column_count; ++i)
    if (columns[i].name == name) return ClusterColumn(i);
  return std::nullopt;
}

std::optional<double> number(std::string_view text) {
  double value = 0;
  const char* end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data(), end, value);
  if (problem != std::errc() || stop != end || std::isnan(value)) return std::nullopt;
  return value;
}

/// As conditions have it: sight by its names.
std::optional<double> value_of(ClusterColumn column, std::string_view text) {
  if (column != ClusterColumn::sight) return number(text);
  const auto at = std::find(sight_names.begin(), sight_names.end(), text);
  if (at == sight_names.end()) return std::nullopt;
  return double(at - sight_names.begin());
}

std::string all_names() {
  std::string names;
  for (const ClusterColumnInfo& column : columns) names += fmt::format("{} ", column.name);
  return names + "visible hidden";
}

/// Adds the condition that a word states; what is wrong with it, if anything.
std::string add_condition(std::string_view word, RowFilter& filter) {
  if (word == "visible" || word == "hidden") {
    filter.require_visible(word == "visible");
    return {};
  }
  constexpr std::string_view signs = "<=!>";
  const std::size_t begin = std::min(word.find_first_of(signs), word.size());
  const std::size_t end = std::min(word.find_first_not_of(signs, begin), word.size());
  const auto column = column_named(word.substr(0, begin));
  if (!column) return fmt::format("\"{}\": not one of {}", word, all_names());
  const auto comparison = comparison_named(word.substr(begin, end - begin));
  if (!comparison)
    return fmt::format("\"{}\": after the name there has to be one of < <= = != >= >", word);
  const auto value = value_of(*column, word.substr(end));
  if (!value && column == ClusterColumn::sight)
    return fmt::format("\"{}\": ends in none of {}", word, fmt::join(sight_names, " "));
  if (!value) return fmt::format("\"{}\": ends in no number", word);
  filter.require({*column, *comparison, *value});
  return {};
}

} // namespace

const ClusterColumnInfo& info_of(ClusterColumn column) { return columns[std::size_t(column)]; }

std::optional<double> scalar_of(const ClusterRow& row, ClusterColumn column) {
  switch (column) {
  case ClusterColumn::node:
    return row.node;
  case ClusterColumn::depth:
    return row.depth;
  case ClusterColumn::lights:
    return row.lights;
  case ClusterColumn::intensity:
    return sum(row.intensity);
  case ClusterColumn::representative:
    if (row.representative == oracle::TreeClaim::unsaid) return std::nullopt;
    return row.representative;
  case ClusterColumn::distance:
    return row.distance;
  case ClusterColumn::bound:
    return largest(row.bound);
  case ClusterColumn::estimate:
    return sum(row.estimate);
  case ClusterColumn::truth:
    if (!row.truth) return std::nullopt;
    return sum(*row.truth);
  case ClusterColumn::error:
    return error(row);
  case ClusterColumn::share:
    return row.share;
  case ClusterColumn::sight:
    if (!row.sight) return std::nullopt;
    return double(*row.sight);
  }
  return std::nullopt;
}

bool RowFilter::accepts(const ClusterRow& row) const {
  if ((visible_ && !row.visible) || (hidden_ && row.visible)) return false;
  return std::all_of(numbers_.begin(), numbers_.end(), [&](const NumberCondition& condition) {
    const std::optional<double> value = scalar_of(row, condition.column);
    return value && holds(*value, condition.comparison, condition.value);
  });
}

FilterReading read_filter(std::string_view text) {
  constexpr std::string_view space = " \t\r\n";
  FilterReading reading;
  while (reading.error.empty()) {
    const std::size_t begin = text.find_first_not_of(space);
    if (begin == std::string_view::npos) break;
    text.remove_prefix(begin);
    const std::size_t length = std::min(text.find_first_of(space), text.size());
    reading.error = add_condition(text.substr(0, length), reading.filter);
    text.remove_prefix(length);
  }
  return reading;
}

std::vector<std::uint32_t> sorted_and_filtered(std::span<const ClusterRow> rows,
                                               ClusterColumn column, bool descending,
                                               const RowFilter& filter) {
  using Keyed = std::pair<double, std::uint32_t>;
  std::vector<Keyed> order;
  for (std::uint32_t i = 0; i < rows.size(); ++i)
    if (filter.accepts(rows[i]))
      order.emplace_back(scalar_of(rows[i], column).value_or(std::nan("")), i);
  std::stable_sort(order.begin(), order.end(), [descending](const Keyed& a, const Keyed& b) {
    if (std::isnan(a.first) || std::isnan(b.first))
      return !std::isnan(a.first) && std::isnan(b.first);
    return descending ? a.first > b.first : a.first < b.first;
  });
  std::vector<std::uint32_t> result;
  result.reserve(order.size());
  for (const Keyed& entry : order) result.push_back(entry.second);
  return result;
}

} // namespace lightcuts::viz

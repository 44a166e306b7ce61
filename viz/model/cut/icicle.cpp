// SPDX-License-Identifier: MIT
#include <viz/model/cut/icicle.h>

#include <algorithm>
#include <cassert>
#include <cmath>

namespace lightcuts::viz {

/// A view in units of lights, and what is drawn on it.
struct Icicle::Canvas {
  Canvas(const IcicleView& shown, const IcicleCut& the_cut, std::uint32_t total)
      : view(shown), cut(the_cut), begin(shown.x0 * total), end(shown.x1 * total),
        pixel((end - begin) / shown.width) {}

  [[nodiscard]] float x(double light) const {
    return float(std::clamp((light - begin) / pixel, 0.0, double(view.width)));
  }

  [[nodiscard]] IcicleBlock block(std::uint32_t depth, double first, double last) const {
    IcicleBlock b;
    b.depth = depth;
    b.row = depth - view.first_row;
    b.x0 = x(first);
    b.x1 = x(last);
    b.lights = std::uint32_t(last - first);
    return b;
  }

  /// Where a node lies that is not empty.
  [[nodiscard]] IcicleBlockKind kind(std::uint32_t position, std::uint32_t depth,
                                     std::uint32_t first_light) const {
    const auto after =
        std::upper_bound(cut.pieces_.begin(), cut.pieces_.end(), first_light,
                         [](std::uint32_t at, const IcicleCut::Piece& p) { return at < p.begin; });
    if (after == cut.pieces_.begin()) return IcicleBlockKind::above_cut;
    const IcicleCut::Piece& piece = *std::prev(after);
    if (piece.position == position) return IcicleBlockKind::cut;
    const bool below = piece.depth < depth && first_light < piece.end;
    return below ? IcicleBlockKind::below_cut : IcicleBlockKind::above_cut;
  }

  /// Of the cut's nodes, how many begin among these lights, at this depth or deeper.
  [[nodiscard]] std::uint32_t cut_nodes(std::uint32_t depth, std::uint32_t first,
                                        std::uint32_t last) const {
    const auto piece =
        std::lower_bound(cut.pieces_.begin(), cut.pieces_.end(), first,
                         [](const IcicleCut::Piece& p, std::uint32_t at) { return p.begin < at; });
    std::uint32_t count = 0;
    for (auto p = piece; p != cut.pieces_.end() && p->begin < last; ++p)
      if (p->depth >= depth) ++count;
    return count;
  }

  const IcicleView& view;
  const IcicleCut& cut;
  double begin, end; ///< of the window
  double pixel;      ///< lights in it
  std::vector<IcicleBlock> blocks;
};

Icicle::Icicle(const oracle::Topology& tree) : total_(tree.size() > 0 ? tree.light_count(0) : 0) {
  if (total_ == 0) return;
  const std::uint32_t size = tree.size();
  node_ = {0};
  begin_ = {0};
  for (std::vector<std::uint32_t>* v : {&node_, &begin_, &count_, &first_child_}) v->reserve(size);
  level_ = {0};
  for (std::uint32_t at = 0; at < size; ++at) {
    if (at == level_.back()) level_.push_back(std::uint32_t(node_.size()));
    const std::uint32_t node = node_[at];
    count_.push_back(tree.light_count(node));
    first_child_.push_back(std::uint32_t(node_.size()));
    std::uint32_t begin = begin_[at];
    for (const std::uint32_t child : tree.children(node)) {
      node_.push_back(child);
      begin_.push_back(begin);
      begin += tree.light_count(child);
    }
  }
  first_child_.push_back(size);
  position_.resize(size);
  for (std::uint32_t at = 0; at < size; ++at) position_[node_[at]] = at;
}

std::uint32_t Icicle::depth() const {
  return level_.empty() ? 0 : std::uint32_t(level_.size() - 1);
}

std::uint32_t Icicle::level_of(std::uint32_t position) const {
  return std::uint32_t(std::upper_bound(level_.begin(), level_.end(), position) - level_.begin()) -
         1;
}

std::uint32_t Icicle::depth_of(std::uint32_t node) const { return level_of(position_[node]); }

/// Among neighbours on one level.
std::uint32_t Icicle::first_ending_after(double light, Range range) const {
  // Most often it is near: looked for in steps that double, then between the last two.
  std::uint32_t step = 1;
  while (range.last - range.first > step && end(range.first + step) <= light) step *= 2;
  if (range.last - range.first > step) range.last = range.first + step;
  while (range.first < range.last) {
    const std::uint32_t middle = range.first + (range.last - range.first) / 2;
    if (end(middle) <= light)
      range.first = middle + 1;
    else
      range.last = middle;
  }
  return range.first;
}

std::optional<std::uint32_t> Icicle::position_at(std::uint32_t level, double light) const {
  const std::uint32_t last = level_[level + 1];
  const std::uint32_t at = first_ending_after(light, {level_[level], last});
  if (at == last || begin_[at] > light) return std::nullopt;
  return at;
}

/// Calls wide(position) and narrow(range) for neighbours on one level that are in the window, from
/// left to right, skipping all within a pixel at once.
template <class Wide, class Narrow>
void Icicle::scan(const Canvas& canvas, Range range, Wide&& wide, Narrow&& narrow) const {
  std::uint32_t at = first_ending_after(canvas.begin, range);
  while (at < range.last && begin_[at] < canvas.end) {
    if (count_[at] == 0) {
      at = first_ending_after(begin_[at], {at, range.last});
    } else if (count_[at] >= canvas.pixel) {
      wide(at++);
    } else {
      const double limit = std::min(begin_[at] + canvas.pixel, canvas.end);
      const std::uint32_t next = first_ending_after(limit, {at + 1, range.last});
      narrow(Range{at, next});
      at = next;
    }
  }
}

/// The children of all nodes one level higher that are in the window and not too narrow.
std::vector<Icicle::Range> Icicle::ranges_of_row(const Canvas& canvas, std::uint32_t level) const {
  if (level == 0) return {{0, 1}};
  std::vector<Range> ranges;
  scan(
      canvas, {level_[level - 1], level_[level]},
      [&](std::uint32_t parent) { ranges.push_back(children(parent)); }, [](Range) {});
  return ranges;
}

/// What comes below in return.
std::vector<Icicle::Range> Icicle::add_row(Canvas& canvas, std::uint32_t level,
                                           std::span<const Range> ranges) const {
  std::vector<Range> below;
  Range run{0, 0};
  const auto end_run = [&] {
    if (run.first < run.last) add_run(canvas, level, run);
    run = {0, 0};
  };
  const auto wide = [&](std::uint32_t position) {
    end_run();
    add_node(canvas, level, position);
    below.push_back(children(position));
  };
  const auto narrow = [&](Range more) {
    const bool joins = run.first < run.last && end(run.last - 1) == begin_[more.first];
    if (!joins) {
      end_run();
      run.first = more.first;
    }
    run.last = more.last;
  };
  for (const Range& range : ranges) scan(canvas, range, wide, narrow);
  end_run();
  return below;
}

void Icicle::add_node(Canvas& canvas, std::uint32_t level, std::uint32_t position) const {
  IcicleBlock b = canvas.block(level, begin_[position], end(position));
  b.node = node_[position];
  b.kind = canvas.kind(position, level, begin_[position]);
  canvas.blocks.push_back(b);
}

void Icicle::add_run(Canvas& canvas, std::uint32_t level, Range run) const {
  const std::uint32_t first = begin_[run.first], last = end(run.last - 1);
  IcicleBlock b = canvas.block(level, first, last);
  b.node = node_[run.first];
  b.kind = IcicleBlockKind::merged;
  b.cut_nodes = canvas.cut_nodes(level, first, last);
  canvas.blocks.push_back(b);
}

std::vector<IcicleBlock> Icicle::blocks(const IcicleView& view, const IcicleCut& cut) const {
  Canvas canvas(view, cut, total_);
  const std::uint32_t levels = depth();
  if (view.first_row >= levels) return {};
  const std::uint32_t last = view.first_row + std::min(view.rows, levels - view.first_row);
  std::vector<Range> ranges = ranges_of_row(canvas, view.first_row);
  for (std::uint32_t level = view.first_row; level < last && !ranges.empty(); ++level)
    ranges = add_row(canvas, level, ranges);
  return std::move(canvas.blocks);
}

std::optional<std::uint32_t> Icicle::node_at(const IcicleView& view, glm::vec2 pixel) const {
  const bool inside = pixel.x >= 0 && pixel.x < view.width && pixel.y >= 0 &&
                      pixel.y < float(view.rows) * view.row_height;
  const std::uint32_t level =
      inside ? view.first_row + std::uint32_t(pixel.y / view.row_height) : depth();
  if (level >= depth()) return std::nullopt;
  const Canvas canvas(view, {}, total_);
  const double light = canvas.begin + pixel.x * canvas.pixel;
  const std::optional<std::uint32_t> found = position_at(level, light);
  if (!found) return std::nullopt;
  // Children of a node too narrow are not drawn.
  if (level > 0 && count_[*position_at(level - 1, light)] < canvas.pixel) return std::nullopt;
  return node_[*found];
}

IcicleCut Icicle::cut(std::span<const std::uint32_t> nodes) const {
  IcicleCut result;
  if (total_ == 0) return result;
  for (const std::uint32_t node : nodes) {
    const std::uint32_t at = position_[node];
    if (count_[at] > 0) result.pieces_.push_back({begin_[at], end(at), level_of(at), at});
  }
  std::sort(result.pieces_.begin(), result.pieces_.end(),
            [](const auto& a, const auto& b) { return a.begin < b.begin; });
  return result;
}

glm::dvec2 Icicle::extent(const IcicleView& view, std::uint32_t node) const {
  const Canvas canvas(view, {}, total_);
  const std::uint32_t at = position_[node];
  return {(begin_[at] - canvas.begin) / canvas.pixel, (end(at) - canvas.begin) / canvas.pixel};
}

IcicleView Icicle::clamped(IcicleView view, double x0, double window) const {
  window = std::clamp(window, 1.0 / std::max(total_, 1U), 1.0);
  view.x0 = std::clamp(x0, 0.0, 1 - window);
  view.x1 = std::min(view.x0 + window, 1.0);
  const std::uint32_t levels = depth();
  view.first_row = std::min(view.first_row, levels - std::min(view.rows, levels));
  return view;
}

IcicleView Icicle::zoomed(const IcicleView& view, float x, double factor) const {
  assert(factor > 0);
  const double window = view.x1 - view.x0, share = double(x) / view.width;
  const double zoomed = std::clamp(window / factor, 1.0 / std::max(total_, 1U), 1.0);
  return clamped(view, view.x0 + share * (window - zoomed), zoomed);
}

IcicleView Icicle::panned(const IcicleView& view, float right, int down) const {
  const double window = view.x1 - view.x0;
  IcicleView moved = view;
  moved.first_row = std::uint32_t(std::max<std::int64_t>(std::int64_t(view.first_row) - down, 0));
  return clamped(moved, view.x0 - window * (double(right) / view.width), window);
}

IcicleView Icicle::showing(const IcicleView& view, std::uint32_t node) const {
  if (total_ == 0) return whole(view);
  const std::uint32_t at = position_[node], level = level_of(at);
  IcicleView shown = view;
  if (level < view.first_row || level - view.first_row >= view.rows)
    shown.first_row = level - std::min(level, view.rows / 2);
  const double begin = double(begin_[at]) / total_, width = double(count_[at]) / total_;
  return clamped(shown, begin - width, 3 * width);
}

IcicleView Icicle::whole(const IcicleView& view) const {
  IcicleView all = view;
  all.first_row = 0;
  return clamped(all, 0, 1);
}

} // namespace lightcuts::viz

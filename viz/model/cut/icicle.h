// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <oracle/subjects/topology.h>

namespace lightcuts::viz {

/// The part of an icicle that is shown, and in how many pixels. x runs to the right, y down.
struct IcicleView {
  double x0 = 0, x1 = 1;       ///< the window, 0 <= x0 < x1 <= 1; the root spans [0, 1]
  float width = 1;             ///< of the window, pixels, > 0
  std::uint32_t first_row = 0; ///< depth of the nodes in the row at the top
  std::uint32_t rows = 1;
  float row_height = 16; ///< pixels, > 0
};

enum class IcicleBlockKind {
  above_cut, ///< or beside it, where the cut does not have all lights
  cut,
  below_cut,
  merged ///< neighbours that are narrower than a pixel each
};

/// A rectangle to draw.
struct IcicleBlock {
  std::uint32_t node = 0; ///< of merged ones: the first
  std::uint32_t depth = 0;
  float x0 = 0, x1 = 0;        ///< pixels, within [0, width]
  std::uint32_t row = 0;       ///< depth - first_row
  std::uint32_t lights = 0;    ///< of all that are merged
  std::uint32_t cut_nodes = 0; ///< of merged ones: nodes of the cut that are among or below them
  IcicleBlockKind kind = IcicleBlockKind::above_cut;
};

/// Where a cut lies in an icicle, from left to right; made by Icicle::cut().
class IcicleCut {
  friend class Icicle;
  struct Piece {
    std::uint32_t begin, end; ///< its lights
    std::uint32_t depth, position;
  };
  std::vector<Piece> pieces_;
};

/// A light tree drawn as an icicle: the root on top, below each node its children from left to
/// right, each as wide as its share of the lights. See Kruskal and Landwehr, "Icicle plots".
class Icicle {
public:
  /// Takes time and memory in proportion to the nodes. A tree without lights has no blocks.
  explicit Icicle(const oracle::Topology& tree);

  /// The blocks to be drawn, row by row, from left to right. Children of nodes narrower than a
  /// pixel are left out. Takes time in proportion to the pixels, however large or deep the tree.
  [[nodiscard]] std::vector<IcicleBlock> blocks(const IcicleView& view,
                                                const IcicleCut& cut = {}) const;

  /// The node drawn at this pixel, which may be between two; that very node if it is one of a
  /// merged run. Nothing where nothing is drawn.
  [[nodiscard]] std::optional<std::uint32_t> node_at(const IcicleView& view, glm::vec2 pixel) const;

  /// Where a cut lies; none of its nodes is below another.
  [[nodiscard]] IcicleCut cut(std::span<const std::uint32_t> nodes) const;

  /// Number of rows of the whole tree; 0 without lights.
  [[nodiscard]] std::uint32_t depth() const;
  /// Row of a node.
  [[nodiscard]] std::uint32_t depth_of(std::uint32_t node) const;
  /// Pixels from which to which a node lies, maybe outside the window.
  [[nodiscard]] glm::dvec2 extent(const IcicleView& view, std::uint32_t node) const;

  // Views that are valid whatever is asked for: within [0, 1], one light wide at least, and
  // scrolled no further than the last row.

  /// The view magnified by factor > 0, or reduced where < 1; what is at the pixel x stays there
  /// unless the tree's edge comes into sight.
  [[nodiscard]] IcicleView zoomed(const IcicleView& view, float x, double factor) const;
  /// Moves what is shown by so many pixels to the right and so many rows down.
  [[nodiscard]] IcicleView panned(const IcicleView& view, float right, int down) const;
  /// Scrolled and magnified so that the node is the middle third, or as near to it as edges allow;
  /// its row is in the middle unless it is in sight already.
  [[nodiscard]] IcicleView showing(const IcicleView& view, std::uint32_t node) const;
  /// All of the tree's width, from the root.
  [[nodiscard]] IcicleView whole(const IcicleView& view) const;

private:
  struct Canvas;
  /// Positions first, first + 1 ... last - 1.
  struct Range {
    std::uint32_t first, last;
  };

  [[nodiscard]] std::uint32_t end(std::uint32_t position) const {
    return begin_[position] + count_[position];
  }
  [[nodiscard]] Range children(std::uint32_t position) const {
    return {first_child_[position], first_child_[position + 1]};
  }
  [[nodiscard]] std::uint32_t level_of(std::uint32_t position) const;
  [[nodiscard]] std::uint32_t first_ending_after(double light, Range range) const;
  [[nodiscard]] std::optional<std::uint32_t> position_at(std::uint32_t level, double light) const;
  template <class Wide, class Narrow>
  void scan(const Canvas& canvas, Range range, Wide&& wide, Narrow&& narrow) const;
  [[nodiscard]] std::vector<Range> ranges_of_row(const Canvas& canvas, std::uint32_t level) const;
  [[nodiscard]] std::vector<Range> add_row(Canvas& canvas, std::uint32_t level,
                                           std::span<const Range> ranges) const;
  void add_node(Canvas& canvas, std::uint32_t level, std::uint32_t position) const;
  void add_run(Canvas& canvas, std::uint32_t level, Range run) const;
  [[nodiscard]] IcicleView clamped(IcicleView view, double x0, double window) const;

  // A position is a node's place in breadth-first order: those of a level are neighbours, from left
  // to right, and so are those of a node's children.
  std::vector<std::uint32_t> node_, position_; ///< by position; by node
  std::vector<std::uint32_t> begin_, count_;   ///< its lights, numbered from left to right
  std::vector<std::uint32_t> first_child_;     ///< a position; one more than there are nodes
  std::vector<std::uint32_t> level_;           ///< first position of each, and the end
  std::uint32_t total_ = 0;                    ///< lights
};

} // namespace lightcuts::viz

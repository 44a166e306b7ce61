// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include <oracle/properties/table.h>
#include <oracle/subjects/subject.h>

namespace lightcuts::oracle {

// Where a property is checked.
struct TreeCase;
class PointAnswers;
struct BlockAnswers;
struct CutAnswer;
struct ClusterOdds;
class Draws;
class Invariance;
class PictureCase;
struct RayCase;
struct ProofCase;
struct HistoryCase;

class Recorder;
struct BothSides;
struct TwoCuts;

/// What it means that a property does not hold.
enum class Severity : std::uint8_t {
  violation, ///< a wrong result
  waste      ///< a right one that costs more than it has to
};

/// Who promises that a property holds.
enum class Promise : std::uint8_t {
  light_tree, ///< every right light tree
  library     ///< this library, by its own rules: of others, not to hold is a waste at most
};

/// Nodes begin, begin + 1 ... end - 1 of a tree.
struct NodeRange {
  std::uint32_t begin, end;
};

/// All there is to a property.
struct PropertyInfo {
  const char* name;
  const char* statement; ///< one sentence
  const char* formula;   ///< what is computed; its left side over its right is the ratio
  Severity severity = Severity::violation;
  Promise promise = Promise::light_tree;
  Parts needs = 0; ///< of a subject: nothing is checked where one of them is missing

  // The checks, each at places of one kind; nothing at those where the property says nothing.
  void (*of_subject)(const Subject&, const Recorder&) = nullptr;
  void (*of_tree)(const TreeCase&, const Recorder&) = nullptr;
  void (*of_history)(const HistoryCase&, const Recorder&) = nullptr;
  void (*of_clusters)(const PointAnswers&, NodeRange, const Recorder&) = nullptr;
  void (*of_block)(const BlockAnswers&, const Recorder&) = nullptr;
  void (*of_cut)(const CutAnswer&, const Recorder&) = nullptr;
  void (*of_odds)(const ClusterOdds&, const Recorder&) = nullptr;
  void (*of_point)(const PointAnswers&, const CutConfig&, const Recorder&) = nullptr;
  void (*of_draws)(const Draws&, const Recorder&) = nullptr;
  void (*of_invariance)(const Invariance&, const Recorder&) = nullptr;
  void (*of_picture)(const PictureCase&, const Recorder&) = nullptr;
  void (*of_ray)(const RayCase&, const Recorder&) = nullptr;
  void (*of_proof)(const ProofCase&, const Recorder&) = nullptr;
  void (*of_light)(const ShadingPoint&, const Light&, const Recorder&) = nullptr;
  void (*of_lobe)(const Lobe&, const Recorder&) = nullptr;

  // What explain() shows beyond what it shows of every tree, cluster or cut.
  std::string (*node_rows)(const TreeCase&, std::uint32_t node) = nullptr;
  BothSides (*sides)(const PointAnswers&, std::uint32_t node) = nullptr; ///< default: bound_sides()
  std::string (*parting)(const CutAnswer&) =
      nullptr; ///< where the two sides part; default: message
  TwoCuts (*two_cuts)(const PointAnswers&,
                      const CutConfig&) = nullptr; ///< the cuts that are compared
};

/// The descriptions, each defined in the file of its name.
namespace property {
#define LIGHTCUTS_DECLARED(name) extern const PropertyInfo name;
LIGHTCUTS_PROPERTIES(LIGHTCUTS_DECLARED)
#undef LIGHTCUTS_DECLARED
} // namespace property

} // namespace lightcuts::oracle

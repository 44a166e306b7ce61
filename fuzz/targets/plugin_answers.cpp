// SPDX-License-Identifier: MIT
// What a plug-in answers, without a process: trees and numbers drawn from the bytes, of the size
// that was asked for, mostly. It is judged, and convicted or not; nothing of it may do harm.
#include <bit>
#include <cstring>
#include <vector>

#include <fmt/format.h>

#include <oracle/cases/random_case.h>
#include <oracle/explain/explain.h>
#include <oracle/properties/judge.h>
#include <oracle/subjects/plugin_tree.h>

#include <fuzz/support/target.h>

namespace lightcuts::fuzz {
namespace {

using namespace oracle;
using protocol::Reader;
using protocol::Request;
using protocol::Writer;

/// A binary tree over the lights, as a heap: node i has the children 2i + 1 and 2i + 2.
std::vector<std::byte> description(std::uint32_t lights) {
  const std::uint32_t count = lights > 0 ? 2 * lights - 1 : 0;
  std::vector<protocol::Node> nodes;
  std::vector<std::uint32_t> children, leaves;
  for (std::uint32_t i = 0; i < count; ++i) {
    const bool inner = 2 * i + 2 < count;
    const auto light = std::uint32_t(leaves.size());
    nodes.push_back({std::uint32_t(children.size()),
                     inner ? 2U : 0U,
                     light,
                     inner ? 0U : 1U,
                     protocol::no_node,
                     0,
                     {}});
    if (inner) children.insert(children.end(), {2 * i + 1, 2 * i + 2});
    if (!inner) leaves.push_back(light);
  }
  Writer out;
  for (const std::size_t size : {nodes.size(), children.size(), leaves.size()})
    out.put(std::uint64_t(size));
  out.put(std::span(nodes));
  out.put(std::span(children));
  out.put(std::span(leaves));
  return {out.bytes().begin(), out.bytes().end()};
}

class Answers : public PluginConnection {
public:
  explicit Answers(gen::Dice& dice) : dice_(dice) {}

  std::span<const std::byte> ask(Request request, std::span<const std::byte> payload,
                                 std::uint64_t most, std::string /*about*/) override {
    if (!alive_ || dice_.below(64) == 63) refuse("died");
    answer_ = answer(request, Reader(payload));
    for (int patches = dice_.pick({0, 0, 0, 1, 3}); patches > 0 && !answer_.empty(); --patches)
      patch();
    if (answer_.size() > most) refuse("wrote to the oracle's own connection"); // as processes do
    return answer_;
  }
  [[nodiscard]] bool is_alive() const override { return alive_; }

protected:
  std::string ended(const std::string& what) override {
    alive_ = false;
    return "fuzzed: " + what;
  }

private:
  /// A word becomes another, or what is last goes, or more comes.
  void patch() {
    if (dice_.one_in(8)) return answer_.resize(std::size_t(dice_.below(int(answer_.size()) + 9)));
    const std::size_t words = answer_.size() / 4;
    if (words == 0) return;
    const auto word = dice_.one_in(2) ? std::uint32_t(dice_.between(-2, 8))
                                      : std::bit_cast<std::uint32_t>(dice_.finite_float());
    std::memcpy(answer_.data() + 4 * std::size_t(dice_.below(int(words))), &word, sizeof word);
  }

  /// Numbers of one sort: all alike, small, of any scale, or any bits.
  template <class Number>
  void put_numbers(Writer& out, std::size_t count) {
    const int sort = dice_.below(4);
    const auto same = Number(dice_.finite_float());
    for (std::size_t i = 0; i < count; ++i)
      out.put(sort == 0   ? same
              : sort == 1 ? Number(dice_.below(4)) / 2
              : sort == 2 ? Number(dice_.finite_float())
                          : std::bit_cast<Number>(bits<Number>()));
  }
  template <class Number>
  auto bits() {
    if constexpr (sizeof(Number) == 4)
      return std::uint32_t(dice_.bits());
    else
      return dice_.bits();
  }

  void put_clusters(Writer& out, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      lightcuts_cluster cluster{std::uint32_t(dice_.below(int(nodes_) + 1)), {}};
      for (double& estimate : cluster.estimate) estimate = dice_.finite_float();
      out.put(cluster);
    }
  }
  void put_cut(Writer& out) {
    put_numbers<float>(out, 6);
    out.put(std::uint32_t(dice_.below(4)));
    out.put(std::uint32_t(dice_.below(1000)));
  }
  [[nodiscard]] std::size_t some_clusters() {
    return nodes_ > 0 ? std::size_t(dice_.below(int(nodes_) + 1)) : 0;
  }

  std::vector<std::byte> answer(Request request, Reader in) {
    Writer out;
    switch (request) {
    case Request::build:
      lights_ = in.get<protocol::Build>().count;
      nodes_ = 2 * lights_ - 1;
      out.put(nodes_);
      break;
    case Request::describe:
      return description(lights_);
    case Request::bounds:
    case Request::lower_bounds:
      put_numbers<float>(out, 3 * std::size_t(nodes_));
      break;
    case Request::estimates:
      (void)in.get<lightcuts_point>();
      (void)in.get<std::uint32_t>();
      put_numbers<double>(out, 3 * std::size_t(in.get<std::uint32_t>()));
      break;
    case Request::select:
      put_cut(out);
      put_clusters(out, some_clusters());
      break;
    case Request::draws: {
      (void)in.get<lightcuts_point>();
      (void)in.get<lightcuts_cut_config>();
      for (auto count = in.get<std::uint32_t>(); count > 0; --count) {
        put_cut(out);
        const std::size_t clusters = some_clusters();
        out.put(std::uint64_t(clusters));
        put_clusters(out, clusters);
      }
      break;
    }
    case Request::samples:
      (void)in.get<lightcuts_point>();
      (void)in.get<std::uint32_t>();
      for (auto count = in.get<std::uint32_t>(); count > 0; --count)
        out.put(protocol::Draw{double(dice_.finite_float()),
                               std::uint64_t(dice_.below(int(lights_) + 1))});
      break;
    case Request::probabilities:
      (void)in.get<lightcuts_point>();
      (void)in.get<std::uint32_t>();
      put_numbers<double>(out, in.get<std::uint32_t>());
      break;
    case Request::order:
      out.put(std::uint32_t(dice_.below(2)));
      break;
    }
    return {out.bytes().begin(), out.bytes().end()};
  }

  gen::Dice& dice_;
  bool alive_ = true;
  std::uint32_t lights_ = 0, nodes_ = 0;
  std::vector<std::byte> answer_;
};

class Connections : public PluginConnections {
public:
  explicit Connections(gen::Dice& dice) : dice_(dice) {}
  std::unique_ptr<PluginConnection> take() override { return std::make_unique<Answers>(dice_); }
  void give_back(std::unique_ptr<PluginConnection> /*connection*/) override {}

private:
  gen::Dice& dice_;
};

class FuzzedPlugin : public Subject {
public:
  FuzzedPlugin(gen::Dice& dice, Parts parts)
      : parts_(parts), connections_(std::make_shared<Connections>(dice)) {}

  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] Parts parts() const override { return parts_; }
  [[nodiscard]] std::unique_ptr<SubjectTree> build(const LightSet& lights,
                                                   std::uint64_t seed) const override {
    return plugin_tree(connections_, lights, seed);
  }
  [[nodiscard]] bool refined_before(double bound, double other) const override {
    return bound > other;
  }

private:
  std::string name_ = "fuzzed";
  Parts parts_;
  std::shared_ptr<Connections> connections_;
};

Parts offered(gen::Dice& dice) {
  constexpr Parts all = only(Part::bounds) | only(Part::lower_bounds) | only(Part::estimates) |
                        only(Part::cuts) | only(Part::sampling) | only(Part::refinement_order) |
                        only(Part::random_cuts);
  return dice.one_in(2) ? all : Parts(dice.bits()) & all;
}

void run_plugin_answers(Bytes input) {
  gen::Dice dice(input);
  const Parts parts = offered(dice);
  const FuzzedPlugin plugin(dice, parts);
  const Case on = small_case(dice);
  for (const Light& light : on.lights)
    if (light.kind == LightKind::profile) return; // plug-ins are not given such
  Tally tally;
  check_case(plugin, on, 0, tally);
  for (const Property property : broken(tally))
    if (tally[property].first_violation.empty())
      finding(fmt::format("{} does not say what is wrong", info(property).name));
  if (const auto properties = broken(tally); !properties.empty())
    (void)explain(plugin, {properties.front(), on, tally[properties.front()].first_violation});
}

const Registered plugin_answers({"plugin_answers", run_plugin_answers});

} // namespace
} // namespace lightcuts::fuzz

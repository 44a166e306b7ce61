// SPDX-License-Identifier: MIT
#include <oracle/subjects/plugin_tree.h>

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <oracle/subjects/c_records.h>

namespace lightcuts::oracle {
namespace {

using protocol::Reader;
using protocol::Request;
using protocol::Writer;

std::array<float, 3> array_of(const glm::vec3& v) { return {v.x, v.y, v.z}; }
glm::vec3 vec3_of(const std::array<float, 3>& a) { return {a[0], a[1], a[2]}; }
glm::dvec3 dvec3_of(const double (&a)[3]) { return {a[0], a[1], a[2]}; }

/// Of floats and 32-bit numbers without padding.
template <class T>
bool same_bits(const T& a, const T& b) {
  using Words = std::array<std::uint32_t, sizeof(T) / sizeof(std::uint32_t)>;
  return std::bit_cast<Words>(a) == std::bit_cast<Words>(b);
}

/// What a tree is built from.
struct BuildInput {
  Writer message;
  std::uint32_t light_count;
};

std::shared_ptr<const BuildInput> input_of(const LightSet& lights, std::uint64_t seed) {
  BuildInput input{{}, std::uint32_t(lights.size())};
  input.message.put(protocol::Build{seed, lights.min_distance(), input.light_count});
  for (const Light& light : lights) input.message.put(as_c(light));
  return std::make_shared<const BuildInput>(std::move(input));
}

class PluginTree : public SubjectTree {
public:
  PluginTree(std::shared_ptr<PluginConnections> connections,
             std::shared_ptr<const BuildInput> input)
      : connections_(std::move(connections)), input_(std::move(input)),
        connection_(connections_->take()) {
    Reader answer(connection_->ask(Request::build, input_->message.bytes(), sizeof(std::uint32_t)));
    node_count_ = answer.get<std::uint32_t>();
    require_whole(answer);
    if (node_count_ > protocol::max_nodes(input_->light_count)) unreadable();
  }
  ~PluginTree() override { connections_->give_back(std::move(connection_)); }

  [[nodiscard]] std::unique_ptr<SubjectTree> for_another_thread() const override {
    auto other = std::make_unique<PluginTree>(connections_, input_);
    (void)claim();
    (void)other->claim();
    if (other->description_ != description_)
      other->connection_->refuse("built another tree from the same lights and seed");
    return other;
  }

  [[nodiscard]] TreeClaim claim() const override {
    const std::uint64_t lights = input_->light_count;
    const std::span<const std::byte> bytes =
        connection_->ask(Request::describe, {},
                         3 * sizeof(std::uint64_t) + node_count_ * sizeof(protocol::Node) +
                             sizeof(std::uint32_t) * (protocol::max_indices(node_count_) +
                                                      protocol::max_indices(lights)));
    description_ =
        std::hash<std::string_view>()({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    Reader answer(bytes);
    const auto nodes = answer.get<std::uint64_t>(), child_count = answer.get<std::uint64_t>(),
               light_count = answer.get<std::uint64_t>();
    TreeClaim claim;
    for (const protocol::Node& n : answer.get_many<protocol::Node>(nodes)) {
      claim.nodes.push_back(
          {n.first_child, n.child_count, n.first_light, n.light_count, n.representative, {}});
      if (n.has_intensity != 0)
        claim.nodes.back().intensity = {n.intensity[0], n.intensity[1], n.intensity[2]};
    }
    claim.children = answer.get_many<std::uint32_t>(child_count);
    claim.lights = answer.get_many<std::uint32_t>(light_count);
    require_whole(answer);
    if (nodes != node_count_) unreadable();
    return claim;
  }

  glm::vec3 bound(std::uint32_t node, const ShadingPoint& point) override {
    look_from(point);
    return vec3_of(known_bounds().at(node));
  }

  void bounds(const ShadingPoint& point, std::span<glm::vec3> out) override {
    look_from(point);
    bounds_.clear();
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = vec3_of(known_bounds().at(i));
  }

  glm::vec3 lower_bound(std::uint32_t node, const ShadingPoint& point) override {
    look_from(point);
    if (lower_bounds_.empty()) ask_of_all(Request::lower_bounds, lower_bounds_);
    return vec3_of(lower_bounds_.at(node));
  }

  glm::dvec3 estimate(std::uint32_t node, const ShadingPoint& point,
                      const glm::vec3& bound) override {
    look_from(point);
    const std::array<float, 3> given = array_of(bound);
    if (!same_bits(given, known_bounds().at(node)))
      return dvec3_of(estimates(node, std::span(&given, 1)).front().colour);
    if (estimates_.empty()) estimates_ = estimates(0, known_bounds());
    return dvec3_of(estimates_.at(node).colour);
  }

  Cut select(const ShadingPoint& point, const CutConfig& config,
             const std::function<bool(std::uint32_t)>& visible) override {
    look_from(point);
    message_.put(as_c(config));
    put_visibility(visible);
    Reader answer =
        asked(Request::select, sizeof(protocol::Cut) + node_count_ * sizeof(lightcuts_cluster),
              about(config));
    const auto found = answer.get<protocol::Cut>();
    clusters_.clear();
    while (!answer.is_at_end()) read_cluster(answer);
    require_whole(answer);
    return cut_of(found);
  }

  Cut draw(const ShadingPoint& point, const CutConfig& config, std::uint64_t query,
           const std::function<bool(std::uint32_t)>& visible) override {
    Cut drawn;
    draws(point, config, std::span(&query, 1), visible, [&](const Cut& cut) { drawn = cut; });
    return drawn;
  }

  void draws(const ShadingPoint& point, const CutConfig& config,
             std::span<const std::uint64_t> queries,
             const std::function<bool(std::uint32_t)>& visible,
             const std::function<void(const Cut&)>& take) override {
    constexpr std::size_t most_at_once = 128;
    const std::uint64_t most =
        sizeof(protocol::Cut) + sizeof(std::uint64_t) + node_count_ * sizeof(lightcuts_cluster);
    while (!queries.empty()) {
      const auto some = queries.first(std::min(queries.size(), most_at_once));
      queries = queries.subspan(some.size());
      look_from(point);
      message_.put(as_c(config));
      message_.put(std::uint32_t(some.size()));
      put_visibility(visible);
      message_.put(some);
      Reader answer = asked(Request::draws, some.size() * most, about(config));
      for (std::size_t i = 0; i < some.size(); ++i) {
        const auto found = answer.get<protocol::Cut>();
        clusters_.clear();
        for (auto size = answer.get<std::uint64_t>(); size > 0 && !answer.is_at_end(); --size)
          read_cluster(answer);
        take(cut_of(found));
      }
      require_whole(answer);
    }
  }

  DrawnLight sample(std::uint32_t node, const ShadingPoint& point, double u) override {
    DrawnLight drawn;
    samples(node, point, std::span(&u, 1), std::span(&drawn, 1));
    return drawn;
  }

  void samples(std::uint32_t node, const ShadingPoint& point, std::span<const double> u,
               std::span<DrawnLight> out) override {
    look_from(point);
    message_.put(node);
    message_.put(std::uint32_t(u.size()));
    message_.put(u);
    Reader answer = asked(Request::samples, u.size() * sizeof(protocol::Draw));
    for (DrawnLight& drawn : out.first(u.size())) {
      const auto draw = answer.get<protocol::Draw>();
      drawn = {std::uint32_t(draw.light), draw.probability};
    }
    require_whole(answer);
  }

  double probability(std::uint32_t node, const ShadingPoint& point, std::uint32_t light) override {
    look_from(point);
    if (probabilities_of_ != node) ask_for_probabilities(node);
    if (const auto known = probabilities_.find(light); known != probabilities_.end())
      return known->second;
    return ask_for_probabilities(node, std::span(&light, 1)).front();
  }

private:
  struct Colour {
    double colour[3];
  };
  using Bounds = std::vector<std::array<float, 3>>;

  [[noreturn]] void unreadable() const { connection_->refuse("answered what cannot be read"); }
  void require_whole(const Reader& answer) const {
    if (!answer.is_whole()) unreadable();
  }

  /// Forgets what was known, if the point is another one; it begins the next message.
  void look_from(const ShadingPoint& point) {
    const lightcuts_point next = as_c(point);
    message_.clear();
    message_.put(next);
    if (point_ && same_bits(*point_, next)) return;
    point_ = next;
    bounds_.clear();
    lower_bounds_.clear();
    estimates_.clear();
    probabilities_of_ = protocol::no_node;
  }

  void put_visibility(const std::function<bool(std::uint32_t)>& visible) {
    for (std::uint32_t i = 0; i < input_->light_count; ++i)
      message_.put(std::uint8_t(visible(i) ? 1 : 0));
  }

  void read_cluster(Reader& answer) {
    const auto c = answer.get<lightcuts_cluster>();
    clusters_.push_back({c.node, true, dvec3_of(c.estimate), glm::vec3(0)});
  }

  /// With the clusters that have been read.
  [[nodiscard]] Cut cut_of(const protocol::Cut& found) const {
    if (found.end > LIGHTCUTS_END_MAX_SIZE) unreadable();
    return {vec3_of(found.radiance), vec3_of(found.certified_error), clusters_, found.shadow_rays,
            CutEnd(found.end)};
  }

  /// Sends the message that look_from() has begun.
  Reader asked(Request request, std::uint64_t most, std::string about = {}) {
    return Reader(connection_->ask(request, message_.bytes(), most, std::move(about)));
  }

  static std::string about(const CutConfig& config) {
    return fmt::format(", threshold {}, largest size {}", config.threshold, config.max_size);
  }

  void ask_of_all(Request request, Bounds& out) {
    message_.clear();
    message_.put(*point_);
    Reader answer = asked(request, node_count_ * sizeof(Bounds::value_type));
    out = answer.get_many<Bounds::value_type>(node_count_);
    require_whole(answer);
  }

  const Bounds& known_bounds() {
    if (bounds_.empty()) {
      estimates_.clear();
      ask_of_all(Request::bounds, bounds_);
    }
    return bounds_;
  }

  std::vector<Colour> estimates(std::uint32_t first, std::span<const std::array<float, 3>> of) {
    message_.clear();
    message_.put(*point_);
    message_.put(first);
    message_.put(std::uint32_t(of.size()));
    message_.put(of);
    Reader answer = asked(Request::estimates, of.size() * sizeof(Colour));
    std::vector<Colour> all = answer.get_many<Colour>(of.size());
    require_whole(answer);
    return all;
  }

  std::vector<double> ask_for_probabilities(std::uint32_t node,
                                            std::span<const std::uint32_t> lights) {
    message_.clear();
    message_.put(*point_);
    message_.put(node);
    message_.put(std::uint32_t(lights.size()));
    message_.put(lights);
    Reader answer = asked(Request::probabilities, lights.size() * sizeof(double));
    std::vector<double> all = answer.get_many<double>(lights.size());
    require_whole(answer);
    return all;
  }

  /// Of all lights below the node.
  void ask_for_probabilities(std::uint32_t node) {
    if (!topology_) topology_ = read_topology(claim(), input_->light_count).topology;
    if (!topology_ || node >= topology_->size()) return;
    const std::span<const std::uint32_t> lights = topology_->all_lights(node);
    const std::vector<double> all = ask_for_probabilities(node, lights);
    probabilities_.clear();
    for (std::size_t i = 0; i < lights.size(); ++i) probabilities_.emplace(lights[i], all[i]);
    probabilities_of_ = node;
  }

  std::shared_ptr<PluginConnections> connections_;
  std::shared_ptr<const BuildInput> input_;
  std::unique_ptr<PluginConnection> connection_;
  std::uint32_t node_count_ = 0;
  mutable std::size_t description_ = 0; ///< hash of the last claim()
  std::optional<Topology> topology_;
  Writer message_;
  // Of the last point:
  std::optional<lightcuts_point> point_;
  Bounds bounds_, lower_bounds_;
  std::vector<Colour> estimates_;
  std::uint32_t probabilities_of_ = protocol::no_node;
  std::unordered_map<std::uint32_t, double> probabilities_;
  std::vector<CutCluster> clusters_;
};

} // namespace

std::unique_ptr<SubjectTree> plugin_tree(std::shared_ptr<PluginConnections> plugin,
                                         const LightSet& lights, std::uint64_t seed) {
  return std::make_unique<PluginTree>(std::move(plugin), input_of(lights, seed));
}

} // namespace lightcuts::oracle

// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include <lightcuts/oracle/subject_abi.h>

/// What the oracle and lightcuts-subject-host say to each other over a socket: one request at a
/// time, and its answer. The first answer, to no request, is that to loading the plug-in. Both are
/// of one build, so structures go as they are.
namespace lightcuts::oracle::protocol {

/// File descriptors of the host.
inline constexpr int socket_fd = 3, marker_fd = 4;

enum class Request : std::uint32_t {
  build,         ///< Build, lights -> count of nodes (32 bits); destroys the tree before
  describe,      ///< -> counts of nodes, children and lights (64 bits each), Node..., them
  bounds,        ///< point -> 3 floats of each node
  lower_bounds,  ///< point -> 3 floats of each node
  estimates,     ///< point, first node, count, 3 floats of each -> 3 doubles of each
  select,        ///< point, config, a byte for each light -> Cut, clusters
  draws,         ///< point, config, count, a byte for each light, queries (64 bits) -> of each Cut,
                 ///< count of clusters (64 bits), clusters
  samples,       ///< point, node, count, doubles -> Draw of each
  probabilities, ///< point, node, count, lights -> a double of each
  order          ///< two doubles -> std::uint32_t
};

/// Before each request.
struct RequestHeader {
  Request request;
  std::uint64_t size; ///< bytes that follow
};

enum class Answer : std::uint32_t {
  done,      ///< what the request's comment says follows
  cannot_be, ///< a text follows: what is wrong with what the plug-in answered
};

/// Before each answer.
struct AnswerHeader {
  Answer answer;
  std::uint64_t size;
};

struct Build {
  std::uint64_t seed;
  float min_distance;
  std::uint32_t count;
};

/// As TreeClaim::Node.
struct Node {
  std::uint32_t first_child, child_count, first_light, light_count, representative, has_intensity;
  std::array<double, 3> intensity;
};

struct Cut {
  std::array<float, 3> radiance, certified_error;
  std::uint32_t end, shadow_rays;
};

struct Draw {
  double probability;
  std::uint64_t light;
};

/// What a plug-in runs when it crashes or hangs.
enum class Function : std::uint32_t {
  load,
  lightcuts_subject_v1,
  build,
  destroy,
  node_count,
  children,
  lights,
  representative,
  intensity,
  bound,
  lower_bound,
  estimate,
  select,
  sample,
  probability,
  refined_before,
  draw,
  none,
};
inline constexpr std::array<const char*, std::size_t(Function::none) + 1> function_names{
    "while it was loaded", "in lightcuts_subject_v1()",
    "in build()",          "in destroy()",
    "in node_count()",     "in children()",
    "in lights()",         "in representative()",
    "in intensity()",      "in bound()",
    "in lower_bound()",    "in estimate()",
    "in select()",         "in sample()",
    "in probability()",    "in refined_before()",
    "in draw()",           "between two calls"};

/// Memory that the host shares with the oracle: all that is known when the host is no more.
struct Marker {
  std::atomic<Function> function;
  std::atomic<std::uint32_t> node;
  std::atomic<std::uint64_t> refused_memory; ///< bytes of the last allocation in the question that
                                             ///< was refused; 0: none was
};
inline constexpr std::uint32_t no_node = ~std::uint32_t(0);

/// Most nodes that a tree may have.
[[nodiscard]] inline std::uint64_t max_nodes(std::uint64_t lights) { return 4 * lights + 64; }
/// Most indices that are passed on of the children of all nodes, or the lights of all leaves; a
/// tree has fewer.
[[nodiscard]] inline std::uint64_t max_indices(std::uint64_t count) { return 2 * count + 64; }

/// A message as it grows.
class Writer {
public:
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void put(const T& value) { put(std::span(&value, 1)); }
  template <class T>
  void put(std::span<T> values) {
    const auto* bytes = reinterpret_cast<const std::byte*>(values.data());
    bytes_.insert(bytes_.end(), bytes, bytes + values.size_bytes());
  }
  void put_text(std::string_view text) { put(std::span(text)); }
  void clear() { bytes_.clear(); }
  [[nodiscard]] std::span<const std::byte> bytes() const { return bytes_; }

private:
  std::vector<std::byte> bytes_;
};

/// A header and what follows it in one piece: sent in two, the first would wake the other side for
/// nothing.
template <class Header>
[[nodiscard]] std::vector<std::byte> joined(const Header& header,
                                            std::span<const std::byte> payload) {
  const auto front = std::as_bytes(std::span(&header, 1));
  std::vector<std::byte> message;
  message.reserve(front.size() + payload.size());
  message.insert(message.end(), front.begin(), front.end());
  message.insert(message.end(), payload.begin(), payload.end());
  return message;
}

/// A message as it is read. What is not there reads as 0, and the message is not whole then.
class Reader {
public:
  explicit Reader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <class T>
  requires std::is_trivially_copyable_v<T>
  [[nodiscard]] T get() {
    T value{};
    get(std::span(&value, 1));
    return value;
  }
  template <class T>
  requires std::is_trivially_copyable_v<T>
  void get(std::span<T> out) {
    if (out.size_bytes() > bytes_.size()) {
      whole_ = false;
      return;
    }
    if (!out.empty()) std::memcpy(out.data(), bytes_.data(), out.size_bytes());
    bytes_ = bytes_.subspan(out.size_bytes());
  }
  /// Nothing where they are not all there.
  template <class T>
  [[nodiscard]] std::vector<T> get_many(std::uint64_t count) {
    if (count > bytes_.size() / sizeof(T)) {
      whole_ = false;
      return {};
    }
    std::vector<T> values(count);
    get(std::span(values));
    return values;
  }
  [[nodiscard]] std::string rest() {
    std::string text(reinterpret_cast<const char*>(bytes_.data()), bytes_.size());
    bytes_ = {};
    return text;
  }
  /// Whether nothing is left, or something that was asked for was not there.
  [[nodiscard]] bool is_at_end() const { return !whole_ || bytes_.empty(); }
  /// Whether all that was asked for was there, and nothing else.
  [[nodiscard]] bool is_whole() const { return whole_ && bytes_.empty(); }

private:
  std::span<const std::byte> bytes_;
  bool whole_ = true;
};

} // namespace lightcuts::oracle::protocol

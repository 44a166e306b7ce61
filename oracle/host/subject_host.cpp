// SPDX-License-Identifier: MIT
// lightcuts-subject-host: loads a light tree from a shared library and asks it what the oracle
// wants to know, so that the oracle lives on whatever happens here. Started by PluginSubject.
#include <algorithm>
#include <cfenv>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <string>
#include <thread>

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <oracle/subjects/subject_protocol.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define LIGHTCUTS_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define LIGHTCUTS_SANITIZED
#endif
#endif

namespace lightcuts::oracle::protocol {
namespace {

constexpr float nan_float = std::numeric_limits<float>::quiet_NaN();
constexpr double nan_double = std::numeric_limits<double>::quiet_NaN();

/// What the plug-in answered and cannot be; thrown between two of its functions only.
struct CannotBe {
  std::string text;
};

Marker* marker = nullptr;

void mark(Function function, std::uint32_t node = no_node) {
  marker->node.store(node, std::memory_order_relaxed);
  marker->function.store(function, std::memory_order_relaxed);
}

/// How numbers are rounded and subnormals treated in this process, whatever the plug-in does.
class FloatingPoint {
public:
  FloatingPoint() { fegetenv(&usual_); }
  void restore() const { fesetenv(&usual_); }

private:
  fenv_t usual_{};
};
const FloatingPoint floating_point;

/// Calls a function of the plug-in with a mark set for the oracle to find.
template <class Call>
auto marked(Function function, std::uint32_t node, Call&& call) {
  mark(function, node);
  if constexpr (std::is_void_v<decltype(call())>) {
    call();
    floating_point.restore();
    mark(Function::none);
  } else {
    const auto result = call();
    floating_point.restore();
    mark(Function::none);
    return result;
  }
}

std::string place(Function function, std::uint32_t node) {
  const std::string name = function_names[std::size_t(function)];
  return node == no_node ? name : name + " of node " + std::to_string(node);
}

template <class Call>
void require_done(Function function, std::uint32_t node, Call&& call) {
  if (const int code = marked(function, node, call); code != 0)
    throw CannotBe{"returned " + std::to_string(code) + " " + place(function, node)};
}

// ---- memory

#ifdef LIGHTCUTS_SANITIZED
constexpr bool memory_is_limited = false; // the sanitizer's shadow is larger than any limit
#else
constexpr bool memory_is_limited = true;
#endif

/// The pointer; notes where there is none for so many bytes.
[[maybe_unused]] void* noted(void* pointer, std::size_t bytes) {
  if (pointer == nullptr && bytes != 0 && marker != nullptr)
    marker->refused_memory.store(bytes, std::memory_order_relaxed);
  return pointer;
}

// ---- the socket

/// Ends this process, and all of its group: what the plug-in has started.
[[noreturn]] void end_all() {
  if (getpgrp() == getpid()) kill(0, SIGKILL);
  _exit(0);
}

void read_all(std::span<std::byte> out) {
  while (!out.empty()) {
    const ssize_t n = read(socket_fd, out.data(), out.size());
    if (n <= 0) end_all(); // the oracle is gone
    out = out.subspan(std::size_t(n));
  }
}

void write_all(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t n = write(socket_fd, bytes.data(), bytes.size());
    if (n <= 0) end_all();
    bytes = bytes.subspan(std::size_t(n));
  }
}

void answer(Answer answer, std::span<const std::byte> payload) {
  write_all(joined(AnswerHeader{answer, payload.size()}, payload));
}

void answer_cannot_be(const std::string& text) {
  answer(Answer::cannot_be, std::as_bytes(std::span(text)));
}

/// Ends all when the oracle has ended, whatever the plug-in is doing.
void end_with_oracle() {
  std::thread([] {
    pollfd hung_up{socket_fd, POLLRDHUP, 0};
    while (poll(&hung_up, 1, -1) < 0) {
    }
    end_all();
  }).detach();
}

// ---- the plug-in

/// The functions of the plug-in; those beyond the size of its table are not offered.
lightcuts_subject table_of(const lightcuts_subject* given) {
  if (given == nullptr) throw CannotBe{"lightcuts_subject_v1() returned NULL"};
  if (given->abi_version != LIGHTCUTS_SUBJECT_ABI_VERSION)
    throw CannotBe{"wrong ABI version " + std::to_string(given->abi_version) + ", expected " +
                   std::to_string(LIGHTCUTS_SUBJECT_ABI_VERSION)};
  if (given->size < offsetof(lightcuts_subject, representative))
    throw CannotBe{"a table of " + std::to_string(given->size) +
                   " bytes, expected sizeof(lightcuts_subject), " +
                   std::to_string(sizeof(lightcuts_subject))};
  lightcuts_subject table{};
  std::memcpy(&table, given, std::min<std::size_t>(given->size, sizeof table));
  const auto require = [](bool is_there, const char* name) {
    if (!is_there) throw CannotBe{std::string("no function ") + name + "()"};
  };
  require(table.build != nullptr, "build");
  require(table.destroy != nullptr, "destroy");
  require(table.node_count != nullptr, "node_count");
  require(table.children != nullptr, "children");
  require(table.lights != nullptr, "lights");
  return table;
}

lightcuts_subject load(const char* file) {
  mark(Function::load);
  void* library = dlopen(file, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    std::string why = dlerror();
    if (const std::string prefix = std::string(file) + ": "; why.starts_with(prefix))
      why.erase(0, prefix.size());
    throw CannotBe{"cannot be loaded: " + why};
  }
  void* symbol = dlsym(library, "lightcuts_subject_v1");
  if (symbol == nullptr)
    throw CannotBe{"does not export lightcuts_subject_v1(); see lightcuts/oracle/subject_abi.h"};
  using Entry = const lightcuts_subject* (*)();
  const auto entry = reinterpret_cast<Entry>(symbol);
  mark(Function::lightcuts_subject_v1);
  const lightcuts_subject table = table_of(entry());
  floating_point.restore(); // of -ffast-math, loading alone changes it
  mark(Function::none);
  return table;
}

/// Which parts there are, as Parts, and the name.
void answer_loaded(const lightcuts_subject& s) {
  Writer out;
  const auto bit = [](bool is_there, unsigned part) { return is_there ? part : 0; };
  const bool bounds = s.bound != nullptr;
  // In the order of Part.
  out.put(bit(bounds, 1) | bit(bounds && s.lower_bound != nullptr, 2) |
          bit(bounds && s.estimate != nullptr, 4) | bit(s.select != nullptr, 8) |
          bit(s.sample != nullptr && s.probability != nullptr, 16) |
          bit(s.refined_before != nullptr, 32) |
          bit(s.draw != nullptr && s.sample != nullptr && s.probability != nullptr, 256));
  if (s.name != nullptr) out.put_text(std::string_view(s.name, strnlen(s.name, 100)));
  answer(Answer::done, out.bytes());
}

/// Answers requests one after another.
class Host {
public:
  explicit Host(const lightcuts_subject& subject) : subject_(subject) {}

  void serve(Request request, Reader in) {
    out_.clear();
    switch (request) {
    case Request::build:
      return build(in);
    case Request::describe:
      return describe();
    case Request::bounds:
      return bounds(Function::bound, subject_.bound, in);
    case Request::lower_bounds:
      return bounds(Function::lower_bound, subject_.lower_bound, in);
    case Request::estimates:
      return estimates(in);
    case Request::select:
      return select(in);
    case Request::draws:
      return draws(in);
    case Request::samples:
      return samples(in);
    case Request::probabilities:
      return probabilities(in);
    case Request::order:
      return order(in);
    }
  }
  [[nodiscard]] std::span<const std::byte> result() const { return out_.bytes(); }

private:
  void build(Reader in) {
    if (tree_ != nullptr) marked(Function::destroy, no_node, [&] { subject_.destroy(tree_); });
    tree_ = nullptr;
    const auto wanted = in.get<Build>();
    light_count_ = wanted.count;
    const auto lights = in.get_many<lightcuts_light>(wanted.count);
    tree_ = marked(Function::build, no_node, [&] {
      return subject_.build(lights.data(), wanted.count, wanted.min_distance, wanted.seed);
    });
    if (tree_ == nullptr) throw CannotBe{"returned NULL in build()"};
    const std::uint32_t nodes =
        marked(Function::node_count, no_node, [&] { return subject_.node_count(tree_); });
    if (nodes > max_nodes(light_count_))
      throw CannotBe{"returned " + std::to_string(nodes) + " in node_count() for " +
                     std::to_string(light_count_) + " lights"};
    node_count_ = nodes;
    out_.put(node_count_);
  }

  using List = uint32_t (*)(void* tree, uint32_t node, uint32_t* out, uint32_t capacity);

  /// Appends what the plug-in lists; of an absurd number nothing, which cannot be read, then.
  std::uint32_t append(Function function, List list, std::uint32_t node, std::uint32_t most,
                       std::vector<std::uint32_t>& all) {
    const std::uint32_t count =
        marked(function, node, [&] { return list(tree_, node, scratch_.data(), most); });
    if (count > most) return count;
    const auto end = scratch_.begin() + count;
    if (all.size() + count <= max_indices(most)) all.insert(all.end(), scratch_.begin(), end);
    std::fill(scratch_.begin(), end, no_node);
    return count;
  }

  Node node(std::uint32_t i, std::vector<std::uint32_t>& children,
            std::vector<std::uint32_t>& lights) {
    Node n{std::uint32_t(children.size()), 0, std::uint32_t(lights.size()), 0, no_node, 0, {}};
    n.child_count = append(Function::children, subject_.children, i, node_count_, children);
    if (n.child_count == 0)
      n.light_count = append(Function::lights, subject_.lights, i, light_count_, lights);
    if (subject_.representative != nullptr) {
      n.representative = no_node - 1; // of what is not written
      require_done(Function::representative, i,
                   [&] { return subject_.representative(tree_, i, &n.representative); });
    }
    if (subject_.intensity != nullptr) {
      n.has_intensity = 1;
      n.intensity.fill(nan_double);
      require_done(Function::intensity, i,
                   [&] { return subject_.intensity(tree_, i, n.intensity.data()); });
    }
    return n;
  }

  void describe() {
    std::vector<Node> nodes;
    std::vector<std::uint32_t> children, lights;
    nodes.reserve(node_count_);
    scratch_.assign(std::max(node_count_, light_count_), no_node);
    for (std::uint32_t i = 0; i < node_count_; ++i) nodes.push_back(node(i, children, lights));
    for (const std::size_t size : {nodes.size(), children.size(), lights.size()})
      out_.put(std::uint64_t(size));
    out_.put(std::span(nodes));
    out_.put(std::span(children));
    out_.put(std::span(lights));
  }

  using Bound = int (*)(void*, uint32_t, const lightcuts_point*, float*);

  void bounds(Function function, Bound bound, Reader in) {
    const auto point = in.get<lightcuts_point>();
    for (std::uint32_t i = 0; i < node_count_; ++i) {
      std::array<float, 3> value{nan_float, nan_float, nan_float};
      require_done(function, i, [&] { return bound(tree_, i, &point, value.data()); });
      out_.put(value);
    }
  }

  void estimates(Reader in) {
    const auto point = in.get<lightcuts_point>();
    const auto first = in.get<std::uint32_t>(), count = in.get<std::uint32_t>();
    for (std::uint32_t i = first; i < first + count; ++i) {
      const auto bound = in.get<std::array<float, 3>>();
      std::array<double, 3> value{nan_double, nan_double, nan_double};
      require_done(Function::estimate, i,
                   [&] { return subject_.estimate(tree_, i, &point, bound.data(), value.data()); });
      out_.put(value);
    }
  }

  /// What the plug-in asks for lights is counted, and answered from what the oracle sent.
  struct Visibility {
    std::vector<std::uint8_t> lights;
    std::uint32_t calls = 0, beyond = no_node;

    static int visible(void* context, std::uint32_t light) {
      auto& self = *static_cast<Visibility*>(context);
      ++self.calls;
      if (light < self.lights.size()) return self.lights[light] != 0 ? 1 : 0;
      self.beyond = light;
      return 0;
    }
  };

  /// A cut that call(visibility, cut) makes, with its clusters in clusters_.
  template <class Call>
  std::pair<Cut, std::uint32_t> cut_by(Function function, Visibility& seen, Call&& call) {
    seen.calls = 0;
    const lightcuts_visibility visibility{&Visibility::visible, &seen};
    clusters_.assign(node_count_, {no_node, {nan_double, nan_double, nan_double}});
    lightcuts_cut cut{{nan_float, nan_float, nan_float},
                      {nan_float, nan_float, nan_float},
                      no_node,
                      no_node,
                      node_count_,
                      clusters_.data()};
    require_done(function, no_node, [&] { return call(&visibility, &cut); });
    const std::string where = place(function, no_node);
    if (cut.size > node_count_)
      throw CannotBe{"returned a cut of " + std::to_string(cut.size) + " clusters " + where +
                     ", of " + std::to_string(node_count_) + " nodes"};
    if (cut.end > LIGHTCUTS_END_MAX_SIZE)
      throw CannotBe{"returned end " + std::to_string(cut.end) + " " + where};
    if (seen.beyond != no_node)
      throw CannotBe{"asked " + where + " whether light " + std::to_string(seen.beyond) + " of " +
                     std::to_string(light_count_) + " is visible"};
    return {{std::to_array(cut.radiance), std::to_array(cut.certified_error), cut.end, seen.calls},
            cut.size};
  }

  void select(Reader in) {
    const auto point = in.get<lightcuts_point>();
    const auto config = in.get<lightcuts_cut_config>();
    Visibility seen{in.get_many<std::uint8_t>(light_count_)};
    const auto [cut, size] = cut_by(Function::select, seen, [&](auto* visibility, auto* out) {
      return subject_.select(tree_, &point, &config, visibility, out);
    });
    out_.put(cut);
    out_.put(std::span(clusters_).first(size));
  }

  void draws(Reader in) {
    const auto point = in.get<lightcuts_point>();
    const auto config = in.get<lightcuts_cut_config>();
    const auto count = in.get<std::uint32_t>();
    Visibility seen{in.get_many<std::uint8_t>(light_count_)};
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto query = in.get<std::uint64_t>();
      const auto [cut, size] = cut_by(Function::draw, seen, [&](auto* visibility, auto* out) {
        return subject_.draw(tree_, &point, &config, query, visibility, out);
      });
      const auto clusters = std::span(clusters_).first(size);
      for (const lightcuts_cluster& c : clusters) // no property of cuts judges these
        if (c.node >= node_count_)
          throw CannotBe{"returned node " + std::to_string(c.node) + " of " +
                         std::to_string(node_count_) + " in draw()"};
      out_.put(cut);
      out_.put(std::uint64_t(size));
      out_.put(clusters);
    }
  }

  void samples(Reader in) {
    const auto point = in.get<lightcuts_point>();
    const auto node = in.get<std::uint32_t>(), count = in.get<std::uint32_t>();
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto u = in.get<double>();
      Draw draw{nan_double, no_node};
      std::uint32_t light = no_node;
      require_done(Function::sample, node, [&] {
        return subject_.sample(tree_, node, &point, u, &light, &draw.probability);
      });
      draw.light = light;
      out_.put(draw);
    }
  }

  void probabilities(Reader in) {
    const auto point = in.get<lightcuts_point>();
    const auto node = in.get<std::uint32_t>(), count = in.get<std::uint32_t>();
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto light = in.get<std::uint32_t>();
      double probability = nan_double;
      require_done(Function::probability, node,
                   [&] { return subject_.probability(tree_, node, &point, light, &probability); });
      out_.put(probability);
    }
  }

  void order(Reader in) {
    const auto bound = in.get<double>(), other = in.get<double>();
    const int before = marked(Function::refined_before, no_node,
                              [&] { return subject_.refined_before(bound, other); });
    out_.put(std::uint32_t(before != 0 ? 1 : 0));
  }

  lightcuts_subject subject_;
  void* tree_ = nullptr;
  std::uint32_t light_count_ = 0, node_count_ = 0;
  std::vector<std::uint32_t> scratch_; ///< for lists; what is not written stays no_node
  std::vector<lightcuts_cluster> clusters_;
  Writer out_;
};

[[noreturn]] void serve_all(Host& host) {
  std::vector<std::byte> payload;
  for (;;) {
    RequestHeader header{};
    read_all(std::as_writable_bytes(std::span(&header, 1)));
    payload.resize(header.size);
    read_all(payload);
    marker->refused_memory.store(0, std::memory_order_relaxed);
    try {
      host.serve(header.request, Reader(payload));
    } catch (const CannotBe& error) {
      answer_cannot_be(error.text);
      continue;
    }
    answer(Answer::done, host.result());
  }
}

/// Keeps what the plug-in may map within so many bytes.
void limit_memory(rlim_t bytes) {
  rlimit limit{};
  if (!memory_is_limited || getrlimit(RLIMIT_AS, &limit) != 0) return;
  limit.rlim_cur = std::min(bytes, limit.rlim_max);
  setrlimit(RLIMIT_AS, &limit);
}

/// Signals as a program has them, no cores, and the first to go where memory runs out.
void be_expendable() {
  for (const int number : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP})
    std::signal(number, SIG_DFL);
  std::signal(SIGPIPE, SIG_IGN);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  std::ofstream("/proc/self/oom_score_adj") << 1000;
}

int run(const char* file, const char* memory_limit) {
  void* shared = mmap(nullptr, sizeof(Marker), PROT_READ | PROT_WRITE, MAP_SHARED, marker_fd, 0);
  if (shared == MAP_FAILED) return 1;
  marker = static_cast<Marker*>(shared);
  be_expendable();
  end_with_oracle();
  limit_memory(std::strtoull(memory_limit, nullptr, 10));
  lightcuts_subject table{};
  try {
    table = load(file);
  } catch (const CannotBe& error) {
    answer_cannot_be(error.text);
    return 0;
  }
  answer_loaded(table);
  Host host(table);
  serve_all(host);
}

} // namespace
} // namespace lightcuts::oracle::protocol

// Those of the C library, which the plug-in and all libraries call here instead, operator new among
// them: all that they allocate but what they ask the kernel for themselves.
#if defined(__GLIBC__) && !defined(LIGHTCUTS_SANITIZED)
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

void* malloc(std::size_t size) noexcept {
  return lightcuts::oracle::protocol::noted(__libc_malloc(size), size);
}
void* calloc(std::size_t count, std::size_t size) noexcept {
  return lightcuts::oracle::protocol::noted(__libc_calloc(count, size), count * size);
}
void* realloc(void* old, std::size_t size) noexcept {
  return lightcuts::oracle::protocol::noted(__libc_realloc(old, size), size);
}
void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return lightcuts::oracle::protocol::noted(__libc_memalign(alignment, size), size);
}
}
#endif

int main(int argc, char** argv) {
  if (argc != 3 || fcntl(lightcuts::oracle::protocol::socket_fd, F_GETFD) < 0) {
    std::fputs("lightcuts-subject-host: to be started by lightcuts-oracle only\n", stderr);
    return 2;
  }
  return lightcuts::oracle::protocol::run(argv[1], argv[2]);
}

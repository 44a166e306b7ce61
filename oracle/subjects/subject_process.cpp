// SPDX-License-Identifier: MIT
#include <oracle/subjects/subject_process.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <new>
#include <system_error>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <lightcuts/core/jobs/seconds_since.h>
#include <oracle/subjects/process_clock.h>
#include <oracle/subjects/subject.h>

extern char** environ;

namespace lightcuts::oracle {
namespace {

[[noreturn]] void throw_errno(const char* what) {
  throw std::system_error(errno, std::generic_category(), what);
}

/// A file descriptor, closed at the end.
class Descriptor {
public:
  explicit Descriptor(int fd) : fd_(fd) {}
  ~Descriptor() {
    if (fd_ >= 0) close(fd_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int get() const { return fd_; }
  [[nodiscard]] int release() { return std::exchange(fd_, -1); }
  /// One above all that the host has.
  [[nodiscard]] int moved_up() const {
    const int fd = fcntl(fd_, F_DUPFD_CLOEXEC, 10);
    if (fd < 0) throw_errno("fcntl");
    return fd;
  }

private:
  int fd_;
};

/// What the host is to have, of numbers above those that it will have.
struct HostDescriptors {
  int socket, marker, output;
};

pid_t spawn(const PluginConfig& config, const std::filesystem::path& plugin,
            const HostDescriptors& given) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, given.output, 1);
  posix_spawn_file_actions_adddup2(&actions, given.output, 2);
  posix_spawn_file_actions_adddup2(&actions, given.socket, protocol::socket_fd);
  posix_spawn_file_actions_adddup2(&actions, given.marker, protocol::marker_fd);
  posix_spawn_file_actions_addclosefrom_np(&actions, protocol::marker_fd + 1);
  // A group of its own, so that what the plug-in starts ends with it.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP | POSIX_SPAWN_SETSIGMASK);
  posix_spawnattr_setpgroup(&attributes, 0);
  sigset_t none;
  sigemptyset(&none);
  posix_spawnattr_setsigmask(&attributes, &none);
  std::string arguments[] = {config.host, plugin, std::to_string(config.memory_limit)};
  char* argv[] = {arguments[0].data(), arguments[1].data(), arguments[2].data(), nullptr};
  pid_t pid = -1;
  const int error = posix_spawn(&pid, argv[0], &actions, &attributes, argv, environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) throw std::system_error(error, std::generic_category(), argv[0]);
  return pid;
}

/// "512 MiB": in the largest unit of which it is a whole number.
std::string memory_text(std::uint64_t bytes) {
  constexpr const char* units[] = {"bytes", "KiB", "MiB", "GiB", "TiB"};
  std::size_t unit = 0;
  while (unit + 1 < std::size(units) && bytes != 0 && bytes % 1024 == 0) {
    bytes /= 1024;
    ++unit;
  }
  return fmt::format("{} {}", bytes, units[unit]);
}

} // namespace

/// When a question has taken too long. Where the machine is busy a process may have had no
/// processor for that long: one that wants it, and has had less than half of the time, is given
/// more.
class SubjectProcess::Deadline {
public:
  Deadline(double seconds, pid_t process)
      : limit_(seconds), process_(process), had_before_(processor_seconds(process)) {}

  /// For poll(); 0 once it has passed.
  [[nodiscard]] int milliseconds_left() const {
    const double left = std::ceil(1e3 * (limit_ * turns_ - seconds_since(start_)));
    return int(std::clamp(left, 0.0, 1e9));
  }
  /// Puts it off, if the process was kept waiting.
  [[nodiscard]] bool is_put_off() {
    constexpr int most_turns = 30; // wall time in which any machine gets round to it
    const double had = processor_seconds(process_) - had_before_;
    if (turns_ >= most_turns || had >= 0.5 * limit_ || !wants_processor_now_and_then())
      return false;
    ++turns_;
    return true;
  }

private:
  /// A process that is kept waiting may be seen just where it waits for the oracle.
  [[nodiscard]] bool wants_processor_now_and_then() const {
    constexpr int looks = 20;
    for (int i = 0; i < looks; ++i) {
      if (wants_processor(process_)) return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    return false;
  }

  double limit_;
  pid_t process_;
  double had_before_; ///< processor time, seconds
  Clock::time_point start_ = Clock::now();
  int turns_ = 1;
};

void PluginOutput::pass_on(std::string_view text) {
  const std::lock_guard lock(mutex_);
  const std::string_view some = text.substr(0, left_);
  left_ -= some.size();
  const auto print = [](std::string_view t) { std::fwrite(t.data(), 1, t.size(), stderr); };
  print(some);
  if (some.size() == text.size() || said_) return;
  said_ = true;
  print(fmt::format("\n{}: prints more than {}, which is left out\n", name_, memory_text(most)));
}

SubjectProcess::SubjectProcess(const std::filesystem::path& plugin, const PluginConfig& config,
                               std::shared_ptr<PluginOutput> output)
    : name_(plugin.filename().string()), config_(config), output_(std::move(output)) {
  try {
    start(plugin);
  } catch (...) {
    kill();
    throw;
  }
}

SubjectProcess::~SubjectProcess() { kill(); }

void SubjectProcess::start(const std::filesystem::path& plugin) {
  const Descriptor memory(memfd_create("lightcuts-marker", MFD_CLOEXEC));
  if (memory.get() < 0 || ftruncate(memory.get(), sizeof(protocol::Marker)) != 0)
    throw_errno("memfd_create");
  void* shared =
      mmap(nullptr, sizeof(protocol::Marker), PROT_READ | PROT_WRITE, MAP_SHARED, memory.get(), 0);
  if (shared == MAP_FAILED) throw_errno("mmap");
  marker_ = new (shared) protocol::Marker{protocol::Function::load, protocol::no_node, 0};
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) throw_errno("socketpair");
  socket_ = ends[0];
  const Descriptor theirs(ends[1]);
  if (fcntl(socket_, F_SETFL, O_NONBLOCK) != 0) throw_errno("fcntl");
  int pipe_ends[2];
  if (pipe2(pipe_ends, O_CLOEXEC) != 0) throw_errno("pipe2");
  printed_ = pipe_ends[0];
  const Descriptor written(pipe_ends[1]);
  if (fcntl(printed_, F_SETFL, O_NONBLOCK) != 0) throw_errno("fcntl");
  const Descriptor socket_above(theirs.moved_up()), memory_above(memory.moved_up()),
      written_above(written.moved_up());
  pid_ = spawn(config_, plugin, {socket_above.get(), memory_above.get(), written_above.get()});
}

void SubjectProcess::kill() {
  if (socket_ >= 0) close(std::exchange(socket_, -1));
  if (pid_ > 0) {
    ::kill(-pid_, SIGKILL);
    ::kill(pid_, SIGKILL); // it may have left its group
    waitpid(std::exchange(pid_, -1), nullptr, 0);
  }
  read_printed();
  if (printed_ >= 0) close(std::exchange(printed_, -1));
  if (marker_ != nullptr) munmap(std::exchange(marker_, nullptr), sizeof(protocol::Marker));
}

/// Passes on what the plug-in has printed so far; of one that goes on printing, more than a pipe
/// holds.
void SubjectProcess::read_printed() {
  char text[4096];
  for (int i = 0; i < 64 && printed_ >= 0; ++i) {
    const ssize_t n = read(printed_, text, sizeof text);
    if (n > 0)
      output_->pass_on({text, std::size_t(n)});
    else if (n == 0 || (errno != EINTR && errno != EAGAIN))
      close(std::exchange(printed_, -1));
    else if (errno == EAGAIN)
      return;
  }
}

std::string SubjectProcess::place() const {
  const auto function = std::min(std::size_t(marker_->function.load()),
                                 std::size_t(protocol::Function::none)); // whoever wrote there
  const std::uint32_t node = marker_->node.load();
  const char* name = protocol::function_names[function];
  return (node == protocol::no_node ? name : fmt::format("{} of node {}", name, node)) + about_;
}

/// What is to be said where the plug-in was refused memory in its last question.
std::string SubjectProcess::refused_memory() const {
  const std::uint64_t bytes = marker_->refused_memory.load();
  if (bytes == 0) return {};
  return fmt::format("; its memory limit of {} was reached: {} more were refused",
                     memory_text(config_.memory_limit), memory_text(bytes));
}

std::string SubjectProcess::ended(const std::string& what) {
  failure_ = fmt::format("{}: {}", name_, what);
  kill();
  return failure_;
}

void SubjectProcess::fail_by_death() {
  int status = 0;
  pid_t gone = 0;
  // It may have closed the connection, or its last words may be on their way.
  for (int i = 0; i < 200 && gone == 0; ++i) {
    gone = waitpid(pid_, &status, WNOHANG);
    if (gone == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  const std::string where = place() + refused_memory();
  if (gone != pid_) refuse("closed the connection to the oracle " + where);
  ::kill(-pid_, SIGKILL); // what it may have started
  pid_ = -1;
  if (WIFSIGNALED(status))
    refuse(fmt::format("crashed (signal {}, {}) {}", WTERMSIG(status), strsignal(WTERMSIG(status)),
                       where));
  refuse(fmt::format("exited with code {} {}", WEXITSTATUS(status), where));
}

void SubjectProcess::wait_for(short event, Deadline& deadline) {
  for (;;) {
    pollfd ready[] = {{socket_, event, 0}, {printed_, POLLIN, 0}}; // -1 is left out
    const int left = deadline.milliseconds_left();
    const int n = poll(ready, std::size(ready), left);
    if (n > 0 && ready[1].revents != 0) read_printed();
    if (n > 0 && ready[0].revents != 0) return;
    if (n < 0 && errno != EINTR) throw_errno("poll");
    if (n >= 0 && left == 0) {
      siginfo_t info{}; // it may be dead, and a process that it started hold the connection
      const int peek = WEXITED | WNOHANG | WNOWAIT;
      if (waitid(P_PID, id_t(pid_), &info, peek) == 0 && info.si_pid == pid_) fail_by_death();
      // It may have come to it since the last poll.
      if (deadline.is_put_off() || (poll(ready, 1, 0) > 0 && ready[0].revents != 0)) continue;
      refuse(fmt::format("hung for {:g} s {}", config_.time_limit, place()));
    }
  }
}

void SubjectProcess::send(std::span<const std::byte> bytes, Deadline& deadline) {
  while (!bytes.empty()) {
    const ssize_t n = ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (n >= 0)
      bytes = bytes.subspan(std::size_t(n));
    else if (errno == EAGAIN || errno == EWOULDBLOCK)
      wait_for(POLLOUT, deadline);
    else if (errno != EINTR)
      fail_by_death();
  }
}

void SubjectProcess::receive(std::span<std::byte> bytes, Deadline& deadline) {
  while (!bytes.empty()) {
    const ssize_t n = recv(socket_, bytes.data(), bytes.size(), 0);
    if (n > 0)
      bytes = bytes.subspan(std::size_t(n));
    else if (n < 0 && (errno == EAGAIN || errno == EWOULDBLOCK))
      wait_for(POLLIN, deadline);
    else if (n == 0 || errno != EINTR)
      fail_by_death();
  }
}

std::span<const std::byte> SubjectProcess::receive_answer(Deadline& deadline, std::uint64_t most) {
  constexpr std::uint64_t longest_text = 4096;
  protocol::AnswerHeader header{};
  receive(std::as_writable_bytes(std::span(&header, 1)), deadline);
  const bool done = header.answer == protocol::Answer::done;
  if (header.size > (done ? most : longest_text)) refuse("wrote to the oracle's own connection");
  answer_.resize(header.size);
  receive(answer_, deadline);
  if (!done) refuse(protocol::Reader(answer_).rest() + refused_memory());
  return answer_;
}

std::span<const std::byte> SubjectProcess::loaded() {
  constexpr std::uint64_t longest_name = 4096;
  Deadline deadline(config_.time_limit, pid_);
  return receive_answer(deadline, longest_name);
}

std::span<const std::byte> SubjectProcess::ask(protocol::Request request,
                                               std::span<const std::byte> payload,
                                               std::uint64_t most, std::string about) {
  if (!is_alive()) throw SubjectFailure(failure_);
  about_ = std::move(about);
  Deadline deadline(config_.time_limit, pid_);
  send(protocol::joined(protocol::RequestHeader{request, payload.size()}, payload), deadline);
  return receive_answer(deadline, most);
}

} // namespace lightcuts::oracle

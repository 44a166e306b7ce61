// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <sys/types.h>

#include <oracle/subjects/plugin_connection.h>
#include <oracle/subjects/plugin_subject.h>

namespace lightcuts::oracle {

/// What a plug-in prints: so much of it goes to stderr. Used by many threads.
class PluginOutput {
public:
  explicit PluginOutput(std::string name) : name_(std::move(name)) {}
  /// Passes on what fits; says once that there was more.
  void pass_on(std::string_view text);

private:
  static constexpr std::size_t most = 64 * 1024; ///< bytes
  std::string name_;
  std::mutex mutex_;
  std::size_t left_ = most;
  bool said_ = false;
};

/// A plug-in in a process of its own, for one thread. Whatever goes wrong with it kills the process
/// and throws SubjectFailure; so does everything asked after that.
class SubjectProcess : public PluginConnection {
public:
  /// Starts config.host with the plug-in.
  SubjectProcess(const std::filesystem::path& plugin, const PluginConfig& config,
                 std::shared_ptr<PluginOutput> output);
  ~SubjectProcess() override;
  SubjectProcess(const SubjectProcess&) = delete;
  SubjectProcess& operator=(const SubjectProcess&) = delete;

  /// The answer to the loading of the plug-in; to be called first.
  [[nodiscard]] std::span<const std::byte> loaded();
  [[nodiscard]] std::span<const std::byte> ask(protocol::Request request,
                                               std::span<const std::byte> payload,
                                               std::uint64_t most, std::string about = {}) override;
  [[nodiscard]] bool is_alive() const override { return pid_ > 0; }

protected:
  std::string ended(const std::string& what) override;

private:
  class Deadline;

  void start(const std::filesystem::path& plugin);
  std::span<const std::byte> receive_answer(Deadline& deadline, std::uint64_t most);
  void send(std::span<const std::byte> bytes, Deadline& deadline);
  void receive(std::span<std::byte> bytes, Deadline& deadline);
  void wait_for(short event, Deadline& deadline);
  void read_printed();
  [[noreturn]] void fail_by_death();
  [[nodiscard]] std::string place() const;
  [[nodiscard]] std::string refused_memory() const;
  void kill();

  std::string name_; ///< the file's
  PluginConfig config_;
  std::shared_ptr<PluginOutput> output_;
  pid_t pid_ = -1;
  int socket_ = -1;
  int printed_ = -1; ///< the end of a pipe; -1 once nobody holds the other one
  protocol::Marker* marker_ = nullptr;
  std::string about_, failure_;
  std::vector<std::byte> answer_;
};

} // namespace lightcuts::oracle

// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>

#include <tests/render/support/temporary_folder.h>

extern char** environ;

namespace lightcuts {

inline std::vector<std::string> with(std::vector<std::string> arguments,
                                     const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// What a run of lightcuts-oracle left.
struct Outcome {
  int exit_code = -1; ///< -1: ended by a signal
  std::string out, err;
};

/// Runs lightcuts-oracle with the arguments in a folder of its own that lives as long as the test.
class OracleProcess {
public:
  OracleProcess() { std::filesystem::create_directory(folder()); }

  /// Where the program runs, and relative names lead.
  [[nodiscard]] std::filesystem::path folder() const { return temporary_.path / "here"; }

  [[nodiscard]] Outcome run(const std::vector<std::string>& arguments) const {
    return run(arguments, temporary_.path / "stdout");
  }

  /// With stdout led to a file of one's own.
  [[nodiscard]] Outcome run(const std::vector<std::string>& arguments,
                            const std::filesystem::path& out) const {
    const auto err = temporary_.path / "stderr";
    return outcome_of(start(arguments, out, err), out, err);
  }

  /// Starts lightcuts-oracle with stdout and stderr led to files of one's own; 0 where that fails.
  [[nodiscard]] pid_t start(const std::vector<std::string>& arguments,
                            const std::filesystem::path& out,
                            const std::filesystem::path& err) const {
    return start(LIGHTCUTS_ORACLE, arguments, out, err);
  }

  /// Starts a program with stdout and stderr led to files of one's own; 0 where that fails.
  [[nodiscard]] pid_t start(const std::string& program, const std::vector<std::string>& arguments,
                            const std::filesystem::path& out,
                            const std::filesystem::path& err) const {
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, folder().c_str());
    constexpr int flags = O_WRONLY | O_CREAT | O_TRUNC | O_NOCTTY;
    posix_spawn_file_actions_addopen(&actions, 1, out.c_str(), flags, 0600);
    posix_spawn_file_actions_addopen(&actions, 2, err.c_str(), flags, 0600);
    std::vector<std::string> copies{program};
    copies.insert(copies.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    for (std::string& a : copies) argv.push_back(a.data());
    argv.push_back(nullptr);
    pid_t child = 0;
    const int failed = posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return failed == 0 ? child : 0;
  }

  /// Waits for what was started with these files; those that are no regular ones are not read.
  [[nodiscard]] static Outcome outcome_of(pid_t child, const std::filesystem::path& out,
                                          const std::filesystem::path& err) {
    int status = 0;
    if (child <= 0 || waitpid(child, &status, 0) != child) return {};
    const auto text = [](const auto& file) {
      return is_regular_file(file) ? content_of(file) : "";
    };
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, text(out), text(err)};
  }

  /// Names of all that is in the folder, however deep.
  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> list;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder()))
      list.push_back(std::filesystem::relative(entry.path(), folder()).string());
    return list;
  }

private:
  TemporaryFolder temporary_;
};

} // namespace lightcuts

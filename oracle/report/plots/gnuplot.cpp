// SPDX-License-Identifier: MIT
#include <oracle/report/plots/gnuplot.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace lightcuts::oracle {
namespace {

namespace fs = std::filesystem;

const char* const preamble = R"(
set terminal svg size 720,440 enhanced linewidth 1.3 background rgb "#ffffff" \
  font "Helvetica,Arial,DejaVu Sans,sans-serif,15"
set encoding utf8
set linetype 1 lc rgb "#0072b2" pt 7 ps 0.6 lw 1.6
set linetype 2 lc rgb "#d55e00" pt 5 ps 0.6 lw 1.6
set linetype 3 lc rgb "#009e73" pt 9 ps 0.7 lw 1.6
set linetype 4 lc rgb "#cc79a7" pt 13 ps 0.7 lw 1.6
set linetype 5 lc rgb "#e69f00" pt 11 ps 0.7 lw 1.6
set linetype 6 lc rgb "#56b4e9" pt 4 ps 0.6 lw 1.6
set linetype 7 lc rgb "#333333" pt 6 ps 0.6 lw 1.6
set linetype cycle 7
set border 3 lc rgb "#555555" lw 0.8
set tics nomirror out scale 0.6 textcolor rgb "#333333"
set grid lc rgb "#e2e2e2" lw 0.6 dt solid
set key outside above left horizontal Left reverse samplen 2 textcolor rgb "#222222"
)";

struct ScratchFolder {
  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "lightcuts-plot-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw std::system_error(errno, std::generic_category(), name);
    path = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;

  fs::path path;
};

std::string content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = std::min(text.find_first_not_of(" \n"), text.size());
  return text.substr(begin, text.find_last_not_of(" \n") + 1 - begin);
}

// Starts `gnuplot -d script` (-d: without the user's settings) with its outputs sent to files.
pid_t start(const fs::path& script, const fs::path& out, const fs::path& err) {
  const int flags = O_WRONLY | O_CREAT | O_TRUNC;
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), flags, 0600);
  ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), flags, 0600);
  std::string program = "gnuplot", option = "-d", file = script.string();
  char* const arguments[] = {program.data(), option.data(), file.data(), nullptr};
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments, ::environ);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT)
    throw std::runtime_error("the program gnuplot, which draws the plots, is not installed");
  if (error != 0) throw std::system_error(error, std::generic_category(), "gnuplot");
  return child;
}

bool succeeded(pid_t child) {
  int status = 0;
  while (::waitpid(child, &status, 0) < 0)
    if (errno != EINTR) return false;
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

} // namespace

std::string gnuplot_svg(const std::string& script) {
  const ScratchFolder folder;
  const fs::path file = folder.path / "plot.gp";
  const fs::path out = folder.path / "plot.svg";
  const fs::path err = folder.path / "messages";
  // Closed before gnuplot reads it.
  std::ofstream(file, std::ios::binary) << preamble << script << "\n";
  const bool fine = succeeded(start(file, out, err));
  std::string svg = content_of(out);
  if (!fine || svg.find("</svg>") == std::string::npos)
    throw std::runtime_error("gnuplot failed: " + trimmed(content_of(err)));
  return svg;
}

std::string gnuplot_quoted(const std::string& text) {
  std::string quoted = "'";
  for (const char c : text) {
    const bool control = static_cast<unsigned char>(c) < 32 || c == 127;
    quoted.append(c == '\'' ? 2 : 1, control ? ' ' : c);
  }
  return quoted + "'";
}

} // namespace lightcuts::oracle

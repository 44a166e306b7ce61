// SPDX-License-Identifier: MIT
// fuzz-replay TARGET FILE-OR-FOLDER...: runs the target once on each file, of folders in the order
// of their names: what a fuzzer has found stays found, with any compiler.
#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include <sys/resource.h>
#include <unistd.h>

#include <fmt/format.h>

#include <fuzz/support/target.h>

namespace {

using namespace lightcuts;

constexpr double most_seconds = 5;
constexpr long most_kib = 2L << 20;

std::array<char, 4096> current{}; ///< the input that is run

/// Says which input it was; the process then ends by the signal.
void say_input(int number) {
  (void)!write(STDERR_FILENO, current.data(), std::string_view(current.data()).size());
  std::signal(number, SIG_DFL);
  std::raise(number);
}

std::vector<std::filesystem::path> files_in(const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path)) return {path};
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(path))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

void replay(const fuzz::Target& target, const std::filesystem::path& file) {
  const std::string line = fmt::format("input: {}\n", file.string());
  current.fill(0);
  line.copy(current.data(), current.size() - 1);
  std::ifstream in(file, std::ios::binary);
  const std::vector<std::uint8_t> bytes(std::istreambuf_iterator<char>(in), {});
  if (!in) fuzz::finding("cannot be read");
  const std::clock_t begun = std::clock();
  target.run(bytes);
  const double seconds = double(std::clock() - begun) / CLOCKS_PER_SEC;
  if (seconds > most_seconds) fuzz::finding(fmt::format("takes {:.1f} s", seconds));
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  if (usage.ru_maxrss > most_kib) fuzz::finding(fmt::format("takes {} KiB", usage.ru_maxrss));
}

} // namespace

int main(int argc, char** argv) {
  const auto all = fuzz::targets();
  const auto target = std::find_if(all.begin(), all.end(), [&](const fuzz::Target& t) {
    return argc > 1 && std::string_view(t.name) == argv[1];
  });
  if (target == all.end()) {
    fmt::print(stderr, "fuzz-replay TARGET FILE-OR-FOLDER...; targets:\n");
    for (const fuzz::Target& t : all) fmt::print(stderr, "  {}\n", t.name);
    return 2;
  }
  for (const int number : {SIGABRT, SIGSEGV, SIGFPE, SIGBUS, SIGILL})
    std::signal(number, say_input);
  std::size_t count = 0;
  for (int i = 2; i < argc; ++i)
    for (const std::filesystem::path& file : files_in(argv[i])) {
      replay(*target, file);
      ++count;
    }
  fmt::print("{}: {} inputs\n", target->name, count);
  return count > 0 ? 0 : 2;
}

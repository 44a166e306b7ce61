// SPDX-License-Identifier: MIT
#include <oracle/options/program.h>

#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include <fcntl.h>

#include <fmt/format.h>

#include <lightcuts/core/input_error.h>
#include <lightcuts/render/files/text.h>

namespace lightcuts::options {
namespace {

/// open() takes the lowest number that is free. stdout is to be no place that can be written; what
/// is said on stderr is lost.
void occupy_closed_streams() {
  constexpr int modes[] = {O_RDONLY, O_RDONLY, O_WRONLY};
  for (int stream = 0; stream < 3; ++stream)
    if (fcntl(stream, F_GETFD) < 0) (void)open("/dev/null", modes[stream]);
}

/// fmt::print() would throw where stderr cannot be written.
void say(const char* name, const std::string& what) {
  std::fputs(fmt::format("{}: {}\n", name, one_line(what)).c_str(), stderr);
}

} // namespace

int run_program(const char* name, const std::function<int()>& work) {
  occupy_closed_streams();
  try {
    return work();
  } catch (const InputError& error) {
    say(name, error.what());
    return bad_input;
  } catch (const std::bad_alloc&) {
    say(name, "out of memory: more was asked for than this machine holds");
    return bad_input;
  } catch (const std::exception& error) {
    say(name, fmt::format("internal error: {}", error.what()));
    return internal_error;
  }
}

} // namespace lightcuts::options

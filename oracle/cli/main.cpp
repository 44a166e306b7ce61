// SPDX-License-Identifier: MIT
// lightcuts-oracle: checks, measures and renders many-light scenes.
#include <cstdio>
#include <iostream>

#include <lightcuts/core/input_error.h>
#include <oracle/cli/command_line.h>
#include <oracle/options/program.h>

int main(int argc, char** argv) {
  using namespace lightcuts;
  return options::run_program("lightcuts-oracle", [&] {
    cli::Action chosen;
    const auto code = cli::read_command_line(argc, argv, chosen, std::cout, std::cerr);
    const int result = code ? *code : chosen();
    if (!std::cout.flush() || std::fflush(stdout) != 0)
      throw InputError(InputFault::unwritable_file, "stdout: cannot be written");
    return result;
  });
}

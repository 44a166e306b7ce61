// SPDX-License-Identifier: MIT
// The arguments of lightcuts-oracle, one on each line: read, not acted on.
#include <sstream>
#include <string>
#include <vector>

#include <oracle/cli/command_line.h>

#include <fuzz/support/target.h>

namespace lightcuts::fuzz {
namespace {

std::vector<std::string> arguments_of(const std::string& text) {
  std::vector<std::string> words{"lightcuts-oracle"};
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    words.push_back(line.substr(0, line.find('\0'))); // as the system passes them
  return words;
}

void run_command_line(Bytes input) {
  const std::vector<std::string> words = arguments_of(text_of(input));
  std::vector<const char*> argv;
  for (const std::string& word : words) argv.push_back(word.c_str());
  argv.push_back(nullptr);
  cli::Action chosen;
  std::ostringstream out, err;
  const auto code = cli::read_command_line(int(words.size()), argv.data(), chosen, out, err);
  if (!code && !chosen) finding("nothing is chosen");
  if (code == 0 && out.str().empty()) finding("neither help nor a command");
  if (code && *code != 0 && (*code != 2 || err.str().empty()))
    finding("no usage, and no word of it");
}

std::string mutated_arguments(const std::string& input, gen::Dice& dice, const Bytewise& bytewise) {
  std::vector<std::string> words = arguments_of(input);
  words.erase(words.begin());
  if (words.empty()) return bytewise(input);
  const std::size_t at = std::size_t(dice.bits() % words.size());
  switch (dice.below(5)) {
  case 0:
    words.erase(words.begin() + std::ptrdiff_t(at));
    break;
  case 1:
    words.push_back(std::string(words[at]));
    break;
  case 2:
    words[at] = dice.pick<const char*>({"0", "1", "1e9", "-1", "50%", "1x1", "640x480", "0x0", "",
                                        "18446744073709551616", "nan", "inf", "1e400", "--"});
    break;
  default:
    words[at] = bytewise(words[at]);
  }
  std::string text;
  for (const std::string& word : words) text += word + "\n";
  return text;
}

const Registered command_line({"command_line", run_command_line, mutated_arguments});

} // namespace
} // namespace lightcuts::fuzz

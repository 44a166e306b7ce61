// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <lightcuts/core/input_error.h>
#include <new_subject_text.h>
#include <oracle/cli/commands.h>
#include <oracle/cli/common.h>
#include <oracle/cli/counterexample_file.h>

namespace lightcuts::cli {
namespace {

/// The example under another name.
std::string text_named(const std::string& name) {
  const std::string its_name = "new_subject";
  std::string text = new_subject_text;
  for (std::size_t at = 0; (at = text.find(its_name, at)) != text.npos; at += name.size())
    text.replace(at, its_name.size(), name);
  return text;
}

/// Throws InputError, naming the file, where it is there already or cannot be written.
void write_new(const std::string& file, const std::string& text) {
  std::FILE* out = std::fopen(file.c_str(), "wx");
  if (out == nullptr)
    throw InputError(InputFault::unwritable_file,
                     file + (errno == EEXIST ? ": is there already, and is not overwritten"
                                             : ": cannot be written"));
  const bool whole = std::fwrite(text.data(), 1, text.size(), out) == text.size();
  if (std::fclose(out) != 0 || !whole)
    throw InputError(InputFault::unwritable_file, file + ": cannot be written");
}

int run(const std::string& name) {
  const std::string file = name + ".c", library = "lib" + name + ".so";
  write_new(file, text_named(name));
  fmt::print("{} is a light tree that is right. What to put your own in place of is marked:\n"
             "  /* REPLACE: ... */\nmake a library of it, and judge it:\n"
             "  cc -shared -fPIC -std=c99 -O2 -I {} {} -o {} -lm\n"
             "  lightcuts-oracle check desk --subject ./{}\n"
             "  lightcuts-oracle stress --subject ./{}\n",
             file, quoted(subject_include_folder), file, library, library, library);
  return all_holds;
}

std::string check_name(const std::string& name) {
  const auto is_plain = [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-';
  };
  return !name.empty() && name.front() != '-' && std::all_of(name.begin(), name.end(), is_plain)
             ? ""
             : "'" + name + "' is not a name of letters, digits, '_' and '-'";
}

} // namespace

void add_new_subject_command(CLI::App& app, Action& chosen) {
  auto name = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand(
      "new-subject",
      "Write NAME.c, a light tree to start one of your own from, and say how to make "
      "a library of it that --subject takes.");
  command->add_option("NAME", *name, "of the file, without .c")->required()->check(check_name);
  command->callback([name, &chosen] { chosen = [name] { return run(*name); }; });
}

} // namespace lightcuts::cli

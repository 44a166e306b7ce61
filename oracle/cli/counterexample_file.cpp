// SPDX-License-Identifier: MIT
#include <oracle/cli/counterexample_file.h>

#include <fmt/format.h>

#include <lightcuts/render/files/output_folder.h>
#include <oracle/counterexamples/counterexample_json.h>

namespace lightcuts::cli {
namespace {

std::string counted(std::size_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

} // namespace

CounterexampleFile::CounterexampleFile(const oracle::Subject& subject,
                                       const std::string& subject_name,
                                       const oracle::Counterexample& found,
                                       const std::filesystem::path& folder, const std::string& name)
    : file_(folder /
            fmt::format("counterexample-{}.json", name.empty() ? info(found.property).name : name)),
      shrunk_(shrunk(subject, found)) {
  OutputFolder output(folder);
  write_file_atomically(output.stage(file_.filename().string()),
                        oracle::counterexample_json({subject_name, shrunk_}));
  output.commit();
}

std::string CounterexampleFile::text() const {
  std::string size =
      counted(shrunk_.on.lights.size(), "light") + ", " + counted(shrunk_.on.views.size(), "view");
  if (!shrunk_.on.triangles.empty())
    size += ", " + counted(shrunk_.on.triangles.size(), "triangle");
  if (const auto least = shrunk_.least_lights; least > 0)
    size += fmt::format(", from {} lights on (with {} it holds, be it without the first, the "
                        "middle or the last)",
                        least, least - 1);
  return fmt::format("\n{} does not hold on {}:\n  {}\nwritten to {}; replay it:\n  {}\n",
                     info(shrunk_.property).name, size, shrunk_.message, file_.string(),
                     replay_command(file_));
}

nlohmann::ordered_json CounterexampleFile::json() const {
  return {{"file", file_.string()},
          {"property", info(shrunk_.property).name},
          {"message", shrunk_.message},
          {"index", shrunk_.index},
          {"lights", shrunk_.on.lights.size()},
          {"least_lights", shrunk_.least_lights > 0 ? nlohmann::ordered_json(shrunk_.least_lights)
                                                    : nlohmann::ordered_json()},
          {"views", shrunk_.on.views.size()},
          {"triangles", shrunk_.on.triangles.size()},
          {"replay", replay_command(file_)}};
}

std::string replay_command(const std::filesystem::path& file) {
  return "lightcuts-oracle replay " + quoted(file.string());
}

std::string quoted(const std::string& text) {
  constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                "-_./:=,+@%";
  if (!text.empty() && text.find_first_not_of(plain) == std::string::npos) return text;
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

} // namespace lightcuts::cli

// SPDX-License-Identifier: MIT
#include <oracle/subjects/plugin_subject.h>

#include <cctype>
#include <map>
#include <mutex>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <lightcuts/core/input_error.h>
#include <lightcuts/render/files/beside_program.h>
#include <oracle/subjects/plugin_tree.h>
#include <oracle/subjects/subject_process.h>

namespace lightcuts::oracle {
namespace {

using protocol::Reader;
using protocol::Request;
using protocol::Writer;

/// The processes of a plug-in that no tree uses, kept for the next.
class Processes : public PluginConnections {
public:
  Processes(std::filesystem::path file, const PluginConfig& config)
      : file_(std::move(file)), config_(config),
        output_(std::make_shared<PluginOutput>(file_.filename().string())) {}

  /// The one that was given back last, so that the next tree is built where the one before was.
  [[nodiscard]] std::unique_ptr<PluginConnection> take() override {
    {
      const std::lock_guard lock(mutex_);
      if (!idle_.empty()) {
        std::unique_ptr<PluginConnection> process = std::move(idle_.back());
        idle_.pop_back();
        return process;
      }
    }
    auto process = started();
    (void)process->loaded();
    return process;
  }
  [[nodiscard]] std::unique_ptr<SubjectProcess> started() const {
    return std::make_unique<SubjectProcess>(file_, config_, output_);
  }
  void give_back(std::unique_ptr<PluginConnection> process) override {
    if (!process->is_alive()) return;
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(process));
  }

private:
  std::filesystem::path file_;
  PluginConfig config_;
  std::shared_ptr<PluginOutput> output_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<PluginConnection>> idle_;
};

class PluginSubject : public Subject {
public:
  PluginSubject(const std::filesystem::path& file, const PluginConfig& config)
      : processes_(std::make_shared<Processes>(std::filesystem::absolute(file), config)) {
    std::unique_ptr<SubjectProcess> process = processes_->started();
    Reader answer(process->loaded());
    parts_ = answer.get<Parts>();
    name_ = file.filename().string();
    if (const std::string own = answer.rest(); !own.empty())
      name_ = fmt::format("{} ({})", printable(own), name_);
    processes_->give_back(std::move(process));
  }

  [[nodiscard]] const std::string& name() const override { return name_; }
  [[nodiscard]] Parts parts() const override { return parts_; }
  [[nodiscard]] bool works_elsewhere() const override { return true; }
  [[nodiscard]] std::unique_ptr<SubjectTree> build(const LightSet& lights,
                                                   std::uint64_t seed) const override {
    return plugin_tree(processes_, lights, seed);
  }
  [[nodiscard]] bool refined_before(double bound, double other) const override {
    const std::lock_guard lock(mutex_);
    const auto [known, is_new] = order_.try_emplace({bound, other}, false);
    if (is_new) {
      try {
        known->second = ask_for_order(bound, other);
      } catch (...) {
        order_.erase(known);
        throw;
      }
    }
    return known->second;
  }

private:
  static std::string printable(std::string text) {
    for (char& c : text)
      if (std::iscntrl(static_cast<unsigned char>(c)) != 0) c = '?';
    return text;
  }

  [[nodiscard]] bool ask_for_order(double bound, double other) const {
    std::unique_ptr<PluginConnection> process = processes_->take();
    Writer message;
    message.put(bound);
    message.put(other);
    Reader answer(process->ask(Request::order, message.bytes(), sizeof(std::uint32_t)));
    const bool before = answer.get<std::uint32_t>() != 0;
    if (!answer.is_whole()) process->refuse("answered what cannot be read");
    processes_->give_back(std::move(process));
    return before;
  }

  std::shared_ptr<Processes> processes_;
  std::string name_;
  Parts parts_ = 0;
  mutable std::mutex mutex_;
  mutable std::map<std::pair<double, double>, bool> order_; ///< what was asked once
};

void require_file(const std::filesystem::path& file) {
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status))
    throw InputError(InputFault::unreadable_file, file.string() + ": no such file");
  if (!std::filesystem::is_regular_file(status))
    throw InputError(InputFault::malformed_file, file.string() + ": not a shared library");
}

} // namespace

std::unique_ptr<Subject> plugin_subject(const std::filesystem::path& file,
                                        const PluginConfig& config) {
  require_file(file);
  PluginConfig complete = config;
  if (complete.host.empty()) complete.host = beside_program(LIGHTCUTS_SUBJECT_HOST);
  try {
    return std::make_unique<PluginSubject>(file, complete);
  } catch (const SubjectFailure& failure) { // which begins with the file's name
    const std::string folder =
        file.string().substr(0, file.string().size() - file.filename().string().size());
    throw InputError(InputFault::unsupported, folder + failure.what());
  }
}

} // namespace lightcuts::oracle

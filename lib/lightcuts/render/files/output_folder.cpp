// SPDX-License-Identifier: MIT
#include <lightcuts/render/files/output_folder.h>

#include <algorithm>
#include <atomic>
#include <fstream>
#include <system_error>

#include <lightcuts/core/input_error.h>
#include <unistd.h>

namespace lightcuts {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& why) {
  throw InputError(InputFault::unwritable_file, path.string() + ": " + why);
}

void check(const std::error_code& error, const fs::path& path, const char* what) {
  if (error) fail(path, std::string(what) + ": " + error.message());
}

// A hidden name that no other object of this or another running process uses.
std::string temporary_name(const fs::path& path) {
  static std::atomic<unsigned> counter{0};
  return "." + path.filename().string() + ".tmp-" + std::to_string(::getpid()) + "-" +
         std::to_string(counter++);
}

fs::path absolute_folder(const fs::path& folder) {
  if (folder.empty()) throw InputError(InputFault::missing, "the output folder has an empty name");
  std::error_code error;
  const fs::path absolute = fs::absolute(folder, error).lexically_normal();
  check(error, folder, "cannot be used");
  return absolute.has_filename() || absolute == absolute.root_path() ? absolute
                                                                     : absolute.parent_path();
}

void remove_quietly(const std::vector<fs::path>& made) {
  std::error_code ignored;
  // Innermost first; a folder that someone else has used meanwhile is not empty and stays.
  std::for_each(made.rbegin(), made.rend(),
                [&ignored](const fs::path& folder) { fs::remove(folder, ignored); });
}

// Makes `folder` with its parents and returns what was missing, outermost first. Errors name
// `wanted`, for which the folder is made.
std::vector<fs::path> make_folders(const fs::path& folder, const fs::path& wanted) {
  std::vector<fs::path> made;
  std::error_code error;
  for (fs::path p = folder; !fs::exists(p, error) && !error && p != p.root_path();)
    made.push_back(p), p = p.parent_path();
  std::reverse(made.begin(), made.end());
  if (!error) fs::create_directories(folder, error);
  if (!error && !fs::is_directory(folder)) error = std::make_error_code(std::errc::not_a_directory);
  if (error) remove_quietly(made);
  check(error, wanted, "cannot make the folder");
  return made;
}

} // namespace

OutputFolder::OutputFolder(const fs::path& final_folder) : final_(absolute_folder(final_folder)) {
  std::error_code error;
  const bool exists = fs::exists(final_, error);
  if (exists && !fs::is_directory(final_, error)) fail(final_, "is not a folder");
  const fs::path home = exists ? final_ : final_.parent_path();
  made_ = make_folders(home, final_);
  temporary_ = home / temporary_name(final_);
  fs::create_directory(temporary_, error);
  if (error) remove_quietly(made_);
  check(error, final_, "cannot be written");
}

OutputFolder::~OutputFolder() {
  std::error_code ignored;
  fs::remove_all(temporary_, ignored);
  remove_quietly(made_);
}

fs::path OutputFolder::stage(const std::string& name) {
  const fs::path file(name);
  if (name.empty() || file.filename() != file || name == "." || name == "..")
    fail(final_ / file, "not the name of a file");
  if (std::find(names_.begin(), names_.end(), name) == names_.end()) names_.push_back(name);
  return temporary_ / name;
}

void OutputFolder::commit() {
  std::error_code error;
  for (const std::string& name : names_) {
    if (!fs::is_regular_file(temporary_ / name, error)) fail(final_ / name, "was not written");
    if (fs::is_directory(final_ / name, error)) fail(final_ / name, "is a folder");
  }
  fs::create_directory(final_, error);
  check(error, final_, "cannot make the folder");
  made_.clear();
  for (const std::string& name : names_) {
    fs::rename(temporary_ / name, final_ / name, error);
    check(error, final_ / name, "cannot be written");
  }
  fs::remove_all(temporary_, error);
}

void write_file_atomically(const fs::path& file, std::string_view content) {
  std::error_code error;
  if (fs::is_directory(file, error)) fail(file, "is a folder");
  // Renaming over a device would replace the device.
  const bool direct = fs::exists(file, error) && !fs::is_regular_file(file, error);
  const fs::path target = direct ? file : fs::weakly_canonical(file, error);
  check(error, file, "cannot be written");
  const fs::path written = direct ? file : target.parent_path() / temporary_name(target);

  std::ofstream stream(written, std::ios::binary);
  stream.write(content.data(), static_cast<std::streamsize>(content.size()));
  stream.close();
  if (!stream) {
    if (!direct) fs::remove(written, error);
    fail(file, "cannot be written");
  }
  if (direct) return;
  fs::rename(written, target, error);
  if (!error) return;
  std::error_code ignored;
  fs::remove(written, ignored);
  check(error, file, "cannot be written");
}

void require_writable(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (fs::is_directory(file)) fail(file, "is a folder, not a file to write");
  if (!fs::is_directory(folder))
    fail(file, "cannot be written: there is no folder " + folder.string());
  if (::access((fs::exists(file) ? file : folder).c_str(), W_OK) != 0)
    fail(file, "cannot be written");
}

} // namespace lightcuts

// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/models/obj/mtl_file.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include <fmt/format.h>

#include <lightcuts/render/io/models/obj/obj_lines.h>

namespace lightcuts {
namespace {

/// Do nothing here, as model_import.h says, and need no note.
constexpr std::array<std::string_view, 8> silent{"ka", "illum",     "ni",      "map_ka",
                                                 "tf", "sharpness", "map_aat", "map_ni"};

/// Would change what is seen: noted.
constexpr std::array<std::string_view, 24> unused{
    "map_ks", "map_ns", "map_d",  "map_tr", "map_tf", "bump",   "map_bump", "norm",
    "map_kn", "disp",   "decal",  "refl",   "pr",     "pm",     "ps",       "pc",
    "pcr",    "aniso",  "anisor", "map_pr", "map_pm", "map_ps", "map_disp", "map_refl"};

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

template <class List>
bool contains(const List& list, std::string_view value) {
  return std::ranges::find(list, value) != list.end();
}

class MtlReader {
public:
  explicit MtlReader(const std::filesystem::path& file) : lines_(file) {}

  MtlFile read() {
    while (lines_.next()) read_statement(lower(lines_.key()));
    if (before_) result_.notes.push_back("statements before the first 'newmtl' left out");
    note_all(unused_, "left out");
    note_all(unknown_, "not known: left out");
    note_all(options_, "of a map left out");
    return std::move(result_);
  }

private:
  void read_statement(const std::string& key) {
    if (key == "newmtl") {
      result_.materials.push_back({.name = lines_.rest()});
    } else if (result_.materials.empty()) {
      before_ = true;
    } else if (contains(unused, key)) {
      unused_.insert(std::string(lines_.key()));
    } else if (!contains(silent, key) && !read_value(key, result_.materials.back())) {
      unknown_.insert(std::string(lines_.key()));
    }
  }

  bool read_value(const std::string& key, MtlMaterial& material) {
    if (key == "kd") {
      if (const auto kd = colour()) material.diffuse = *kd;
    } else if (key == "ks") {
      if (const auto ks = colour()) material.specular = *ks;
    } else if (key == "ke") {
      if (const auto ke = colour()) material.emission = *ke;
      material.has_emission = true;
    } else if (key == "ns") {
      material.exponent = lines_.numbers(1, 1)[0];
    } else if (key == "d") {
      material.opacity = number_after("-halo");
    } else if (key == "tr") {
      material.opacity = 1 - number_after("-halo");
    } else if (key == "map_kd") {
      material.diffuse_map = map();
    } else if (key == "map_ke") {
      material.emission_map = map();
    } else {
      return false;
    }
    return true;
  }

  /// One value stands for three. Nothing where it is given as a spectrum or in CIE XYZ.
  std::optional<glm::vec3> colour() {
    if (lines_.words().size() > 1 &&
        (lines_.words()[1] == "spectral" || lines_.words()[1] == "xyz")) {
      unused_.insert(fmt::format("{} {}", lines_.key(), lines_.words()[1]));
      return std::nullopt;
    }
    if (lines_.words().size() == 2) return glm::vec3(lines_.numbers(1, 1)[0]);
    const auto& values = lines_.numbers(3, 4); // some write an alpha, too
    return glm::vec3(values[0], values[1], values[2]);
  }

  float number_after(std::string_view option) {
    const auto& words = lines_.words();
    if (words.size() == 3 && words[1] == option) {
      float value = 0;
      if (!lines_.read_number(words[2], value))
        lines_.refuse(fmt::format("'{}' is not a number", words[2]));
      return value;
    }
    return lines_.numbers(1, 1)[0];
  }

  MtlMap map() {
    MtlMap map;
    std::size_t word = 1;
    while (word < lines_.words().size() && read_option(word, map)) {
    }
    map.file = lines_.rest(word);
    return map;
  }

  /// Reads the option that begins at the word, which becomes the one after it.
  bool read_option(std::size_t& word, MtlMap& map) {
    const auto& words = lines_.words();
    const std::string_view option = words[word];
    static constexpr std::array<std::string_view, 8> with_value{
        "-blendu", "-blendv", "-bm", "-boost", "-cc", "-imfchan", "-texres", "-type"};
    if (option == "-clamp" && word + 1 < words.size()) {
      map.clamp = words[word + 1] == "on";
      word += 2;
    } else if (option == "-s" || option == "-o" || option == "-t" || option == "-mm") {
      float values[3] = {};
      const std::size_t count = read_numbers(++word, option == "-mm" ? 2 : 3, values);
      if (option == "-s") map.scale = {values[0], count > 1 ? values[1] : 1};
      if (option == "-o") map.offset = {values[0], count > 1 ? values[1] : 0};
      const bool changes = option == "-mm" && (values[0] != 0 || (count > 1 && values[1] != 1));
      if (option == "-t" || changes) options_.insert(std::string(option));
    } else if (contains(with_value, option) && word + 1 < words.size()) {
      // By default, or without a meaning here.
      const bool common = option == "-type" || option == "-imfchan" || words[word + 1] == "on";
      if (!common) options_.insert(std::string(option));
      word += 2;
    } else {
      return false;
    }
    return true;
  }

  /// As many as there are, but the last word is the file's name.
  std::size_t read_numbers(std::size_t& word, std::size_t most, float* values) {
    std::size_t count = 0;
    while (count < most && word + 1 < lines_.words().size() &&
           lines_.read_number(lines_.words()[word], values[count])) {
      ++count;
      ++word;
    }
    if (count == 0) lines_.refuse(fmt::format("'{}' is not a number", lines_.words().back()));
    return count;
  }

  void note_all(const std::set<std::string>& names, const char* what) {
    if (names.empty()) return;
    result_.notes.push_back(fmt::format("{} {}", fmt::join(names, ", "), what));
  }

  ObjLines lines_;
  MtlFile result_;
  bool before_ = false;
  std::set<std::string> unused_, unknown_, options_;
};

} // namespace

MtlFile read_mtl(const std::filesystem::path& file) { return MtlReader(file).read(); }

} // namespace lightcuts

// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/models/obj_check.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <string_view>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>

#include <lightcuts/render/files/text.h>

namespace lightcuts {
namespace {

constexpr std::string_view blanks = " \t\r";

/// A file's lines as words; a line that ends in a backslash goes on in the next.
class LineReader {
public:
  explicit LineReader(const std::filesystem::path& file)
      : file_(file.string()), text_(read_file(file)) {}

  bool next() {
    words_.clear();
    bool more = true;
    const bool any = position_ < text_.size();
    while (more && position_ < text_.size()) more = read_line();
    return any;
  }

  [[nodiscard]] const std::vector<std::string_view>& words() const { return words_; }

  /// The first line's text after its first word.
  [[nodiscard]] std::string rest() const {
    const std::size_t begin =
        line_.find_first_not_of(blanks, words_[0].size() + line_.find(words_[0]));
    if (begin == std::string_view::npos) return {};
    return std::string(line_.substr(begin, line_.find_last_not_of(blanks) + 1 - begin));
  }

  [[noreturn]] void refuse(const std::string& why) const {
    throw InputError(InputFault::malformed_file,
                     one_line(fmt::format("{}:{}: {}", file_, number_, why)));
  }

  /// Whether the word is a number; refuses one beyond float's range.
  [[nodiscard]] bool is_number(std::string_view word) const {
    if (!word.empty() && word[0] == '+') word.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error == std::errc::invalid_argument || end != word.data() + word.size()) return false;
    const bool tiny = error == std::errc::result_out_of_range &&
                      word.find("e-") + word.find("E-") != 2 * std::string_view::npos;
    if ((error != std::errc{} && !tiny) ||
        (std::isfinite(value) && std::abs(value) > std::numeric_limits<float>::max()))
      refuse(fmt::format("{} is out of range", word));
    return true;
  }

  void expect_numbers(std::size_t least, std::size_t most) const {
    const std::size_t count = words_.size() - 1;
    if (count < least || count > most)
      refuse(fmt::format("'{}' with {} values, expected {}", words_[0], count, least));
    for (std::size_t i = 1; i < words_.size(); ++i)
      if (!is_number(words_[i])) refuse(fmt::format("'{}' is not a number", words_[i]));
  }

private:
  bool read_line() {
    const std::size_t end = std::min(text_.find('\n', position_), text_.size());
    std::string_view line = std::string_view(text_).substr(position_, end - position_);
    position_ = end + 1;
    ++number_;
    const std::size_t last = line.find_last_not_of(blanks);
    const bool continues = last != std::string_view::npos && line[last] == '\\';
    if (continues) line = line.substr(0, last);
    line = line.substr(0, line.find('#'));
    if (words_.empty()) line_ = line;
    for (std::size_t at = line.find_first_not_of(blanks); at < line.size();) {
      const std::size_t stop = std::min(line.find_first_of(blanks, at), line.size());
      words_.push_back(line.substr(at, stop - at));
      at = std::min(line.find_first_not_of(blanks, stop), line.size());
    }
    return continues;
  }

  std::string file_, text_;
  std::size_t position_ = 0, number_ = 0;
  std::string_view line_;
  std::vector<std::string_view> words_;
};

/// The positions, texture coordinates and normals seen so far, and the highest index used.
struct Indices {
  std::array<std::int64_t, 3> count{}, highest{};

  void use(const LineReader& reader, std::size_t kind, std::string_view word) {
    std::int64_t index = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
    if (error != std::errc{} || end != word.data() + word.size())
      reader.refuse(fmt::format("'{}' is not an index", word));
    if (index == 0 || -index > count[kind])
      reader.refuse(fmt::format("index {} is out of range", index));
    highest[kind] = std::max(highest[kind], index);
  }

  /// One corner of a face: v, v/vt, v//vn or v/vt/vn. Returns which of the three it has, as bits.
  int use_corner(const LineReader& reader, std::string_view word) {
    int form = 0;
    for (std::size_t kind = 0; kind < 3; ++kind) {
      const std::size_t slash = std::min(word.find('/'), word.size());
      if (slash > 0 || kind == 0) {
        use(reader, kind, word.substr(0, slash));
        form |= 1 << kind;
      }
      if (slash == word.size()) return form;
      word.remove_prefix(slash + 1);
    }
    reader.refuse("a face's corner has more than three indices");
  }
};

void check_mtl(const std::filesystem::path& file) {
  LineReader reader(file);
  while (reader.next()) {
    if (reader.words().empty()) continue;
    const std::string_view key = reader.words()[0];
    if (key == "Kd" || key == "Ks" || key == "Ke") reader.expect_numbers(3, 3);
    if (key == "Ns") reader.expect_numbers(1, 1);
  }
}

void check_face(const LineReader& reader, Indices& indices) {
  if (reader.words().size() < 4)
    reader.refuse(fmt::format("a face with {} corners", reader.words().size() - 1));
  const int form = indices.use_corner(reader, reader.words()[1]);
  for (std::size_t i = 2; i < reader.words().size(); ++i)
    if (indices.use_corner(reader, reader.words()[i]) != form)
      reader.refuse(fmt::format("corner '{}' lacks what the face's first has, or has more",
                                reader.words()[i]));
}

void check_library(const LineReader& reader, const std::filesystem::path& folder,
                   std::vector<std::string>& missing) {
  const std::string name = reader.rest();
  if (name.empty()) reader.refuse("'mtllib' names no file");
  if (!std::filesystem::exists(folder / name))
    missing.push_back(name);
  else
    check_mtl(folder / name);
}

} // namespace

std::vector<std::string> check_obj(const std::filesystem::path& file) {
  LineReader reader(file);
  Indices indices;
  std::vector<std::string> missing;
  while (reader.next()) {
    if (reader.words().empty()) continue;
    const std::string_view key = reader.words()[0];
    if (key == "v") reader.expect_numbers(3, 7);
    if (key == "vn") reader.expect_numbers(3, 3);
    if (key == "vt") reader.expect_numbers(1, 3);
    if (key == "f") check_face(reader, indices);
    if (key == "mtllib") check_library(reader, file.parent_path(), missing);
    if (key == "v") ++indices.count[0];
    if (key == "vt") ++indices.count[1];
    if (key == "vn") ++indices.count[2];
  }
  for (std::size_t kind = 0; kind < 3; ++kind)
    if (indices.highest[kind] > indices.count[kind])
      throw InputError(InputFault::malformed_file,
                       fmt::format("{}: a face uses {} {}, of {}", file.string(),
                                   std::array{"position", "texture coordinate", "normal"}[kind],
                                   indices.highest[kind], indices.count[kind]));
  return missing;
}

} // namespace lightcuts

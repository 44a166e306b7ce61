// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/models/obj/obj_file.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <set>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <lightcuts/core/input_error.h>

#include <lightcuts/render/files/text.h>
#include <lightcuts/render/io/models/mesh_builder.h>
#include <lightcuts/render/io/models/obj/obj_lines.h>
#include <lightcuts/render/io/models/obj/obj_materials.h>
#include <lightcuts/render/io/models/obj/polygon.h>
#include <lightcuts/render/scene/is_finite.h>

namespace lightcuts {
namespace {

constexpr std::uint32_t none = 0xffffffff;

/// Known, and of no meaning here.
constexpr std::array<std::string_view, 17> without_effect{
    "v",     "vt",       "vn",       "mtllib",     "g",         "o",      "s",      "mg", "lod",
    "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj", "usemap", "maplib", "vp"};

float linear_of_srgb(float c) {
  return c <= 0.04045F ? c / 12.92F
                       : static_cast<float>(std::pow((double(c) + 0.055) / 1.055, 2.4));
}

/// All that the statements v, vt and vn say.
struct ObjVertices {
  std::vector<glm::vec3> positions, normals, colours;
  std::vector<glm::vec2> coordinates;
  std::size_t weighted = 0;

  void read_position(ObjLines& lines) {
    const auto& n = lines.numbers(3, 7);
    const glm::vec3 position(n[0], n[1], n[2]);
    if (!is_finite(position))
      lines.refuse(fmt::format("vertex {} is not finite", positions.size()));
    if ((n.size() == 4 || n.size() == 7) && n[3] != 1) ++weighted;
    if (n.size() >= 6) add_colour(lines, {n[n.size() - 3], n[n.size() - 2], n[n.size() - 1]});
    positions.push_back(position);
    if (!colours.empty()) colours.resize(positions.size(), glm::vec3(1));
  }
  void read_coordinates(ObjLines& lines) {
    const auto& n = lines.numbers(1, 3);
    const glm::vec2 uv(n[0], n.size() > 1 ? n[1] : 0);
    if (!std::isfinite(uv.x) || !std::isfinite(uv.y))
      lines.refuse(fmt::format("texture coordinate {} is not finite", coordinates.size()));
    coordinates.push_back(uv);
  }
  void read_normal(ObjLines& lines) {
    const auto& n = lines.numbers(3, 3);
    normals.push_back(unit_or_zero(glm::dvec3(n[0], n[1], n[2])));
  }

private:
  void add_colour(const ObjLines& lines, const glm::vec3& colour) {
    for (int c = 0; c < 3; ++c)
      if (!(colour[c] >= 0 && std::isfinite(colour[c])))
        lines.refuse(
            fmt::format("colour {} of vertex {}, expected 0 or more", colour[c], positions.size()));
    colours.resize(positions.size(), glm::vec3(1));
    colours.emplace_back(linear_of_srgb(colour.x), linear_of_srgb(colour.y),
                         linear_of_srgb(colour.z));
  }
};

/// One corner of a face: indices into ObjVertices, or none.
struct ObjCorner {
  std::uint32_t position = none, coordinates = none, normal = none;

  [[nodiscard]] bool has_form_of(const ObjCorner& other) const {
    return (coordinates == none) == (other.coordinates == none) &&
           (normal == none) == (other.normal == none);
  }
};

class ObjReader {
public:
  ObjReader(const std::filesystem::path& file, const FileAccess& access, Scene& scene)
      : file_(file.string()), scene_(scene), lines_(file), materials_(file, access, scene),
        mesh_(file_, scene) {}

  void read() {
    while (lines_.next()) read_vertex();
    lines_.rewind();
    first_copy_.assign(vertices_.positions.size(), none);
    while (lines_.next()) read_element();
    mesh_.finish();
    materials_.finish();
    add_notes();
  }

private:
  /// A vertex of the mesh that comes of a position.
  struct Copy {
    std::uint32_t coordinates, normal, surface, index, next;
  };

  // First pass: faces may use what comes after them.
  void read_vertex() {
    const std::string_view key = lines_.key();
    if (key == "v") vertices_.read_position(lines_);
    if (key == "vt") vertices_.read_coordinates(lines_);
    if (key == "vn") vertices_.read_normal(lines_);
    if (key == "mtllib") read_libraries();
  }

  void read_libraries() {
    if (lines_.words().size() < 2) lines_.refuse("'mtllib' names no file");
    materials_.read_libraries(lines_.rest(), {lines_.words().begin() + 1, lines_.words().end()});
  }

  void read_element() {
    const std::string_view key = lines_.key();
    if (key == "f" || key == "fo") return read_face();
    if (key == "usemtl") {
      material_ = lines_.words().size() > 1 ? materials_.named(lines_.rest()) : none_given;
    } else if (key == "v" || key == "vt" || key == "vn") {
      ++seen_[key == "v" ? 0 : key == "vt" ? 1 : 2]; // what negative indices count from
    } else if (key == "l" || key == "p") {
      ++lines_and_points_;
    } else if (std::ranges::find(without_effect, key) == without_effect.end() &&
               unknown_.size() < 8) {
      unknown_.emplace(key);
    }
  }

  void read_face() {
    const auto& words = lines_.words();
    if (words.size() < 4) lines_.refuse(fmt::format("a face with {} corners", words.size() - 1));
    corners_.clear();
    for (std::size_t i = 1; i < words.size(); ++i) {
      corners_.push_back(corner(words[i]));
      if (!corners_.back().has_form_of(corners_[0]))
        lines_.refuse(
            fmt::format("corner '{}' lacks what the face's first has, or has more", words[i]));
    }
    if (material_ == none_given) material_ = materials_.unnamed();
    const auto use = materials_.use(material_, corners_[0].coordinates != none);
    if (corners_.size() == 3) return add_triangle({0, 1, 2}, use);
    polygon_.clear();
    for (const ObjCorner& c : corners_) polygon_.push_back(vertices_.positions[c.position]);
    for (const glm::uvec3& t : triangulate(polygon_)) add_triangle(t, use);
  }

  void add_triangle(const glm::uvec3& t, const ObjMaterials::Use& use) {
    mesh_.add_triangle(
        {vertex(corners_[t.x], use), vertex(corners_[t.y], use), vertex(corners_[t.z], use)},
        use.surface);
  }

  /// v, v/vt, v//vn or v/vt/vn.
  ObjCorner corner(std::string_view word) const {
    std::array<std::uint32_t, 3> indices{none, none, none};
    for (std::size_t kind = 0; kind < 3; ++kind) {
      const std::size_t slash = std::min(word.find('/'), word.size());
      if (slash > 0 || kind == 0) indices[kind] = index(kind, word.substr(0, slash));
      if (slash == word.size()) return {indices[0], indices[1], indices[2]};
      word.remove_prefix(slash + 1);
    }
    lines_.refuse("a face's corner has more than three indices");
  }

  /// From 1 on, or from -1 on backwards.
  std::uint32_t index(std::size_t kind, std::string_view word) const {
    const std::size_t counts[3] = {vertices_.positions.size(), vertices_.coordinates.size(),
                                   vertices_.normals.size()};
    constexpr std::array kinds{"position", "texture coordinate", "normal"};
    std::string_view digits = word;
    if (digits.starts_with('+')) digits.remove_prefix(1);
    std::int64_t index = 0;
    const char* const last = digits.data() + digits.size();
    const auto [end, error] = std::from_chars(digits.data(), last, index);
    if (error == std::errc::invalid_argument || end != last || digits.empty())
      lines_.refuse(fmt::format("'{}' is not an index", word));
    if (error != std::errc{} || index == 0 || index < -std::int64_t(seen_[kind]))
      lines_.refuse(fmt::format("index {} is out of range", word));
    if (index > std::int64_t(counts[kind]))
      lines_.refuse(fmt::format("a face uses {} {}, of {}", kinds[kind], index, counts[kind]));
    return static_cast<std::uint32_t>(index > 0 ? index - 1 : std::int64_t(seen_[kind]) + index);
  }

  /// The mesh's vertex for the corner, made where none is alike.
  std::uint32_t vertex(const ObjCorner& corner, const ObjMaterials::Use& use) {
    std::uint32_t& first = first_copy_[corner.position];
    for (std::uint32_t i = first; i != none; i = copies_[i].next)
      if (copies_[i].coordinates == corner.coordinates && copies_[i].normal == corner.normal &&
          copies_[i].surface == use.surface)
        return copies_[i].index;
    MeshVertex made{.position = vertices_.positions[corner.position]};
    if (corner.normal != none) made.normal = vertices_.normals[corner.normal];
    if (use.map) made.uv = coordinates(corner, *use.map);
    if (use.emission_map) made.emission_uv = coordinates(corner, *use.emission_map);
    if (!vertices_.colours.empty()) made.colour = vertices_.colours[corner.position];
    const std::uint32_t index = mesh_.add(made);
    copies_.push_back({corner.coordinates, corner.normal, use.surface, index, first});
    first = static_cast<std::uint32_t>(copies_.size() - 1);
    return index;
  }

  glm::vec2 coordinates(const ObjCorner& corner, const MtlMap& map) const {
    const glm::vec2 uv = map.scale * vertices_.coordinates[corner.coordinates] + map.offset;
    if (!std::isfinite(uv.x) || !std::isfinite(uv.y))
      throw InputError(
          InputFault::not_finite,
          fmt::format("{}: texture coordinate {} is not finite", file_, corner.coordinates));
    return uv;
  }

  void add_notes() {
    const auto note = [&](const std::string& text) {
      scene_.notes.push_back(one_line(fmt::format("{}: {}", file_, text)));
    };
    if (lines_and_points_ > 0)
      note(counted(lines_and_points_, "statement") + " of lines and points left out");
    if (vertices_.weighted > 0)
      note(counted(vertices_.weighted, "vertex weight") + " left out: they concern curves alone");
    if (!vertices_.colours.empty())
      note("vertex colours, taken as sRGB, multiply the materials' diffuse colours");
    if (!unknown_.empty())
      note(fmt::format("statements not known: left out: {}", fmt::join(unknown_, ", ")));
  }

  static constexpr std::size_t none_given = ~std::size_t{0};

  std::string file_;
  Scene& scene_;
  ObjLines lines_;
  ObjMaterials materials_;
  MeshBuilder mesh_;
  ObjVertices vertices_;
  std::size_t material_ = none_given;
  std::array<std::size_t, 3> seen_{};
  std::vector<ObjCorner> corners_;
  std::vector<glm::vec3> polygon_;
  std::vector<std::uint32_t> first_copy_; ///< of each position, into copies_
  std::vector<Copy> copies_;
  std::size_t lines_and_points_ = 0;
  std::set<std::string> unknown_;
};

} // namespace

void append_obj(const std::filesystem::path& file, const FileAccess& access, Scene& scene) {
  ObjReader(file, access, scene).read();
}

} // namespace lightcuts

// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/models/gltf/gltf_nodes.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <lightcuts/core/input_error.h>

#include <lightcuts/render/files/text.h>

namespace lightcuts {
namespace {

using gltf::Json;

std::optional<LightKind> kind_of(const std::string& type) {
  if (type == "point") return LightKind::omni;
  if (type == "spot") return LightKind::spot;
  if (type == "directional") return LightKind::directional;
  return std::nullopt;
}

glm::dvec4 rotation_of(const Json& node) {
  const Json& q = gltf::list_in(node, "rotation");
  if (q.empty()) return {0, 0, 0, 1};
  if (q.size() < 4) throw GltfFault("'rotation' is not a list of 4 numbers");
  return {q[0].get<double>(), q[1].get<double>(), q[2].get<double>(), q[3].get<double>()};
}

glm::dmat4 local_transform(const Json& node) {
  if (!node.contains("matrix"))
    return transform_of(gltf::vector_in(node, "translation", glm::dvec3(0)), rotation_of(node),
                        gltf::vector_in(node, "scale", glm::dvec3(1)));
  const Json& list = gltf::list_in(node, "matrix");
  if (list.size() < 16) throw GltfFault("'matrix' is not a list of 16 numbers");
  glm::dmat4 m(1);
  for (int i = 0; i < 16; ++i) m[i / 4][i % 4] = list[std::size_t(i)].get<double>();
  return m;
}

/// The node's turn alone: what a light or a camera under a scale of 0 still has.
glm::dquat turn_of(const Json& node) {
  if (node.contains("matrix")) return {1, 0, 0, 0};
  const glm::dvec4 q = rotation_of(node);
  const glm::dquat turn = glm::normalize(glm::dquat(q.w, q.x, q.y, q.z));
  return std::isfinite(turn.w) ? turn : glm::dquat(1, 0, 0, 0);
}

struct Place {
  glm::dmat4 world{1};
  glm::dquat turn{1, 0, 0, 0};

  /// Unit: where the node's own axis points.
  [[nodiscard]] glm::dvec3 direction(int axis) const {
    const glm::dvec3 scaled = glm::normalize(glm::dvec3(world[axis]));
    return std::isfinite(scaled.x) ? scaled : glm::dvec3(glm::mat3_cast(turn)[axis]);
  }
};

class NodeWalker {
public:
  NodeWalker(const GltfFile& file, std::vector<std::string>& notes)
      : file_(file), notes_(notes), nodes_(gltf::list_in(file.root(), "nodes")),
        seen_(nodes_.size(), false) {
    found_.world.resize(nodes_.size(), glm::dmat4(1));
  }

  GltfNodes walk() {
    const Json& scenes = gltf::list_in(file_.root(), "scenes");
    if (!scenes.empty()) {
      const Json& scene = file_.item("scenes", gltf::whole_in(file_.root(), "scene", 0));
      for (const Json& node : gltf::list_in(scene, "nodes"))
        visit(gltf::whole(node, "nodes"), {}, 0, true);
    }
    // Without scenes nothing says what to leave out.
    in_scene_ = scenes.empty();
    if (in_scene_ && !nodes_.empty())
      notes_.push_back(
          fmt::format("{}: no scene in the file: all its nodes are shown", file_.path().string()));
    visit_others();
    add_notes();
    return std::move(found_);
  }

private:
  static constexpr int deepest = 1000;

  void visit(std::size_t index, const Place& parent, int depth, bool visible) {
    const Json& node = file_.item("nodes", index);
    if (seen_[index]) throw GltfFault(fmt::format("node {} has more than one parent", index));
    if (depth > deepest)
      throw InputError(InputFault::too_large,
                       fmt::format("{}: nodes are nested too deeply", file_.path().string()));
    seen_[index] = true;
    const Place place{parent.world * local_transform(node), parent.turn * turn_of(node)};
    found_.world[index] = place.world;
    if (const Json* visibility = gltf::extension_of(node, "KHR_node_visibility"))
      if (visible && !gltf::truth_in(*visibility, "visible", true)) {
        visible = false;
        ++hidden_;
      }
    if (in_scene_) add_content(index, node, place, visible);
    for (const Json& child : gltf::list_in(node, "children"))
      visit(gltf::whole(child, "children"), place, depth + 1, visible);
  }

  /// Joints of skins may lie outside the scene.
  void visit_others() {
    std::set<std::size_t> children;
    for (const Json& node : nodes_)
      for (const Json& child : gltf::list_in(node, "children"))
        children.insert(gltf::whole(child, "children"));
    for (std::size_t i = 0; i < nodes_.size(); ++i)
      if (!seen_[i] && !children.contains(i)) visit(i, {}, 0, true);
  }

  void add_content(std::size_t index, const Json& node, const Place& place, bool visible) {
    if (const auto camera = gltf::index_in(node, "camera"))
      add_camera(file_.item("cameras", *camera), place);
    if (!visible) return;
    if (const auto mesh = gltf::index_in(node, "mesh"))
      found_.meshes.push_back({index, *mesh, gltf::index_in(node, "skin")});
    if (const Json* light = gltf::extension_of(node, "KHR_lights_punctual"))
      add_light(gltf::whole_in(*light, "light"), place);
    if (const Json* light = gltf::extension_of(node, "EXT_lights_ies")) add_profile(*light, place);
  }

  /// It shines along its -z; horizontal angle 0 is +x.
  void add_profile(const Json& instance, const Place& place) {
    GltfLight found;
    found.kind = LightKind::profile;
    found.profile = gltf::whole_in(instance, "light");
    found.name = fmt::format("{}", found.profile);
    found.position = glm::vec3(glm::dvec3(place.world[3]));
    found.direction = glm::vec3(-place.direction(2));
    found.plane = glm::vec3(place.direction(0));
    const glm::dvec3 colour = gltf::vector_in(instance, "color", glm::dvec3(1));
    found.intensity = glm::vec3(gltf::number_in(instance, "multiplier", 1) *
                                glm::min(glm::max(colour, glm::dvec3(0)), glm::dvec3(1)));
    found_.lights.push_back(std::move(found));
  }

  void add_camera(const Json& camera, const Place& place) {
    if (gltf::text_in(camera, "type", "") != "perspective") {
      ++orthographic_;
      return;
    }
    if (found_.camera) return;
    const glm::dvec3 position(place.world[3]);
    const Json& perspective = gltf::object_in(camera, "perspective");
    if (!perspective.contains("yfov")) throw GltfFault("'yfov' is missing");
    const double yfov = gltf::number_in(perspective, "yfov", 0);
    // A glTF camera looks along its -z. Far from the origin one metre could be lost.
    const double far = std::max(1.0, glm::length(position) * 0x1p-10);
    found_.camera =
        Camera{glm::vec3(position), glm::vec3(position - far * place.direction(2)),
               glm::vec3(place.direction(1)), static_cast<float>(yfov * 180 / std::numbers::pi)};
  }

  void add_light(std::size_t index, const Place& place) {
    const Json* extension = gltf::extension_of(file_.root(), "KHR_lights_punctual");
    if (!extension) throw GltfFault("'KHR_lights_punctual' is missing");
    const Json& lights = gltf::list_in(*extension, "lights");
    if (index >= lights.size()) throw GltfFault(fmt::format("light {} is not there", index));
    const Json& light = lights[index];
    GltfLight found;
    found.name = one_line(gltf::text_in(light, "name", fmt::format("{}", index)));
    if (!light.contains("type")) throw GltfFault("a light's 'type' is missing");
    const std::string type = gltf::text_in(light, "type", "");
    const auto kind = kind_of(type);
    if (!kind)
      return note_light(found, one_line(fmt::format("left out: its type '{}' is not known", type)));
    found.kind = *kind;
    found.position = glm::vec3(glm::dvec3(place.world[3]));
    found.intensity = glm::vec3(gltf::number_in(light, "intensity", 1) *
                                gltf::vector_in(light, "color", glm::dvec3(1)));
    // Lights, too, shine along their -z.
    if (*kind != LightKind::omni) found.direction = glm::vec3(-place.direction(2));
    if (*kind == LightKind::spot) set_angles(light, found);
    if (light.contains("range"))
      note_light(found, fmt::format("its range of {} is left out: it reaches any distance",
                                    gltf::number_in(light, "range", 0)));
    found_.lights.push_back(std::move(found));
  }

  void set_angles(const Json& light, GltfLight& found) {
    if (!light.contains("spot")) throw GltfFault("a spot without 'spot'");
    const Json& spot = gltf::object_in(light, "spot");
    const double inner = gltf::number_in(spot, "innerConeAngle", 0);
    const double outer = gltf::number_in(spot, "outerConeAngle", 0.25 * std::numbers::pi);
    found.inner_angle = static_cast<float>(inner);
    found.outer_angle = static_cast<float>(outer);
    if (!(found.outer_angle > 0) || found.inner_angle < found.outer_angle) return;
    found.inner_angle = std::nextafter(found.outer_angle, 0.0F);
    note_light(found, fmt::format("innerConeAngle {} is not below outerConeAngle {}: clamped",
                                  inner, outer));
  }

  /// Once for all nodes that use the light.
  void note_light(const GltfLight& light, const std::string& text) {
    const std::string note =
        fmt::format("{}: light '{}': {}", file_.path().string(), light.name, text);
    if (std::ranges::find(notes_, note) == notes_.end()) notes_.push_back(note);
  }

  void add_notes() {
    const std::string file = file_.path().string();
    if (orthographic_ > 0)
      notes_.push_back(fmt::format("{}: {} left out: only perspective is supported", file,
                                   counted(orthographic_, "orthographic camera")));
    if (hidden_ > 0)
      notes_.push_back(
          fmt::format("{}: {} left out, as the file says", file, counted(hidden_, "hidden node")));
  }

  const GltfFile& file_;
  std::vector<std::string>& notes_;
  const Json& nodes_;
  std::vector<bool> seen_;
  bool in_scene_ = true;
  std::size_t orthographic_ = 0, hidden_ = 0;
  GltfNodes found_;
};

} // namespace

glm::dmat4 transform_of(const glm::dvec3& translation, const glm::dvec4& rotation,
                        const glm::dvec3& scale) {
  glm::dquat turn = glm::normalize(glm::dquat(rotation.w, rotation.x, rotation.y, rotation.z));
  if (!std::isfinite(turn.w)) turn = glm::dquat(1, 0, 0, 0);
  glm::dmat4 m = glm::mat4_cast(turn);
  for (int axis = 0; axis < 3; ++axis) m[axis] *= scale[axis];
  m[3] = glm::dvec4(translation, 1);
  return m;
}

GltfNodes read_nodes(const GltfFile& file, std::vector<std::string>& notes) {
  return NodeWalker(file, notes).walk();
}

} // namespace lightcuts

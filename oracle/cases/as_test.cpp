// SPDX-License-Identifier: MIT
#include <oracle/cases/as_test.h>

#include <array>
#include <cctype>

#include <fmt/format.h>

#include <oracle/cases/hex_float.h>

namespace lightcuts::oracle {
namespace {

std::string literal(float value) { return hex_text(value) + "F"; }

std::string literal(const glm::vec3& v) {
  return fmt::format("{{{}, {}, {}}}", literal(v.x), literal(v.y), literal(v.z));
}

std::string literal(const Light& light) {
  constexpr std::array kinds{"omni", "oriented", "spot", "directional"};
  std::string text = fmt::format(
      "{{.kind = LightKind::{},\n       .position = {},\n       .intensity = {}",
      kinds[std::size_t(light.kind)], literal(light.position), literal(light.intensity));
  if ((only(light.kind) & kinds_with_axis) != 0)
    text += fmt::format(",\n       .axis = {}", literal(light.axis));
  if (light.kind == LightKind::spot)
    text += fmt::format(",\n       .cos_inner = {},\n       .cos_outer = {}",
                        literal(light.cos_inner), literal(light.cos_outer));
  return text + "}";
}

std::string literal(const Lobe& lobe) {
  if (const auto* phong = std::get_if<Phong>(&lobe))
    return fmt::format("Phong{{{}, {}}}", literal(phong->reflectance), literal(phong->exponent));
  if (const auto* ward = std::get_if<Ward>(&lobe))
    return fmt::format("Ward{{{}, {}}}", literal(ward->reflectance), literal(ward->alpha));
  if (const auto* cook = std::get_if<CookTorrance>(&lobe))
    return fmt::format("CookTorrance{{{}, {}}}", literal(cook->f0), literal(cook->alpha));
  return "NoLobe{}";
}

std::string literal(const CaseView& v) {
  return fmt::format("{{{{.position = {},\n        .normal = {},\n        .to_viewer = {},\n"
                     "        .material = {{{},\n                     {}}}}},\n       {{{}}}}}",
                     literal(v.view.position), literal(v.view.normal), literal(v.view.to_viewer),
                     literal(v.view.material.diffuse), literal(v.view.material.lobe),
                     fmt::join(v.hidden, ", "));
}

std::string literal(const CaseTriangle& t) {
  return fmt::format("{{{{{{{},\n         {},\n         {}}}}},\n       {}}}",
                     literal(t.corners[0]), literal(t.corners[1]), literal(t.corners[2]), t.mesh);
}

template <class T>
std::string list(const char* name, const std::vector<T>& values) {
  if (values.empty()) return {};
  std::string text = fmt::format("  on.{} = {{\n", name);
  for (const T& value : values) text += "      " + literal(value) + ",\n";
  return text + "  };\n";
}

std::string camera_text(const Case& on) {
  return fmt::format("  on.camera = {{{},\n               {},\n               {},\n               "
                     "{}}};\n  on.image_size = {{{}, {}}};\n",
                     literal(on.camera.position), literal(on.camera.target), literal(on.camera.up),
                     literal(on.camera.vertical_fov), on.image_size.x, on.image_size.y);
}

std::string case_text(const Case& on) {
  std::string text = "  Case on;\n" + list("lights", on.lights);
  if (on.min_distance != 0)
    text += fmt::format("  on.min_distance = {};\n", literal(on.min_distance));
  text += list("views", on.views);
  text += fmt::format("  on.cut = {{{}, {}U, {}, {}}};\n", literal(on.cut.threshold),
                      on.cut.max_size, literal(on.cut.black_level), on.cut.unoccluded);
  text += fmt::format("  on.seed = {}U;\n", on.seed);
  if (!on.triangles.empty()) text += list("triangles", on.triangles) + camera_text(on);
  return text;
}

/// "BoundIsFinite" or "bound_is_finite" of "bound-is-finite".
std::string camel_case(std::string_view name) {
  std::string text;
  bool start = true;
  for (const char c : name) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0)
      text += start ? char(std::toupper(static_cast<unsigned char>(c))) : c;
    start = std::isalnum(static_cast<unsigned char>(c)) == 0;
  }
  return text;
}

std::string snake_case(std::string text) {
  for (char& c : text)
    if (c == '-') c = '_';
  return text;
}

/// Of a property's value; see Property.
std::string assertion(const char* comparison, const std::string& subject,
                      const std::string& property) {
  return fmt::format("  EXPECT_{}(failure_of(*{},\n                       Property::{}, on),\n"
                     "            std::nullopt);\n",
                     comparison, subject, property);
}

/// What is to hold for the subject once it is mended: the library, where a mutant or a plug-in does
/// not hold, and others of the library's subjects themselves.
const char* subject_that_holds(const std::string& name) {
  if (name == "locally-ordered") return "locally_ordered_subject()";
  if (name == "paper") return "paper_subject()";
  if (name == "stochastic-intensity") return "stochastic_intensity_subject()";
  return "library_subject()";
}

} // namespace

std::string as_test(const SavedCounterexample& saved) {
  constexpr std::string_view mutant = "mutant:";
  const bool is_mutant = saved.subject.starts_with(mutant);
  const std::string name = is_mutant ? saved.subject.substr(mutant.size()) : "";
  const char* property = info(saved.counterexample.property).name;
  std::string text = "#include <optional>\n\n#include <gtest/gtest.h>\n"
                     "#include <oracle/campaign/hunt.h>\n"
                     "#include <oracle/subjects/library_subject.h>\n";
  if (is_mutant) text += "#include <oracle/mutants/mutants.h>\n";
  text += fmt::format("\nnamespace lightcuts::oracle {{\nnamespace {{\n\n// {}\nTEST({}, {}) {{\n",
                      info(saved.counterexample.property).statement,
                      is_mutant ? camel_case(name) : "Counterexample", camel_case(property));
  text += case_text(saved.counterexample.on);
  text += assertion("EQ", subject_that_holds(saved.subject), snake_case(property));
  if (is_mutant)
    text +=
        assertion("NE", fmt::format("mutant_named(\"{}\")->subject()", name), snake_case(property));
  return text + "}\n\n} // namespace\n} // namespace lightcuts::oracle\n";
}

} // namespace lightcuts::oracle

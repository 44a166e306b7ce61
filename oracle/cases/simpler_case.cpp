// SPDX-License-Identifier: MIT
#include <oracle/cases/simpler_case.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include <oracle/cases/simpler.h>
#include <oracle/cases/simpler_values.h>

namespace lightcuts::oracle {
namespace {

/// Indices of lights move up where lights before them are gone.
std::vector<std::uint32_t> without(const std::vector<std::uint32_t>& indices, std::uint32_t first,
                                   std::uint32_t count) {
  std::vector<std::uint32_t> left;
  for (const std::uint32_t i : indices)
    if (i < first || i >= first + count) left.push_back(i < first ? i : i - count);
  return left;
}

template <class T>
void erase(std::vector<T>& values, std::size_t first, std::size_t count) {
  const auto begin = values.begin() + std::ptrdiff_t(first);
  values.erase(begin, begin + std::ptrdiff_t(count));
}

bool is_somewhere(const Light& light) { return light.kind != LightKind::directional; }

/// Hands out copies of a case in which something is simpler. All functions return whether the
/// visitor wants no more.
class Simpler {
public:
  Simpler(const Case& of, const std::function<bool(Case&)>& visitor) : of_(of), visitor_(visitor) {}

  [[nodiscard]] bool all() const {
    return lights() || without_chunks(&Case::views, 1) ||
           without_chunks(&Case::triangles, std::min<std::size_t>(of_.triangles.size(), 1)) ||
           together() || fields();
  }

private:
  /// A copy that `change` has changed.
  template <class Change>
  bool with(Change&& change) const {
    Case c = of_;
    change(c);
    return visitor_(c);
  }

  /// Copies in which what `part` finds is one of these values.
  template <class T, class Part>
  bool each(const std::vector<T>& values, Part&& part) const {
    return std::any_of(values.begin(), values.end(),
                       [&](const T& value) { return with([&](Case& c) { part(c) = value; }); });
  }

  template <class F>
  bool for_chunks(std::size_t count, std::size_t least, F&& f) const {
    for (std::size_t chunk = std::max<std::size_t>(count / 2, 1); chunk > 0; chunk /= 2)
      for (std::size_t first = 0; first + chunk <= count && count - chunk >= least; first += chunk)
        if (f(first, chunk)) return true;
    return false;
  }

  template <class T>
  bool without_chunks(std::vector<T> Case::*part, std::size_t least) const {
    return for_chunks((of_.*part).size(), least, [&](std::size_t first, std::size_t chunk) {
      return with([&](Case& c) { erase(c.*part, first, chunk); });
    });
  }

  [[nodiscard]] bool lights() const {
    return for_chunks(of_.lights.size(), 1, [this](std::size_t first, std::size_t chunk) {
      Case c = without_lights(of_, std::uint32_t(first), std::uint32_t(chunk));
      return visitor_(c);
    });
  }

  /// What has to change everywhere at once, or not at all.
  [[nodiscard]] bool together() const {
    return other([](Case& c) {
             for (CaseView& v : c.views)
               if (v.view.material.is_glossy() || !is_zeros_and_ones(v.view.material.diffuse))
                 v.view.material = {glm::vec3(1), {}};
           }) ||
           other([](Case& c) {
             for (Light& l : c.lights)
               if (is_somewhere(l)) l = {.position = l.position, .intensity = l.intensity};
           }) ||
           other([](Case& c) {
             for (Light& light : c.lights)
               if (!is_zeros_and_ones(light.intensity)) light.intensity = glm::vec3(1);
           }) ||
           other([](Case& c) {
             if (!c.views.empty() && c.triangles.empty()) shift(c, -c.views.front().view.position);
           }) ||
           other([exponent = largest_exponent()](Case& c) { scale(c, -exponent); }) || rounded();
  }

  /// What single floats shrink to; turning that into white again would never end.
  static bool is_zeros_and_ones(const glm::vec3& v) {
    const auto is = [](float value) { return value == 0 || value == 1; };
    return is(v.x) && is(v.y) && is(v.z);
  }

  /// All positions with a few bits only.
  [[nodiscard]] bool rounded() const {
    for (const int bits : {2, 4, 12})
      if (other([bits](Case& c) {
            for_positions(c, [bits](glm::vec3& v) {
              for (int i = 0; i < 3; ++i) v[i] = with_bits(v[i], bits);
            });
          }))
        return true;
    return false;
  }

  static float with_bits(float value, int bits) {
    int exponent = 0;
    const float mantissa = std::frexp(value, &exponent);
    return std::ldexp(std::trunc(std::ldexp(mantissa, bits)), exponent - bits);
  }

  /// with(), where that is another case.
  template <class Change>
  bool other(Change&& change) const {
    Case c = of_;
    change(c);
    return !(c == of_) && is_finite(c) && visitor_(c);
  }

  static bool is_finite(const Case& c) {
    const auto finite = [](const glm::vec3& v) {
      return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
    };
    return std::isfinite(c.min_distance) &&
           std::all_of(c.lights.begin(), c.lights.end(), [&](const Light& light) {
             return finite(light.position) && finite(light.intensity);
           });
  }

  /// Of views, and of lights that are somewhere.
  template <class F>
  static void for_positions(Case& c, F&& f) {
    for (CaseView& v : c.views) f(v.view.position);
    for (Light& light : c.lights)
      if (is_somewhere(light)) f(light.position);
  }

  static void shift(Case& c, const glm::vec3 by) {
    for_positions(c, [&by](glm::vec3& v) { v += by; });
  }

  /// Lengths by 2^exponent, and intensities so that what arrives stays the same.
  static void scale(Case& c, int exponent) {
    const auto scaled = [exponent](glm::vec3& v, int times) {
      for (int i = 0; i < 3; ++i) v[i] = std::ldexp(v[i], times * exponent);
    };
    for_positions(c, [&](glm::vec3& v) { scaled(v, 1); });
    for (Light& light : c.lights)
      if (is_somewhere(light)) scaled(light.intensity, 2);
    c.min_distance = std::ldexp(c.min_distance, exponent);
  }

  /// Of the positions; 0 if all are 0, or about 1 already, or there is a picture, whose camera
  /// stays.
  [[nodiscard]] int largest_exponent() const {
    float largest = 0;
    Case copy = of_;
    for_positions(copy, [&largest](const glm::vec3& v) {
      for (int i = 0; i < 3; ++i) largest = std::max(largest, std::abs(v[i]));
    });
    if (largest == 0 || !of_.triangles.empty()) return 0;
    const int exponent = std::ilogb(largest);
    // What shrinks a float in [1, 2) may halve it: scaling that back would never end.
    return std::abs(exponent) <= 1 ? 0 : exponent;
  }

  [[nodiscard]] bool fields() const {
    bool done = false;
    for_each_field<Case>([&](const auto& field) {
      done = done || simpler_field(field.member, field.domain_in(of_));
    });
    return done;
  }

  template <class Value>
  bool simpler_field(Value Case::*member, const Domain& domain) const {
    return each(simpler_values(of_.*member, Case{}.*member, domain),
                [member](Case& c) -> Value& { return c.*member; });
  }

  template <class T>
  bool simpler_field(std::vector<T> Case::*member, const Domain& /*domain*/) const {
    for (std::size_t i = 0; i < (of_.*member).size(); ++i)
      if (each(simpler_element((of_.*member)[i]), [&](Case& c) -> T& { return (c.*member)[i]; }))
        return true;
    return false;
  }

  static std::vector<Light> simpler_element(const Light& light) { return gen::simpler(light); }
  template <class T>
  static std::vector<T> simpler_element(const T& element) {
    return simpler_values(element);
  }

  /// Of a count, so that the least that fails is found by halving.
  bool simpler_field(std::uint32_t Case::*count, const Domain& /*domain*/) const {
    const std::uint32_t now = of_.*count;
    std::vector<std::uint32_t> fewer;
    for (const std::uint32_t less : {now, now / 2, now / 8, now / 64, std::min(now, 1U)})
      if (less > 0) fewer.push_back(now - less);
    return each(fewer, [count](Case& c) -> std::uint32_t& { return c.*count; });
  }

  bool simpler_field(CutConfig Case::*cut, const Domain& /*domain*/) const {
    return each(with_usual_fields(of_.*cut, {0.02F, 1000, 0}),
                [cut](Case& c) -> CutConfig& { return c.*cut; });
  }

  /// Of a picture, if there is one.
  bool simpler_field(glm::uvec2 Case::*size, const Domain& domain) const {
    return !of_.triangles.empty() && simpler_field<glm::uvec2>(size, domain);
  }

  bool simpler_field(Camera Case::* /*stays*/, const Domain& /*domain*/) const { return false; }

  const Case& of_;
  const std::function<bool(Case&)>& visitor_;
};

} // namespace

Case without_lights(Case of, std::uint32_t first, std::uint32_t count) {
  erase(of.lights, first, count);
  for (CaseView& v : of.views) v.hidden = without(v.hidden, first, count);
  return of;
}

bool visit_simpler(const Case& of, const std::function<bool(Case&)>& visitor) {
  return Simpler(of, visitor).all();
}

std::vector<Case> simpler(const Case& of) {
  std::vector<Case> list;
  visit_simpler(of, [&list](Case& c) {
    list.push_back(std::move(c));
    return false;
  });
  return list;
}

} // namespace lightcuts::oracle

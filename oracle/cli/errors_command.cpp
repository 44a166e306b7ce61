// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <lightcuts/core/kernels/contribution_bound.h>
#include <oracle/cli/commands.h>
#include <oracle/cli/common.h>
#include <oracle/numbers/dice.h>
#include <oracle/options/count.h>
#include <oracle/options/values.h>

namespace lightcuts::cli {
namespace {

/// A running sum that keeps what rounding takes from it (Neumaier 1974).
template <class Real>
class CompensatedSum {
public:
  void add(Real term) {
    const Real next = sum_ + term;
    lost_ += std::abs(sum_) >= std::abs(term) ? (sum_ - next) + term : (term - next) + sum_;
    sum_ = next;
  }
  [[nodiscard]] Real value() const { return sum_ + lost_; }

private:
  Real sum_ = 0, lost_ = 0;
};

/// How far sums of so many lights are off, relative to the sum of what each light contributes; and
/// what they are off at most (Higham 2002, "Accuracy and Stability of Numerical Algorithms",
/// section 4.2), u being 2^-24 and 2^-53: one after another (n - 1) u, in float with u more for
/// each term; compensated 2 u + n^2 u^2.
struct SumErrors {
  std::uint64_t lights;
  double in_float, in_double, compensated;

  [[nodiscard]] double most_in_float() const { return double(lights) * 0x1p-24; }
  [[nodiscard]] double most_in_double() const { return double(lights - 1) * 0x1p-53; }
  [[nodiscard]] double most_compensated() const {
    const double nu = double(lights) * 0x1p-53;
    return 0x1p-52 + nu * nu;
  }
};

/// What omni lights above a diffuse surface contribute, one by one, at 10, 100 ... lights.
std::vector<SumErrors> measured(std::uint64_t seed, std::uint64_t most) {
  const ShadingPoint point(glm::vec3(0), {0, 0, 1}, {0, 0, 1}, {glm::vec3(0.5F), {}});
  gen::Dice dice(seed);
  float in_float = 0;
  double in_double = 0;
  CompensatedSum<double> compensated;
  CompensatedSum<long double> exact; // off by 2^-62, which shows in none of the others
  std::vector<SumErrors> rows;
  std::uint64_t next = 10;
  for (std::uint64_t n = 1; n <= most; ++n) {
    const glm::vec3 at(dice.uniform(-1, 1), dice.uniform(-1, 1), dice.uniform(0.1, 1));
    const double term = transfer(point, {.position = at, .intensity = glm::vec3(1)}, 0).x;
    in_float += float(term);
    in_double += term;
    compensated.add(term);
    exact.add(term);
    if (n != next && n != most) continue;
    const auto off = [&](long double sum) {
      return double(std::abs(sum - exact.value()) / exact.value());
    };
    rows.push_back({n, off(in_float), off(in_double), off(compensated.value())});
    if (n == next) next *= 10;
  }
  return rows;
}

struct ErrorOptions : CommonOptions {
  std::string lights = "1e7";
};

std::string table_of(const std::vector<SumErrors>& rows) {
  std::string text = fmt::format("{:>10}{:>14}{:>10}{:>14}{:>10}{:>14}{:>10}\n", "lights", "float",
                                 "at most", "double", "at most", "compensated", "at most");
  for (const SumErrors& row : rows)
    text += fmt::format("{:>10}{:>14.1e}{:>10.1e}{:>14.1e}{:>10.1e}{:>14.1e}{:>10.1e}\n",
                        row.lights, row.in_float, row.most_in_float(), row.in_double,
                        row.most_in_double(), row.compensated, row.most_compensated());
  return text +
         "\nrelative errors of the sum of what each light contributes; beside them what they "
         "can be at most:\nn 2^-24, (n - 1) 2^-53, 2^-52 + n^2 2^-106 (Higham 2002, section "
         "4.2)\n";
}

std::string json_of(const std::vector<SumErrors>& rows, std::uint64_t seed) {
  nlohmann::ordered_json json{{"schema", "lightcuts-oracle/errors/1"}, {"seed", seed}};
  json["sums"] = nlohmann::ordered_json::array();
  for (const SumErrors& row : rows)
    json["sums"].push_back({{"lights", row.lights},
                            {"float", row.in_float},
                            {"most_in_float", row.most_in_float()},
                            {"double", row.in_double},
                            {"most_in_double", row.most_in_double()},
                            {"compensated", row.compensated},
                            {"most_compensated", row.most_compensated()}});
  return text_of(json);
}

int run_errors(const ErrorOptions& options) {
  require_writable_json(options);
  const auto rows =
      measured(options.seed, std::max<std::uint64_t>(*options::parse_count(options.lights), 1));
  print_results(options, table_of(rows), json_of(rows, options.seed));
  const bool holds = std::all_of(rows.begin(), rows.end(), [](const SumErrors& row) {
    return row.in_float <= row.most_in_float() && row.in_double <= row.most_in_double() &&
           row.compensated <= row.most_compensated();
  });
  return holds ? all_holds : violated;
}

} // namespace

void add_errors_command(CLI::App& app, Action& chosen) {
  auto options = std::make_shared<ErrorOptions>();
  CLI::App* command = app.add_subcommand(
      "errors", "How rounding errors of sums grow with the number of lights, and their bounds.");
  command->add_option("--lights", options->lights, "the most lights, such as 10000000 or 1e7")
      ->check(options::check_count)
      ->capture_default_str();
  add_seed_option(*command, *options);
  add_json_option(*command, *options);
  command->callback([options, &chosen] { chosen = [options] { return run_errors(*options); }; });
}

} // namespace lightcuts::cli

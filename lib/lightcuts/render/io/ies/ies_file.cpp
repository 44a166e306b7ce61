// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/ies/ies_file.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include <fmt/format.h>

#include <lightcuts/render/files/text.h>
#include <lightcuts/render/io/ies/ies_numbers.h>
#include <lightcuts/render/io/ies/ies_table.h>

namespace lightcuts {
namespace {

constexpr double most = 1e30; ///< candela, factors: far from the end of floats
constexpr std::size_t most_angles = 100'000;
constexpr std::size_t most_lines_before_tilt = 10'000;

bool starts_with_word(std::string_view line, std::string_view word) {
  return line.size() >= word.size() &&
         std::equal(word.begin(), word.end(), line.begin(), [](char a, char b) {
           return a == std::toupper(static_cast<unsigned char>(b));
         });
}

/// The year of the edition; the first one had no line that says so.
int edition_of(std::string_view first_line) {
  constexpr std::array<std::pair<std::string_view, int>, 5> editions{{{"IESNA91", 1991},
                                                                      {"IESNA:LM-63-1991", 1991},
                                                                      {"IESNA:LM-63-1995", 1995},
                                                                      {"IESNA:LM-63-2002", 2002},
                                                                      {"IES:LM-63-2019", 2019}}};
  for (const auto& [begin, year] : editions)
    if (starts_with_word(first_line, begin)) return year;
  return 1986;
}

class IesReader {
public:
  IesReader(const std::string& name, std::string_view text) : name_(name), in_(name, text) {}

  IesLuminaire read() {
    skip_to_tilt();
    double factor = tilt_factor();
    in_.number("the number of lamps", 0, most);
    in_.number("lumens per lamp", -most, most); // -1: absolute; else candela are for these, as well
    factor *= in_.number("the multiplier", 0, most);
    const std::size_t rows = in_.whole("the number of vertical angles", 2, most_angles);
    const std::size_t columns = in_.whole("the number of horizontal angles", 1, most_angles);
    if (rows > Profile::max_shares / columns)
      in_.refuse(InputFault::too_large,
                 fmt::format("{} x {} candela, at most 2^22 are read", rows, columns));
    require_type_c();
    for (const char* what : {"the unit of lengths", "the width", "the length", "the height"})
      in_.number(what, -most, most);
    factor *= in_.number("the ballast factor", 0, most);
    const double ballast_lamp = in_.number("the ballast-lamp factor", -most, most);
    if (edition_ < 1995)
      factor *= ballast_lamp;
    else if (ballast_lamp != 1 && edition_ == 1995)
      note(fmt::format("its ballast-lamp factor of {} is of no meaning in 1995", ballast_lamp));
    if (ballast_lamp < 0) in_.refuse(InputFault::negative, "the ballast-lamp factor is negative");
    in_.number("the input watts", -most, most);
    return luminaire(rows, columns, factor);
  }

private:
  void note(const std::string& text) {
    result_.notes.push_back(fmt::format("{}: {}", name_, text));
  }

  void skip_to_tilt() {
    constexpr const char* tilt = "TILT=";
    edition_ = edition_of(line_ = in_.next_line(tilt));
    for (std::size_t i = 0; !starts_with_word(line_, tilt); ++i) {
      if (i == most_lines_before_tilt || in_.is_at_end())
        in_.refuse(InputFault::malformed_file, "no line begins with TILT=: no IES file");
      line_ = in_.next_line(tilt);
    }
  }

  /// Of a luminaire that hangs as it was measured.
  double tilt_factor() {
    const std::string_view tilt = line_.substr(5);
    if (starts_with_word(tilt, "NONE")) return 1;
    if (!starts_with_word(tilt, "INCLUDE"))
      in_.refuse(
          InputFault::unsupported,
          fmt::format("TILT={}: factors in a file of their own are not read", tilt.substr(0, 40)));
    in_.whole("the lamp-to-luminaire geometry", 1, 3);
    const std::size_t count = in_.whole("the number of tilt angles", 1, most_angles);
    const std::vector<double> angles = in_.increasing("a tilt angle", count, -360, 360);
    const std::vector<double> factors = in_.numbers("a tilt factor", count, 0, most);
    const auto [least, largest] = std::minmax_element(factors.begin(), factors.end());
    const double factor = upright(angles, factors);
    if (*least != *largest)
      note(fmt::format("TILT: taken as upright, factor {}, however it is turned", factor));
    return factor;
  }
  /// Linear between angles.
  static double upright(const std::vector<double>& angles, const std::vector<double>& factors) {
    for (std::size_t i = 0; i < angles.size(); ++i) {
      if (angles[i] < 0) continue;
      if (i == 0 || angles[i] == 0) return factors[i];
      const double t = -angles[i - 1] / (angles[i] - angles[i - 1]);
      return (1 - t) * factors[i - 1] + t * factors[i];
    }
    return factors.back();
  }

  void require_type_c() {
    const std::size_t type = in_.whole("the photometric type", 1, 3);
    if (type != 1)
      in_.refuse(InputFault::unsupported,
                 fmt::format("photometry of type {}: only type C is read", type == 2 ? "B" : "A"));
  }

  Symmetry symmetry_of(const std::vector<double>& angles) {
    const double first = angles.front(), last = angles.back();
    if (angles.size() == 1) return Symmetry::round;
    if (first == 90 && last == 270) return Symmetry::across;
    if (first != 0)
      in_.refuse(InputFault::malformed_file,
                 fmt::format("horizontal angles from {} to {}, expected 0 to 90, 180 or 360, or 90 "
                             "to 270",
                             first, last));
    if (last == 90) return Symmetry::quadrant;
    if (last == 180) return Symmetry::bilateral;
    if (last == 360) return Symmetry::none;
    if (last < 180)
      in_.refuse(InputFault::malformed_file,
                 fmt::format("horizontal angles end at {}, expected 90, 180 or 360", last));
    note(fmt::format("horizontal angles end at {}: the first follows", last));
    return Symmetry::none_unclosed;
  }

  IesLuminaire luminaire(std::size_t rows, std::size_t columns, double factor) {
    Candela candela;
    candela.vertical = in_.increasing("a vertical angle", rows, 0, 180);
    candela.horizontal = in_.increasing("a horizontal angle", columns, 0, 360);
    const Symmetry symmetry = symmetry_of(candela.horizontal);
    for (std::size_t i = 0; i < columns; ++i)
      candela.columns.push_back(in_.numbers("candela", rows, 0, most));
    if (symmetry == Symmetry::none && candela.columns.front() != candela.columns.back())
      note("candela at 360 degrees are not those at 0, which count");
    if (const std::size_t left = in_.words_left(); left > 0)
      note(fmt::format("{} after the last candela left out", counted(left, "word")));
    result_.peak = candela.peak() * factor;
    ProfileTable table = table_of(candela, symmetry);
    try {
      result_.profile = Profile(std::move(table));
    } catch (const InputError& error) {
      in_.refuse(error.fault(), error.what());
    }
    return std::move(result_);
  }

  const std::string& name_;
  IesNumbers in_;
  std::string_view line_;
  int edition_ = 1986;
  IesLuminaire result_;
};

} // namespace

IesLuminaire read_ies(const std::string& name, std::string_view text) {
  return IesReader(name, text).read();
}

IesLuminaire load_ies(const std::filesystem::path& file) {
  return read_ies(file.string(), read_text(file));
}

} // namespace lightcuts

// SPDX-License-Identifier: MIT
#include <lightcuts/render/io/ies/ies_file.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <lightcuts/core/input_error.h>
#include <lightcuts/core/kinds/luminaire.h>
#include <lightcuts/core/lights/light.h>

namespace lightcuts {
namespace {

/// A file of one luminaire: `candela` follows the angles.
std::string file_of(const std::string& counts, const std::string& vertical,
                    const std::string& horizontal, const std::string& candela,
                    const std::string& first = "IESNA:LM-63-2002",
                    const std::string& tilt = "TILT=NONE", const std::string& ballast = "1 1 50",
                    const std::string& multiplier = "1") {
  return first + "\n[TEST] ABC\n[MANUFAC] Nobody\n" + tilt + "\n1 1000 " + multiplier + " " +
         counts + " 1 2 0.1 0.1 0\n" + ballast + "\n" + vertical + "\n" + horizontal + "\n" +
         candela + "\n";
}

const std::string round_file = file_of("3 1", "0 45 90", "0", "100 50 0");

/// Candela at angles in degrees.
double candela(const IesLuminaire& luminaire, double vertical, double horizontal) {
  const double v = vertical * std::numbers::pi / 180, h = horizontal * std::numbers::pi / 180;
  const Light light{.kind = LightKind::profile,
                    .axis = {0, 0, -1},
                    .plane = {1, 0, 0},
                    .profile = luminaire.profile};
  const glm::vec3 x(std::sin(v) * std::cos(h), std::sin(v) * std::sin(h), -std::cos(v));
  return luminaire.peak * Luminaire::emission(light, x);
}

double candela(const std::string& text, double vertical, double horizontal = 0) {
  return candela(read_ies("a.ies", text), vertical, horizontal);
}

void expect_refused(const std::string& text, InputFault fault, const std::string& message) {
  try {
    (void)read_ies("a.ies", text);
    ADD_FAILURE() << message;
  } catch (const InputError& error) {
    EXPECT_EQ(error.fault(), fault) << error.what();
    EXPECT_EQ(std::string(error.what()), "a.ies:" + message);
  }
}

TEST(IesFile, HasTheCandelaOfTheFileAtItsAngles) {
  const IesLuminaire luminaire = read_ies("a.ies", round_file);
  EXPECT_TRUE(luminaire.notes.empty());
  EXPECT_EQ(luminaire.peak, 100);
  EXPECT_TRUE(luminaire.profile.table().is_round());
  EXPECT_NEAR(candela(luminaire, 0, 0), 100, 1e-4);
  EXPECT_NEAR(candela(luminaire, 45, 123), 50, 1e-4);
  EXPECT_NEAR(candela(luminaire, 89.9, 0), 50 * 0.1 / 45, 1e-3);
  EXPECT_EQ(candela(luminaire, 91, 0), 0);
}

// Between two rows, h apart, what is linear in the cosine is off by no more than h/8 of the
// cotangent of the first, of what they differ by.
TEST(IesFile, IsLinearInTheAngle) {
  const double h = 2.5 * std::numbers::pi / 180, apart = 2.5 / 45 * 50;
  for (double angle = 2.5; angle < 90; angle += 0.61) {
    const double first = h * std::floor(angle / 2.5);
    EXPECT_NEAR(candela(round_file, angle), 100 - angle / 45 * 50,
                apart * h / 8 / std::tan(first) + 1e-4)
        << angle;
  }
}

TEST(IesFile, ReadsWhateverWhiteSpaceAndCommasDivide) {
  std::string text = round_file;
  for (std::size_t i = text.find("TILT=NONE") + 9; i < text.size(); ++i)
    if (text[i] == ' ') text.replace(i, 1, i % 2 == 0 ? "\r\n" : ", ");
  EXPECT_EQ(read_ies("a.ies", text).profile, read_ies("a.ies", round_file).profile);
  EXPECT_EQ(read_ies("a.ies", text + " \x1a").notes.size(), 0U);
}

TEST(IesFile, MultipliesByAllItsFactors) {
  const auto peak = [](const std::string& edition, const std::string& tilt) {
    return read_ies("a.ies",
                    file_of("2 1", "0 90", "0", "100 100", edition, tilt, "0.5 0.25 50", "3"))
        .peak;
  };
  EXPECT_DOUBLE_EQ(peak("IESNA:LM-63-2002", "TILT=NONE"), 150);
  EXPECT_DOUBLE_EQ(peak("IESNA:LM-63-1995", "TILT=NONE"), 150);
  EXPECT_DOUBLE_EQ(peak("IESNA91", "TILT=NONE"), 37.5);
  EXPECT_DOUBLE_EQ(peak("A luminaire of 1986", "TILT=NONE"), 37.5);
  EXPECT_DOUBLE_EQ(peak("IESNA:LM-63-2002", "TILT=INCLUDE\n1\n3\n0 45 90\n0.5 0.75 1"), 75);
  EXPECT_DOUBLE_EQ(peak("IESNA:LM-63-2002", "tilt=include\n1\n2\n-45 45\n0.5 1"), 112.5);
}

TEST(IesFile, TakesAbsolutePhotometryAsItIs) {
  std::string text = round_file;
  text.replace(text.find("1 1000 1"), 8, "1 -1 1");
  EXPECT_EQ(read_ies("a.ies", text).peak, 100);
}

TEST(IesFile, NotesWhatItLeavesOut) {
  const auto notes = [](const std::string& text) { return read_ies("a.ies", text).notes; };
  EXPECT_EQ(notes(round_file + "7 8"),
            std::vector<std::string>{"a.ies: 2 words after the last candela left out"});
  EXPECT_EQ(
      notes(file_of("2 1", "0 90", "0", "1 1", "IESNA91", "TILT=INCLUDE\n1 2 0 90 1 0.5")),
      std::vector<std::string>{"a.ies: TILT: taken as upright, factor 1, however it is turned"});
}

/// At these horizontal angles, at the horizon.
void expect_candela(const std::string& photometry,
                    const std::vector<std::pair<double, double>>& by_angle) {
  const IesLuminaire luminaire = read_ies("a.ies", photometry);
  for (const auto& [h, expected] : by_angle)
    EXPECT_NEAR(candela(luminaire, 90, h), expected, 1e-4) << h << " degrees";
}

TEST(IesFile, IsMirroredAboutTwoPlanesWhereItEndsAt90) {
  expect_candela(file_of("2 3", "0 90", "0 45 90", "9 1  9 2  9 4"),
                 {{0, 1}, {180, 1}, {45, 2}, {135, 2}, {225, 2}, {315, 2}, {90, 4}, {270, 4}});
}

TEST(IesFile, IsMirroredAboutOnePlaneWhereItEndsAt180) {
  expect_candela(file_of("2 3", "0 90", "0 90 180", "9 1  9 2  9 4"),
                 {{0, 1}, {90, 2}, {180, 4}, {270, 2}});
}

TEST(IesFile, IsMirroredAboutTheOtherPlaneFrom90To270) {
  expect_candela(file_of("2 3", "0 90", "90 180 270", "9 1  9 2  9 4"),
                 {{90, 1}, {180, 2}, {0, 2}, {270, 4}});
}

TEST(IesFile, GoesAllRoundWhereItEndsAt360) {
  const IesLuminaire luminaire =
      read_ies("a.ies", file_of("2 4", "0 90", "0 90 270 360", "9 1  9 2  9 4  9 1"));
  EXPECT_NEAR(candela(luminaire, 90, 0), 1, 1e-4);
  EXPECT_NEAR(candela(luminaire, 90, 90), 2, 1e-4);
  EXPECT_NEAR(candela(luminaire, 90, 180), 3, 0.01); // linear between
  EXPECT_NEAR(candela(luminaire, 90, 270), 4, 1e-4);
}

TEST(IesFile, IsLinearInTheHorizontalAngle) {
  const IesLuminaire luminaire =
      read_ies("a.ies", file_of("2 3", "0 90", "0 180 360", "9 0  9 9  9 0"));
  for (double h = 0; h < 180; h += 3.7)
    EXPECT_NEAR(candela(luminaire, 90, h), h / 20, 0.0025 * 9 / 8 + 1e-5) << h;
}

TEST(IesFile, IsRoundWhereAllHalfPlanesAreAlike) {
  const IesLuminaire luminaire = read_ies("a.ies", file_of("2 2", "0 90", "0 90", "3 1  3 1"));
  EXPECT_TRUE(luminaire.profile.table().is_round());
}

TEST(IesFile, RefusesWhatIsNone) {
  const auto broken = InputFault::malformed_file;
  expect_refused("", broken, "1: ends before TILT=");
  expect_refused("hello\nthere\n", broken, "2: no line begins with TILT=: no IES file");
  expect_refused(std::string(1'000'000, '\n'), broken,
                 "10001: no line begins with TILT=: no IES file");
  expect_refused("IESNA91\nTILT=NONE\n1 2 3", broken,
                 "3: ends before the number of vertical angles");
  expect_refused("IESNA91\nTILT=NONE\n1 two", broken,
                 "3: lumens per lamp is 'two', expected a number");
  expect_refused("IESNA91\nTILT=NONE\n1 1e999", broken,
                 "3: lumens per lamp is '1e999', expected a number");
  expect_refused("IESNA91\nTILT=NONE\nnan", broken,
                 "3: the number of lamps is 'nan', expected a number");
  expect_refused("IESNA91\nTILT=NONE\n" + std::string(99, 'x'), broken,
                 "3: the number of lamps is '" + std::string(40, 'x') + "...', expected a number");
}

TEST(IesFile, RefusesCountsThatCannotBe) {
  const std::string begin = "IESNA91\nTILT=NONE\n1 1000 1 ";
  expect_refused(begin + "1 1", InputFault::out_of_domain,
                 "3: the number of vertical angles is 1, expected 2 to 100000");
  expect_refused(begin + "-3 1", InputFault::out_of_domain,
                 "3: the number of vertical angles is -3, expected 2 to 100000");
  expect_refused(begin + "2.5 1", InputFault::malformed_file,
                 "3: the number of vertical angles is 2.5, expected a whole number");
  expect_refused(begin + "1e5 1e5", InputFault::too_large,
                 "3: 100000 x 100000 candela, at most 2^22 are read");
  // No memory is asked for what is not there.
  expect_refused(begin + "1e5 40 1 2 0 0 0 1 1 1 0", InputFault::malformed_file,
                 "3: ends before a vertical angle");
}

TEST(IesFile, RefusesOtherPhotometryByItsName) {
  std::string text = round_file;
  const std::size_t type = text.find("3 1 1 2 0.1") + 4;
  text[type] = '2';
  expect_refused(text, InputFault::unsupported, "5: photometry of type B: only type C is read");
  text[type] = '3';
  expect_refused(text, InputFault::unsupported, "5: photometry of type A: only type C is read");
  text[type] = '4';
  expect_refused(text, InputFault::out_of_domain, "5: the photometric type is 4, expected 1 to 3");
}

TEST(IesFile, RefusesAnglesOutOfOrder) {
  const auto broken = InputFault::malformed_file;
  expect_refused(file_of("3 1", "0 90 45", "0", "1 1 1"), broken,
                 "7: a vertical angle is 45, expected more than 90 before it");
  expect_refused(file_of("2 1", "0 190", "0", "1 1"), InputFault::out_of_domain,
                 "7: a vertical angle is 190, expected 0 to 180");
  expect_refused(file_of("2 2", "0 90", "0 60", "1 1 1 1"), broken,
                 "8: horizontal angles end at 60, expected 90, 180 or 360");
  expect_refused(file_of("2 2", "0 90", "10 90", "1 1 1 1"), broken,
                 "8: horizontal angles from 10 to 90, expected 0 to 90, 180 or 360, or 90 to 270");
}

TEST(IesFile, RefusesCandelaThatAreNone) {
  expect_refused(file_of("2 1", "0 90", "0", "1 -1"), InputFault::negative,
                 "9: candela is -1, expected 0 to 1e+30");
  expect_refused(file_of("2 1", "0 90", "0", "1"), InputFault::malformed_file,
                 "10: ends before candela");
  expect_refused(file_of("2 1", "0 90", "0", "1 1", "IESNA91", "TILT=lamp.tlt"),
                 InputFault::unsupported,
                 "4: TILT=lamp.tlt: factors in a file of their own are not read");
}

TEST(IesFile, MayShineStraightDownAlone) {
  const IesLuminaire luminaire = read_ies("a.ies", file_of("2 1", "0 1e-9", "0", "5 5"));
  EXPECT_NEAR(candela(luminaire, 0, 0), 5, 1e-6);
  EXPECT_EQ(candela(luminaire, 0.1, 0), 0);
}

TEST(IesFile, MayShineUpwardsAlone) {
  const IesLuminaire luminaire = read_ies("a.ies", file_of("2 1", "90 180", "0", "8 4"));
  EXPECT_EQ(candela(luminaire, 89.9, 0), 0);
  EXPECT_NEAR(candela(luminaire, 90.1, 0), 8, 0.02);
  EXPECT_NEAR(candela(luminaire, 180, 0), 4, 1e-4);
}

TEST(IesFile, MayBeBlack) {
  const IesLuminaire luminaire = read_ies("a.ies", file_of("2 1", "0 90", "0", "0 0"));
  EXPECT_EQ(luminaire.peak, 0);
  EXPECT_EQ(candela(luminaire, 10, 0), 0);
}

// Cut off anywhere, or with any byte changed, it is read or refused by name.
TEST(IesFile, SurvivesEveryCutAndChange) {
  const std::string whole =
      file_of("2 3", "0 90", "0 45 90", "9 1  9 2  9 4", "IESNA91", "TILT=INCLUDE\n1 2 0 90 1 0.5");
  const auto survives = [](const std::string& text) {
    try {
      (void)read_ies("a.ies", text);
    } catch (const InputError& error) {
      ASSERT_EQ(std::string(error.what()).rfind("a.ies:", 0), 0U) << error.what();
    }
  };
  for (std::size_t i = 0; i < whole.size(); ++i) {
    survives(whole.substr(0, i));
    for (const char c : {'\0', '9', '-', 'e', '\n', '\xff'}) {
      std::string changed = whole;
      changed[i] = c;
      survives(changed);
    }
  }
}

} // namespace
} // namespace lightcuts

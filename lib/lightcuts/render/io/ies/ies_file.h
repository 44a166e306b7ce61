// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <lightcuts/core/lights/profile.h>

namespace lightcuts {

/// A luminaire as a file after IES LM-63 (1986, 1991, 1995, 2002, 2019) describes it. Vertical
/// angle 0 is along a light's axis, horizontal angle 0 along its plane.
struct IesLuminaire {
  Profile profile;                ///< shares of `peak`
  double peak = 0;                ///< candela where it shines most
  std::vector<std::string> notes; ///< what the file says that is left out or made up
};

/// Type C photometry, absolute or relative. Candela are those of the file times its multiplier, its
/// ballast factor, the ballast-lamp factor of editions before 1995, and the TILT factor of an
/// upright luminaire. Between vertical angles they are linear in the angle, by rows in between, at
/// most 2.5 degrees apart, and horizontally likewise, at most 22.5 degrees. Beyond the angles that
/// the file has there is no light.
///
/// `name` is that of the file. Throws InputError, naming it and the line: malformed_file where it
/// breaks the format, unsupported for types A and B and for TILT factors in a file of their own,
/// too_large for more than 2^22 candela.
[[nodiscard]] IesLuminaire read_ies(const std::string& name, std::string_view text);

/// read_ies() of a file; InputError where it cannot be read.
[[nodiscard]] IesLuminaire load_ies(const std::filesystem::path& file);

} // namespace lightcuts

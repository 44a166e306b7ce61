// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace lightcuts::oracle {

/// Runs a gnuplot script, without the user's own gnuplot settings, and returns the SVG document
/// that it draws: 720 × 440 pixels on white, in the colours of Okabe and Ito, which the
/// colour-blind can tell apart. The script plots; it sets no terminal or output, and brings its
/// data along
/// (`$data << EOD`). It must come from this program: gnuplot scripts can run commands.
/// Throws std::runtime_error with gnuplot's own message where it fails, and one that names gnuplot
/// where that is missing.
[[nodiscard]] std::string gnuplot_svg(const std::string& script);

/// Text as a gnuplot string that means just that text; control characters become spaces.
[[nodiscard]] std::string gnuplot_quoted(const std::string& text);

} // namespace lightcuts::oracle

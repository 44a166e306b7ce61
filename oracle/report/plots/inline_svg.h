// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace lightcuts::oracle {

/// The <svg> element of an SVG document, to stand inside an HTML page: without XML header, title
/// and description, and with `prefix` put before every id and every reference to one, so that
/// several drawings on a page do not share theirs. Made for gnuplot's SVG, not for any SVG. A
/// document without <svg> gives an empty string.
[[nodiscard]] std::string inline_svg(std::string_view document, std::string_view prefix);

} // namespace lightcuts::oracle

// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace lightcuts::oracle {

/// Text as it stands in HTML, in an element or in a quoted attribute.
inline std::string html_text(std::string_view text) {
  std::string html;
  for (const char c : text) {
    if (c == '&')
      html += "&amp;";
    else if (c == '<')
      html += "&lt;";
    else if (c == '>')
      html += "&gt;";
    else if (c == '"')
      html += "&quot;";
    else if (c == '\'')
      html += "&#39;";
    else
      html += c;
  }
  return html;
}

} // namespace lightcuts::oracle

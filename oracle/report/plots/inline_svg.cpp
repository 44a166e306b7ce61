// SPDX-License-Identifier: MIT
#include <oracle/report/plots/inline_svg.h>

namespace lightcuts::oracle {
namespace {

void insert_after(std::string& text, std::string_view mark, std::string_view addition) {
  for (std::size_t i = text.find(mark); i != std::string::npos; i = text.find(mark, i))
    text.insert(i += mark.size(), addition);
}

void remove_first(std::string& text, std::string_view open, std::string_view close) {
  const std::size_t begin = text.find(open);
  const std::size_t end = text.find(close, begin);
  if (begin != std::string::npos && end != std::string::npos)
    text.erase(begin, end + close.size() - begin);
}

} // namespace

std::string inline_svg(std::string_view document, std::string_view prefix) {
  const std::size_t begin = document.find("<svg");
  if (begin == std::string_view::npos) return {};
  std::string svg(document.substr(begin));
  remove_first(svg, "<title>", "</title>");
  remove_first(svg, "<desc>", "</desc>");
  for (const char* mark : {" id='", " id=\"", "href='#", "href=\"#", "url(#"})
    insert_after(svg, mark, prefix);
  return svg;
}

} // namespace lightcuts::oracle

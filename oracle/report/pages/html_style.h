// SPDX-License-Identifier: MIT
#pragma once

namespace lightcuts::oracle {

/// The style sheet of report_html, light and dark.
inline constexpr const char* html_style = R"(
:root {
  color-scheme: light dark;
  --page: #fbfbfa; --card: #ffffff; --text: #1d1f21; --soft: #5c6166; --line: #dddedb;
  --accent: #0065a0; --band: #f3f4f2;
}
@media (prefers-color-scheme: dark) {
  :root {
    --page: #16181a; --card: #1e2123; --text: #e6e7e5; --soft: #a2a8ad; --line: #373c40;
    --accent: #6cb8ea; --band: #24282b;
  }
}
* { box-sizing: border-box; }
body {
  margin: 0 auto; padding: 2.5rem 1.5rem 4rem; max-width: 84rem;
  background: var(--page); color: var(--text);
  font: 16px/1.55 system-ui, -apple-system, "Segoe UI", "Helvetica Neue", "DejaVu Sans", sans-serif;
}
h1 { margin: 0; font-size: 2rem; line-height: 1.2; overflow-wrap: anywhere; }
h2 { margin: 2.75rem 0 .75rem; font-size: 1.25rem; }
h3 { margin: 0 0 .25rem; font-size: .95rem; }
p { margin: .5rem 0; max-width: 46rem; }
.over { margin: 0 0 .25rem; color: var(--soft); font-size: .95rem; }
.lead { font-size: 1.1rem; margin-top: 1rem; }
code { font: .92em/1.4 ui-monospace, "DejaVu Sans Mono", monospace; }
.facts { display: flex; flex-wrap: wrap; gap: .75rem 2.25rem; margin: 1.5rem 0 0; }
.facts dt { color: var(--soft); font-size: .8rem; }
.facts dd { margin: 0; font-size: 1.1rem; font-variant-numeric: tabular-nums; }
.columns {
  display: grid; grid-template-columns: repeat(auto-fit, minmax(min(20rem, 100%), 1fr));
  gap: 0 2rem;
}
.columns ul { margin: .25rem 0; padding-left: 1.2rem; }
.wide {
  overflow-x: auto; border: 1px solid var(--line); border-radius: 8px; background: var(--card);
}
table {
  border-collapse: separate; border-spacing: 0; width: 100%;
  font-size: .78rem; font-variant-numeric: tabular-nums;
}
th, td { padding: .4rem .4rem; text-align: right; white-space: nowrap; }
thead th { vertical-align: bottom; white-space: normal; font-weight: 600; line-height: 1.2; }
.groups th { padding-bottom: 0; text-align: left; color: var(--soft); font-weight: 400; }
.groups th + th, .first:not(:first-child) { border-left: 1px solid var(--line); }
th:first-child, td:first-child { text-align: left; padding-left: .8rem; }
tbody td { border-top: 1px solid var(--line); }
tbody tr:hover td { background: var(--band); }
td:first-child, tr:not(.groups) > th:first-child {
  position: sticky; left: 0; background: var(--card);
}
.reference td { color: var(--soft); }
.plots {
  display: grid; grid-template-columns: repeat(auto-fit, minmax(min(32rem, 100%), 1fr));
  gap: 1.25rem;
}
.pictures {
  display: grid; grid-template-columns: repeat(auto-fill, minmax(min(24rem, 100%), 1fr));
  gap: 1.25rem;
}
figure {
  margin: 0; padding: .75rem; border: 1px solid var(--line); border-radius: 8px;
  background: var(--card);
}
figcaption { margin-top: .5rem; color: var(--soft); font-size: .9rem; }
figure svg { display: block; width: 100%; height: auto; border-radius: 4px; }
figure img {
  display: block; width: 100%; height: auto; border-radius: 4px; image-rendering: pixelated;
}
.missing {
  margin: 0; padding: 2rem 1rem; background: var(--band); border-radius: 4px;
  overflow-wrap: anywhere;
}
.legend {
  display: grid; grid-template-columns: repeat(auto-fill, minmax(min(24rem, 100%), 1fr));
  gap: .9rem 2rem; margin: 1rem 0 0;
}
.legend dt { font-weight: 600; }
.legend dt span { color: var(--soft); font-weight: 400; font-size: .85rem; margin-left: .3rem; }
.legend dd { margin: 0; font-size: .92rem; }
.legend code { color: var(--accent); }
@media (max-width: 50rem) { body { padding: 1.25rem .9rem 3rem; } h1 { font-size: 1.6rem; } }
@media print { figure, .wide { break-inside: avoid; } }
)";

} // namespace lightcuts::oracle

#include "analysis/report/page_parts.hpp"

namespace bimodal::analysis {

std::string_view page_style() {
  return R"(
:root { --ink: #1b2733; --soft: #5b6875; --rule: #c9d1d9; --blue: #2171b5; --deep: #08306b; }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 32px 28px 64px; max-width: 1000px; color: var(--ink);
  background: #fff; font: 15px/1.5 "Source Sans 3", "Segoe UI", "Helvetica Neue", "Liberation Sans",
  Arial, sans-serif; }
h1 { margin: 0 0 4px; font-size: 30px; line-height: 1.2; font-weight: 600; color: var(--deep); }
h2 { margin: 44px 0 10px; padding-bottom: 4px; font-size: 21px; font-weight: 600;
  color: var(--deep); border-bottom: 1px solid var(--rule); }
h3 { margin: 26px 0 6px; font-size: 16px; font-weight: 600; }
p { margin: 8px 0; max-width: 78ch; }
.lead { color: var(--soft); margin: 0 0 18px; }
.simulated { margin: 18px 0; padding: 12px 18px; border-left: 8px solid #b35806; background: #fdeedd;
  max-width: none; }
.simulated strong { font-size: 19px; letter-spacing: .12em; color: #7f3b08; }
.warnings { margin: 18px 0; padding: 10px 18px; border-left: 8px solid #c9a227; background: #fffbe9; }
.warnings h2 { margin: 0 0 4px; padding: 0; border: 0; font-size: 16px; color: var(--ink); }
.warnings ul { margin: 0; padding-left: 20px; }
table { border-collapse: collapse; margin: 10px 0 4px; font-size: 14px;
  border-top: 1.5px solid var(--ink); border-bottom: 1.5px solid var(--ink); }
th, td { padding: 4px 12px 4px 0; text-align: left; vertical-align: top; }
caption { text-align: left; font-weight: 600; font-size: 14px; padding-bottom: 4px; }
tbody th { font-weight: 600; }
thead th { border-bottom: 1px solid var(--ink); font-weight: 600; vertical-align: bottom; }
td.number, th.number { text-align: right; font-variant-numeric: tabular-nums;
  white-space: nowrap; }
td.estimate, th.estimate { white-space: nowrap; font-variant-numeric: tabular-nums; }
tbody tr.first td, tbody tr.first th { border-top: 1px solid var(--rule); }
.note { font-size: 13px; color: var(--soft); }
.hash { font: 12px/1.4 "Source Code Pro", "DejaVu Sans Mono", Consolas, monospace;
  overflow-wrap: anywhere; }
figure { margin: 16px 0 26px; break-inside: avoid; }
figcaption { font-size: 14px; max-width: 78ch; }
figcaption b { color: var(--deep); }
svg { display: block; max-width: 100%; height: auto; }
.side { display: flex; flex-wrap: wrap; gap: 3mm; align-items: flex-start; }
@media screen { figure > svg { width: 100%; max-width: 860px; }
  figure.column > svg { max-width: 460px; }
  .side > svg { flex: 1 1 320px; min-width: 0; } }
.trial { display: flex; flex-wrap: wrap; gap: 24px; align-items: flex-start; }
.trial figure { margin: 8px 0; }
.trial img { display: block; max-width: 460px; width: 100%; height: auto;
  border: 1px solid var(--rule); }
.trial audio { width: 360px; max-width: 100%; }
figure[data-unit] svg text { pointer-events: none; }
figure[data-unit] rect[data-cell][tabindex] { cursor: pointer; }
figure[data-unit] rect[data-cell]:focus { outline: 2px solid #b35806; }
.choices { margin: 4px 0; font-size: 13px; color: var(--soft); }
.choices button, .listed button { font: inherit; margin-left: 8px; }
.listed { margin: 8px 0 20px; padding: 8px 14px; border: 1px solid var(--rule);
  max-height: 26em; overflow: auto; }
.command { font: 12px/1.5 "Source Code Pro", "DejaVu Sans Mono", Consolas, monospace;
  overflow-wrap: anywhere; }
.reproduction { border: 1px solid var(--rule); padding: 4px 14px 10px; }
dt { font-weight: 600; margin-top: 8px; }
dd { margin: 0 0 0 0; max-width: 78ch; }
@media print {
  body { padding: 0; max-width: none; font-size: 10.5pt; }
  h2 { break-after: avoid; } h3 { break-after: avoid; }
  tr { break-inside: avoid; }
  * { print-color-adjust: exact; -webkit-print-color-adjust: exact; }
  audio, .choices, .listed { display: none; }
  @page { margin: 16mm 15mm; }
}
)";
}

}  // namespace bimodal::analysis

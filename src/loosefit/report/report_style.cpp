#include "loosefit/report/report_style.h"

namespace loosefit::report {

const char* const kReportStyle = R"css(
:root { color-scheme: light dark; --ink: #1c2126; --soft: #566069; --rule: #d9dee3; --edge: #b6bfc8;
  --paper: #ffffff; --wash: #f4f6f8; --accent: #0b5fa5; --probe: #c4006a; --good: #1d6b3a; --good-wash: #e9f5ed;
  --bad: #a3161f; --bad-wash: #fdecec; --warn: #7a5200; --warn-wash: #fff5dd; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #e7ebef; --soft: #a2adb8; --rule: #333c45; --edge: #56616c; --paper: #14181c; --wash: #1d2329;
    --accent: #79b8ff; --probe: #ff7ac0; --good: #7fd29c; --good-wash: #14291c; --bad: #ff9c9c; --bad-wash: #331719;
    --warn: #f0c674; --warn-wash: #2e2612; }
  svg [stroke="#e3e7eb"] { stroke: #333c45; } svg [stroke="#5b6670"], svg [stroke="#5c6b7a"] { stroke: #8b97a3; }
  svg [stroke="#2458a8"] { stroke: #79b8ff; } svg [fill="#2458a8"] { fill: #79b8ff; } svg [stroke="#1d6b3a"] { stroke: #7fd29c; }
  svg [stroke="#a3161f"] { stroke: #ff9c9c; } figure img { filter: brightness(.92); } }
* { box-sizing: border-box; }
body { margin: 0 auto; max-width: 1320px; padding: 1rem 1.25rem 3rem; color: var(--ink);
  background: var(--paper); font: 15px/1.5 system-ui, "Segoe UI", "Helvetica Neue", Arial, sans-serif; }
h1 { font-size: 1.7rem; line-height: 1.2; margin: 0 0 .25rem; }
h2 { font-size: 1.2rem; margin: 2.2rem 0 .6rem; padding-top: .6rem; border-top: 1px solid var(--rule); }
h3 { font-size: 1rem; margin: 1.2rem 0 .4rem; }
p { margin: .4rem 0; max-width: 85ch; }
.lead { color: var(--soft); font-size: 1.05rem; max-width: none; }
.box { border-left: 5px solid; padding: .6rem 1rem; margin: .7rem 0; border-radius: 3px; }
.warn { font-size: .92rem; } .warn ul { margin: .1rem 0 0; padding-left: 1.2rem; } .warn li { margin: 0; }
.box strong { font-size: 1.1rem; }
.good { color: var(--good); background: var(--good-wash); }
.bad { color: var(--bad); background: var(--bad-wash); }
.warn { color: var(--warn); background: var(--warn-wash); }
.facts { display: flex; flex-wrap: wrap; gap: .3rem 2rem; margin: .6rem 0 0; padding: 0; list-style: none;
  color: var(--ink); }
.facts b { font-variant-numeric: tabular-nums; }
.pictures { display: grid; grid-template-columns: repeat(auto-fit, minmax(255px, 1fr)); gap: .5rem; }
figure { margin: 0; border: 1px solid var(--rule); border-radius: 4px; overflow: hidden; }
figure img { display: block; width: 100%; height: auto; }
figcaption { padding: .3rem .6rem; font-size: .85rem; color: var(--soft); border-top: 1px solid var(--rule); }
.columns { display: grid; grid-template-columns: repeat(auto-fit, minmax(330px, 1fr)); gap: 0 2.5rem; }
.soft { color: var(--soft); font-size: .88rem; max-width: none; }
.answers { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 540px), 1fr)); gap: .7rem; margin: .7rem 0; }
.answer { display: flex; gap: 1rem; padding: .6rem 1rem; align-items: flex-start; border: 1px solid var(--rule); border-radius: 6px; }
.answer > div:last-child { min-width: 0; flex: 1; } .places { display: flex; flex-direction: column; gap: .4rem; flex: none; }
.places svg { width: 110px; max-height: 130px; height: auto; }
.answer:only-child .places { flex-direction: row; } .answer:only-child .places svg { width: 170px; max-height: 190px; }
.answer h2 { font-size: 1rem; margin: 0 0 .2rem; padding: 0; border: 0; }
.answer p { margin: .15rem 0; font-size: .9rem; line-height: 1.35; max-width: 100ch; } .answer p.soft { font-size: .82rem; }
.piece { fill: var(--wash); stroke: var(--edge); } .seam { fill: none; stroke: var(--soft); stroke-width: .8; }
.spot { fill: var(--probe); } .answer .axis { stroke: var(--probe); stroke-width: 2; }
@media (max-width: 560px) { .answer { flex-direction: column; } .places { flex-direction: row; } .places svg { width: 90px; } }
.scroll { overflow-x: auto; }
.scroll th:first-child { position: sticky; left: 0; background: var(--paper); z-index: 1; }
.scroll .words { text-align: left; white-space: normal; min-width: 15rem; }
table { border-collapse: collapse; width: 100%; font-size: .9rem; font-variant-numeric: tabular-nums; }
th, td { padding: .28rem .7rem .28rem 0; text-align: right; white-space: nowrap;
  border-bottom: 1px solid var(--rule); }
thead th { color: var(--soft); font-weight: 600; vertical-align: bottom; white-space: normal; }
th:first-child { text-align: left; font-weight: 500; }
tbody tr:hover { background: var(--wash); }
dl { margin: .4rem 0; max-width: 95ch; } dt { font-weight: 600; margin-top: .5rem; } dd { margin: 0 0 0 1rem; color: var(--soft); max-width: 85ch; }
pre { background: var(--wash); padding: .8rem 1rem; overflow-x: auto; font-size: .82rem; line-height: 1.4; }
details summary { cursor: pointer; color: var(--soft); }
.stills > summary h2 { display: inline-block; margin: 1rem 0 .6rem; padding: 0; border: 0; color: var(--ink); }
.verdict { display: inline-block; font-weight: 600; padding: .1rem .6rem; border-radius: 1rem; margin-right: .5rem; }
a { color: var(--accent); }
svg text { font: 11px system-ui, sans-serif; fill: var(--soft); }
@media print { body { max-width: none; padding: 0; font-size: 10pt; } h2 { break-after: avoid; }
  figure, tr { break-inside: avoid; } .pictures { grid-template-columns: repeat(4, 1fr); } }
)css";

}  // namespace loosefit::report

// How long a report takes to open and to answer, in headless Chromium with software rendering.
// usage: node bench/page/page_bench.mjs MODULES_FOLDER REPORT.html [REPORT.html ...]
//   MODULES_FOLDER: build/page/work
// Prints one JSON line per report: size, load (to the first picture), probe and frame, milliseconds.
import { statSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { openBrowser, ready } from "../../tests/web/browser.mjs";

const [modules, ...reports] = process.argv.slice(2).map((path) => resolve(path));

function quantile(values, share) {
  const sorted = [...values].sort((a, b) => a - b);
  return Math.round(10 * sorted[Math.min(sorted.length - 1, Math.floor(share * sorted.length))]) / 10;
}

for (const report of reports) {
  const loads = [];
  let probes = [], frames = [], triangles = 0;
  for (let i = 0; i < 3; ++i) {
    const browser = await openBrowser(modules);
    const begun = performance.now();
    await browser.page.goto(pathToFileURL(report).href);
    if (await ready(browser.page) !== "viewer") throw new Error(`${report}: the viewer did not start`);
    loads.push(performance.now() - begun);
    if (i === 0) {
      triangles = await browser.page.evaluate(() => window.loosefit.data.triangles.length / 3);
      probes = await browser.page.evaluate(() => {
        const out = [];
        for (let k = 0; k < 60; ++k) out.push(window.loosefit.timeProbe(200 + 3 * k, 120 + 4 * k));
        return out;
      });
      frames = await browser.page.evaluate(() => Array.from({ length: 12 }, () => window.loosefit.timeFrame()));
    }
    await browser.close();
  }
  console.log(JSON.stringify({ report, megabytes: Math.round(statSync(report).size / 1e4) / 100, triangles,
    load_ms: Math.round(quantile(loads, 0.5)), probe_ms: { median: quantile(probes, 0.5), p95: quantile(probes, 0.95) },
    frame_ms: quantile(frames, 0.5) }));
}

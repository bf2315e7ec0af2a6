// A headless Chromium with software WebGL and nothing that goes to the network by itself.
import { mkdtempSync, rmSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";

const kArguments = ["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
  "--disable-background-networking", "--disable-component-update", "--disable-sync", "--hide-scrollbars",
  "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--force-color-profile=srgb"];

/** `modules`: the folder that holds node_modules (the build's copy of web/). */
export async function openBrowser(modules, options = {}) {
  const { chromium } = createRequire(join(modules, "package.json"))("playwright-core");
  const profile = mkdtempSync(join(tmpdir(), "loosefit-browser-"));
  const context = await chromium.launchPersistentContext(profile, {
    executablePath: process.env.LOOSEFIT_CHROMIUM ?? "/usr/bin/chromium", headless: true, args: [...kArguments, ...(options.args ?? [])],
    ignoreDefaultArgs: ["--enable-automation"],
    viewport: options.viewport ?? { width: 1280, height: 800 }, colorScheme: options.dark ? "dark" : "light",
    reducedMotion: "reduce", acceptDownloads: true, timeout: 60000,
  });
  context.setDefaultTimeout(10000);
  return {
    context,
    page: context.pages()[0] ?? await context.newPage(),
    async close() {
      await context.close();
      rmSync(profile, { recursive: true, force: true });
    },
  };
}

/** Waits until the page says that it is ready; returns "viewer", "pictures" or "tables". */
export async function ready(page) {
  await page.waitForFunction(() => document.documentElement.dataset.ready, null, { timeout: 30000 });
  return await page.evaluate(() => document.documentElement.dataset.ready);
}

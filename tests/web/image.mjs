// Pictures compared block by block, so that a pixel of antialiasing here or there does not count.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname } from "node:path";

const kWidth = 480; // of a stored picture

/** In the page of a browser: both PNGs shrunk to one width, and how far they are apart. */
async function compared(page, now, then) {
  return await page.evaluate(async ([width, ...pictures]) => {
    const made = [];
    for (const data of pictures) {
      const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
      const canvas = new OffscreenCanvas(width, Math.round(width * image.height / image.width));
      const context = canvas.getContext("2d", { willReadFrequently: true });
      context.imageSmoothingQuality = "high";
      context.drawImage(image, 0, 0, canvas.width, canvas.height);
      made.push({ canvas, pixels: context.getImageData(0, 0, canvas.width, canvas.height).data });
    }
    const bytes = new Uint8Array(await (await made[0].canvas.convertToBlob({ type: "image/png" })).arrayBuffer());
    let text = "";
    for (const b of bytes) text += String.fromCharCode(b);
    const result = { png: btoa(text), heights: made.map((m) => m.canvas.height), mean: 0, share: 0 };
    if (made.length < 2 || result.heights[0] !== result.heights[1]) return result;
    const [x, y] = made.map((m) => m.pixels), pixels = x.length / 4;
    for (let i = 0; i < x.length; i += 4) {
      const off = Math.max(...[0, 1, 2].map((k) => Math.abs(x[i + k] - y[i + k])));
      result.mean += off / pixels;
      if (off > 42) result.share += 1 / pixels;
    }
    return result;
  }, [kWidth, now.toString("base64"), ...(then ? [then.toString("base64")] : [])]);
}

/**
 * Fails unless the picture is like its baseline: mean difference, and the share of pixels that are
 * off by more than a sixth. A missing baseline is written, and that is a failure, too.
 */
export async function compareWithBaseline(page, png, baseline, output, most = { mean: 4, share: 0.03 }) {
  const renew = Boolean(process.env.LOOSEFIT_NEW_BASELINES), known = existsSync(baseline) && !renew;
  const found = await compared(page, png, known ? readFileSync(baseline) : null);
  const small = Buffer.from(found.png, "base64");
  mkdirSync(dirname(output), { recursive: true });
  writeFileSync(output, small);
  if (!known) {
    mkdirSync(dirname(baseline), { recursive: true });
    writeFileSync(baseline, small);
    if (!renew) throw new Error(`no baseline: look at ${baseline}, which was written`);
    return;
  }
  const [height, expected] = found.heights;
  if (height !== expected) throw new Error(`${output}: ${height} pixels high, expected ${expected}`);
  if (found.mean > most.mean || found.share > most.share)
    throw new Error(`${output} differs from ${baseline}: mean ${found.mean.toFixed(2)} of 255, ` +
      `${(100 * found.share).toFixed(1)} % of the pixels far off (at most ${most.mean} and ${100 * most.share} %)`);
}

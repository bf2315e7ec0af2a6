// Pictures compared block by block, so that a pixel of antialiasing here or there does not count.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";

const kWidth = 480; // of a stored picture

/** Shrinks a PNG in the page of a browser; returns PNG bytes and grey-free pixel values. */
async function shrunk(page, png, width) {
  return await page.evaluate(async ([data, wide]) => {
    const image = await createImageBitmap(await (await fetch(`data:image/png;base64,${data}`)).blob());
    const canvas = new OffscreenCanvas(wide, Math.round(wide * image.height / image.width));
    const context = canvas.getContext("2d", { willReadFrequently: true });
    context.imageSmoothingQuality = "high";
    context.drawImage(image, 0, 0, canvas.width, canvas.height);
    const bytes = new Uint8Array(await (await canvas.convertToBlob({ type: "image/png" })).arrayBuffer());
    let text = "";
    for (const b of bytes) text += String.fromCharCode(b);
    const { data: rgba } = context.getImageData(0, 0, canvas.width, canvas.height);
    return { png: btoa(text), width: canvas.width, height: canvas.height, rgba: Array.from(rgba) };
  }, [png.toString("base64"), width]);
}

/**
 * Fails unless the picture is like its baseline: mean difference and the share of pixels that are
 * off by more than a sixth. A missing baseline is written, and that is a failure, too.
 */
export async function compareWithBaseline(page, png, baseline, output) {
  const now = await shrunk(page, png, kWidth);
  mkdirSync(dirname(output), { recursive: true });
  writeFileSync(output, Buffer.from(now.png, "base64"));
  if (!existsSync(baseline) || process.env.LOOSEFIT_NEW_BASELINES) {
    mkdirSync(dirname(baseline), { recursive: true });
    writeFileSync(baseline, Buffer.from(now.png, "base64"));
    if (!process.env.LOOSEFIT_NEW_BASELINES) throw new Error(`no baseline: look at ${baseline}, which was written`);
    return;
  }
  const then = await shrunk(page, readFileSync(baseline), kWidth);
  if (then.height !== now.height) throw new Error(`${output}: ${now.height} pixels high, expected ${then.height}`);
  let sum = 0, far = 0;
  const pixels = now.rgba.length / 4;
  for (let i = 0; i < now.rgba.length; i += 4) {
    const off = Math.max(...[0, 1, 2].map((k) => Math.abs(now.rgba[i + k] - then.rgba[i + k])));
    sum += off;
    if (off > 42) ++far;
  }
  const mean = sum / pixels, share = far / pixels;
  if (mean > 4 || share > 0.03)
    throw new Error(`${output} differs from ${baseline}: mean ${mean.toFixed(2)} of 255, ` +
      `${(100 * share).toFixed(1)} % of the pixels far off (at most 4 and 3 %)`);
}

export const baselineFolder = (here) => join(here, "baselines");

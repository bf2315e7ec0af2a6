// A view as a picture to take home: with its title and colour bar, on the paper's colour.
import type { MapStyle, MapValues } from "./case_data";
import type { Scale } from "./colour_scale";
import { drawBar, titleText } from "./legend";
import type { Ink } from "./marks";
import type { PatternView } from "./pattern_view";
import type { WornView } from "./worn_view";

const kFoot = 74; // height of title and bar [px]

/** What is on a picture beside the view; null: plain cloth. */
export interface PictureMap {
  scale: Scale;
  style: MapStyle;
  values: MapValues | undefined;
}

export function makePicture(view: WornView | PatternView, map: PictureMap | null, ink: Ink): HTMLCanvasElement {
  view.render();
  const source = view.renderer.domElement, ratio = view.renderer.getPixelRatio();
  const over = source.nextElementSibling as HTMLCanvasElement;
  const width = source.clientWidth, height = source.clientHeight, foot = map ? kFoot : 0;
  const sheet = document.createElement("canvas");
  sheet.width = Math.round(width * ratio);
  sheet.height = Math.round((height + foot) * ratio);
  const c = sheet.getContext("2d")!;
  c.scale(ratio, ratio);
  c.fillStyle = ink.paper;
  c.fillRect(0, 0, width, height + foot);
  c.drawImage(source, 0, 0, width, height);
  c.drawImage(over, 0, 0, width, height);
  if (map) {
    c.fillStyle = ink.text;
    c.font = "600 13px system-ui, sans-serif";
    c.textAlign = "center";
    c.textBaseline = "top";
    c.fillText(titleText(map.style, map.values), width / 2, height + 4);
    const bar = Math.min(520, width - 60);
    drawBar(c, { x: (width - bar) / 2, y: height + 26, width: bar, height: 16 }, map.scale, map.style, map.values,
            ink.text, null);
  }
  return sheet;
}

// The colour bar: title with unit, ticks, how the values of the drape lie on it.
import type { MapStyle, MapValues } from "./case_data";
import { cssColour, shareOf, tickText, unitText, type Scale } from "./colour_scale";

export function titleText(style: MapStyle, values: MapValues | undefined): string {
  const unit = style.unit === "–" || !style.unit ? "" : ` [${style.unit}]`;
  return (values?.title ?? style.title) + unit;
}

interface Bar {
  x: number;
  y: number;
  width: number;
  height: number;
}

/** Bar, ticks, and a needle at `needle` (a value) if there is one. */
export function drawBar(c: CanvasRenderingContext2D, bar: Bar, scale: Scale, style: MapStyle,
                        values: MapValues | undefined, text: string, needle: number | null): void {
  for (let i = 0; i < bar.width; ++i) {
    c.fillStyle = cssColour(scale, (i + 0.5) / bar.width);
    c.fillRect(bar.x + i, bar.y, 1.5, bar.height);
  }
  c.strokeStyle = text;
  c.lineWidth = 1;
  c.strokeRect(bar.x - 0.5, bar.y - 0.5, bar.width + 1, bar.height + 1);
  c.fillStyle = text;
  c.font = "12px system-ui, sans-serif";
  c.textBaseline = "top";
  const last = scale.ticks.length - 1;
  scale.ticks.forEach((tick, i) => {
    const share = shareOf(scale, tick), x = bar.x + share * bar.width;
    c.fillRect(x - 0.5, bar.y + bar.height, 1, 5);
    let label = tickText(tick, style);
    if (i === 0 && share < 0.01 && values && values.min < scale.low - 1e-9) label = "≤ " + label;
    if (i === last && share > 0.99 && values && values.max > scale.high + 1e-9) label = "≥ " + label;
    c.textAlign = share < 0.04 ? "left" : share > 0.96 ? "right" : "center";
    c.fillText(label, share < 0.04 ? bar.x : share > 0.96 ? bar.x + bar.width : x, bar.y + bar.height + 8);
  });
  if (needle === null || Number.isNaN(needle)) return;
  const x = bar.x + Math.max(0, Math.min(1, shareOf(scale, needle))) * bar.width;
  c.beginPath();
  c.moveTo(x, bar.y + 4);
  c.lineTo(x - 6, bar.y - 7);
  c.lineTo(x + 6, bar.y - 7);
  c.closePath();
  c.fill();
}

export class Legend {
  constructor(private readonly canvas: HTMLCanvasElement) {}

  draw(scale: Scale, style: MapStyle, values: MapValues | undefined, text: string, needle: number | null): void {
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    const ratio = Math.min(2, window.devicePixelRatio || 1);
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    const c = this.canvas.getContext("2d")!;
    c.setTransform(ratio, 0, 0, ratio, 0, 0);
    drawBar(c, { x: 8, y: 10, width: width - 16, height: 16 }, scale, style, values, text, needle);
    this.canvas.setAttribute("aria-label", `Colour bar from ${tickText(scale.low, style)} to ` +
      `${tickText(scale.high, style)}${unitText(style)}`);
  }

  clear(): void {
    const c = this.canvas.getContext("2d")!;
    c.setTransform(1, 0, 0, 1, 0, 0);
    c.clearRect(0, 0, this.canvas.width, this.canvas.height);
  }
}

// From values to places on the colour bar, as render/colour_table.cpp has it.
import type { Case, MapStyle, MapValues } from "./case_data";

/** The scale that one map is drawn with; values in the map's own unit (strains as fractions). */
export interface Scale {
  low: number;
  high: number;
  breaks: number[]; // equal steps of the bar; empty: linear
  ticks: number[];
  lines: number; // contour lines at equal steps of the bar: this many steps
  middle: boolean; // with one half way: not at the zero of a signed map, where noise would draw it
  table: Uint8Array; // 256 × RGB
}

export type RangeChoice = "fit" | "fixed" | "drape" | "own";

/** Round numbers from low to high, four to seven of them. */
export function niceTicks(low: number, high: number): number[] {
  if (!(high > low)) return [low];
  const rough = (high - low) / 5, power = 10 ** Math.floor(Math.log10(rough));
  const share = rough / power;
  const step = power * (share < 1.5 ? 1 : share < 3.5 ? 2 : share < 7.5 ? 5 : 10);
  const ticks: number[] = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k)
    ticks.push(k * step);
  return ticks;
}

export function makeScale(data: Case, style: MapStyle, values: MapValues | undefined,
                          choice: RangeChoice, own: [number, number]): Scale {
  const table = style.diverging ? data.colours.diverging : data.colours.sequential;
  if (choice === "fixed" || choice === "fit") {
    if (style.breaks.length > 1)
      return { low: style.low, high: style.high, breaks: style.breaks, ticks: style.breaks,
               lines: style.breaks.length - 1, middle: true, table };
    const [low, high] = choice === "fit" ? style.fitted : [style.low, style.high];
    const ticks = [0, 1, 2, 3, 4].map((k) => low + (high - low) * k / 4);
    return { low, high, breaks: [], ticks, lines: 8, middle: !style.diverging, table };
  }
  let [low, high] = own;
  if (choice === "drape" && values) {
    low = values.min;
    high = values.max;
    if (style.diverging) { // zero keeps the colour in the middle
      high = Math.max(Math.abs(low), Math.abs(high));
      low = -high;
    }
  }
  if (!(high > low)) high = low + (Math.abs(low) * 1e-3 || 1e-6);
  const ticks = niceTicks(low, high);
  return { low, high, breaks: [], ticks, lines: 8, middle: !style.diverging, table };
}

/** 0 at low, 1 at high, not limited on a linear scale; NaN for NaN. */
export function shareOf(scale: Scale, value: number): number {
  const { breaks } = scale;
  if (breaks.length < 2) return (value - scale.low) / (scale.high - scale.low);
  if (Number.isNaN(value)) return NaN;
  const last = breaks.length - 1;
  if (value <= breaks[0]) return 0;
  if (value >= breaks[last]) return 1;
  let k = 0;
  while (value >= breaks[k + 1]) ++k;
  return (k + (value - breaks[k]) / (breaks[k + 1] - breaks[k])) / last;
}

/** "−0.05", "20": no needless digits. */
export function tickText(value: number, style: MapStyle): string {
  const shown = style.percent ? 100 * value : value;
  const text = String(parseFloat((Math.abs(shown) < 1e-12 ? 0 : shown).toPrecision(4)));
  return text.replace("-", "\u2212");
}

/** A value with the decimals of its map, without unit. */
export function valueText(value: number, style: MapStyle): string {
  if (!Number.isFinite(value)) return "–";
  const text = (style.percent ? 100 * value : value).toFixed(style.decimals);
  return (/^-0(\.0*)?$/.test(text) ? text.slice(1) : text).replace("-", "\u2212");
}

/** " mm", " %", "°", or nothing. */
export function unitText(style: MapStyle): string {
  if (style.unit === "–" || style.unit === "") return "";
  return style.unit === "deg" ? "°" : "\u00a0" + style.unit;
}

export function cssColour(scale: Scale, share: number): string {
  const k = 3 * Math.max(0, Math.min(255, Math.floor(share * 256)));
  return `rgb(${scale.table[k]},${scale.table[k + 1]},${scale.table[k + 2]})`;
}

// What the reader takes home: tables, values and pictures.
import type { Case, State } from "./case_data";

export function save(name: string, content: Blob): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content);
  link.download = name;
  document.body.append(link);
  link.click();
  link.remove();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

export function saveText(name: string, text: string): void {
  save(name, new Blob([text], { type: "text/csv;charset=utf-8" }));
}

/** A field as RFC 4180 wants it; a text that a spreadsheet would take for a formula is led by an apostrophe, as in
 * io/csv.cpp. Numbers, also of percent, stay as they are. */
export function csvCell(text: string): string {
  const formula = /^'* *[=+\-@\uff1d\uff0b\uff0d\uff20]/.test(text) && !/^[+-]?\d[\d.]*(e[+-]?\d+)?( ?%)?$/i.test(text);
  const safe = formula ? `'${text}` : text;
  return /[",;\n]/.test(safe) ? `"${safe.replace(/"/g, "\"\"")}"` : safe;
}

/** One row per vertex: place in the pattern, position as worn, all maps of the state, skin under it. */
export function valuesCsv(data: Case, state: State): string {
  const arrays = [...state.maps.keys()];
  const first = new Int32Array(data.vertices).fill(-1);
  for (let i = data.cornerVertex.length - 1; i >= 0; --i) first[data.cornerVertex[i]] = i;
  const head = ["vertex", "panel", "u_mm", "v_mm", "x_m", "y_m", "z_m", ...arrays];
  if (data.skin) head.push("region", "segment", "percent_x", "percent_y", "percent_z");
  const rows = [head.join(",")];
  const digits = (x: number, n: number) => (Number.isNaN(x) ? "" : String(Number(x.toPrecision(n))));
  for (let v = 0; v < data.vertices; ++v) {
    const i = first[v];
    if (i < 0) continue;
    const row = [String(v), csvCell(data.panels[data.cornerPanel[i]].id),
                 (1000 * data.cornerUv[2 * i]).toFixed(1), (1000 * data.cornerUv[2 * i + 1]).toFixed(1),
                 ...[0, 1, 2].map((k) => state.positions[3 * v + k].toFixed(5)),
                 ...arrays.map((a) => digits(state.maps.get(a)!.values[v], 5))];
    if (data.skin)
      row.push(csvCell(data.skin.regions[data.skin.region[v]]), csvCell(data.skin.segments[data.skin.segment[v]]),
               ...[0, 1, 2].map((k) => data.skin!.segment[v] ? data.skin!.percent[3 * v + k].toFixed(1) : ""));
    rows.push(row.join(","));
  }
  return rows.join("\r\n") + "\r\n";
}

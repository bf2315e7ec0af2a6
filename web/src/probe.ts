// What is known of one point of the garment.
import type { Case, State } from "./case_data";
import { unitText, valueText } from "./colour_scale";
import { interpolated, type SurfacePoint } from "./picking";

export interface Reading {
  value: number; // of the map, in its own unit; NaN without map or where not defined
  text: string; // with unit
  panel: string;
  u: number; // [m]
  v: number;
  position: number[];
  region: string | null;
  address: string | null; // in the reference state
  skin: number[] | null; // the partner on the body, in the reference state [m]
  gap: number | null; // straight distance to it [m]
  touches: boolean | null;
}

/** Of a vertex field that jumps between limbs, the corner with the greatest weight decides. */
function nearestCorner(point: SurfacePoint): number {
  const [a, b, c] = point.weights;
  return a >= b && a >= c ? 0 : b >= c ? 1 : 2;
}

export function readPoint(data: Case, state: State, isReference: boolean, array: string | null,
                          point: SurfacePoint): Reading {
  const { triangles, cornerVertex } = data;
  const style = array ? data.maps.get(array) : undefined;
  const values = array ? state.maps.get(array) : undefined;
  const value = values ? interpolated(point, triangles, cornerVertex, values.values, 1)[0] : NaN;
  const [u, v] = interpolated(point, triangles, null, data.cornerUv, 2);
  const position = interpolated(point, triangles, cornerVertex, state.positions, 3);
  const corners = [0, 1, 2].map((k) => cornerVertex[triangles[3 * point.triangle + k]]);
  const vertex = corners[nearestCorner(point)];
  const reading: Reading = {
    value, text: style ? valueText(value, style) + (Number.isNaN(value) ? "" : unitText(style)) : "",
    panel: data.panels[data.cornerPanel[triangles[3 * point.triangle]]].name, u, v, position,
    region: null, address: null, skin: null, gap: null,
    touches: state.touching ? corners.every((c) => state.touching![c] === 1) : null,
  };
  const { skin } = data;
  if (!skin) return reading;
  reading.region = skin.regions[skin.region[vertex]];
  const one = corners.every((c) => skin.segment[c] === skin.segment[vertex]);
  const at = (field: Float32Array) => one
    ? interpolated(point, triangles, cornerVertex, field, 3)
    : Array.from(field.subarray(3 * vertex, 3 * vertex + 3));
  if (skin.segment[vertex] > 0) {
    const percent = at(skin.percent).map((p) => p.toFixed(0).replace("-", "\u2212"));
    reading.address = `${skin.segments[skin.segment[vertex]]} [${percent.join(", ")}]`;
  }
  if (isReference) {
    reading.skin = at(skin.points);
    reading.gap = Math.hypot(...reading.skin.map((s, k) => s - position[k]));
  }
  return reading;
}

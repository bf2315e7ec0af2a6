// What a report holds: the JSON of src/loosefit/report/page_scene.cpp and page_places.cpp, and the
// block of arrays that it refers to.

export interface Packed {
  at: number;
  count: number;
  bytes: 1 | 2 | 4;
  size: number;
  low?: number[];
  step?: number[];
}

export interface MapStyle {
  title: string;
  unit: string;
  low: number;
  high: number;
  fitted: [number, number]; // round ends that hold nearly all of the cloth, in all states
  diverging: boolean;
  percent: boolean;
  decimals: number;
  breaks: number[];
  companion: boolean;
  meaning: string;
  formula: string;
  source: string;
}

interface StateJson {
  name: string; // of the posture

  posture: number;
  donning: number;
  holds: boolean;
  body: number;
  positions: Packed;
  touching: Packed | null;
  maps: Record<string, { title: string; values: Packed; min: number; median: number; max: number }>;
  slip: { from: Packed; to: Packed } | null;
}

interface SurfaceJson {
  points: Packed;
  triangles: Packed;
}

export interface Shape {
  kind: "disc" | "rectangle" | "line" | "girth";
  radius?: number;
  across?: number;
  along?: number;
  length?: number;
}

export interface Place {
  name: string;
  panel: string;
  at: [number, number];
  region: string;
  address: string | null;
  angle: number;
  shape: Shape;
}

export interface Site extends Place {
  values: Record<string, [number, number]>;
}

/** A stretch sensor or a lead: triangle, then two weights where it enters and two where it leaves. */
export interface Line {
  name: string;
  pieces: [number, number, number, number, number][];
}

export interface RankedPlace extends Place {
  rank: string | null;
  mark: number; // of its row in the table
  score: number | null;
  passes: boolean;
  reason: string;
  tolerance: { along: number; around: number; direction: [number, number] } | null;
}

export interface Ranking {
  title: string;
  seam_clearance: number;
  edge_clearance: number;
  places: RankedPlace[];
}

export interface Panel {
  name: string;
  id: string;
  edges: { name: string; sewn: boolean; points: [number, number][] }[];
}

export interface CaseJson {
  sealed: boolean;
  scene: {
    garment: {
      name: string;
      vertices: number;
      vertex: Packed;
      panel: Packed;
      uv: Packed;
      triangles: Packed;
      edges: Packed;
      seams: Packed;
      panels: Panel[];
      skin: {
        points: Packed;
        region: Packed;
        regions: string[];
        segment: Packed;
        segments: string[];
        percent: Packed;
      } | null;
    };
    maps: Record<string, MapStyle>;
    order: string[];
    states: StateJson[];
    bodies: { form: SurfaceJson | null; under: SurfaceJson | null }[];
    colours: { sequential: string; diverging: string };
  };
  places: { sites: Site[]; lines: Line[]; ranking: Ranking | null };
}

export interface MapValues {
  title: string; // as this drape has it: its own slip, not the greatest of all
  values: Float32Array; // per garment vertex, NaN where not defined
  min: number;
  median: number;
  max: number;
}

/** One drape: everything per garment vertex. */
export interface State {
  name: string;
  posture: number;
  donning: number;
  holds: boolean;
  body: number;
  positions: Float32Array;
  normals: Float32Array;
  hollow: Float32Array; // 0 on ridges … 1 in folds, for shading
  touching: Uint8Array | null;
  maps: Map<string, MapValues>;
  slip: { from: Float32Array; to: Float32Array } | null;
}

export interface Surface {
  points: Float32Array;
  triangles: Uint32Array;
}

export interface Skin {
  points: Float32Array;
  region: Uint8Array;
  regions: string[];
  segment: Uint8Array;
  segments: string[];
  percent: Float32Array;
}

/** A case, unpacked. `corner`: a vertex on one piece of the flat pattern; triangles are of corners. */
export interface Case {
  json: CaseJson;
  vertices: number;
  cornerVertex: Uint32Array;
  cornerPanel: Uint32Array;
  cornerUv: Float32Array; // metres: weft, warp
  triangles: Uint32Array;
  edges: Uint32Array;
  seams: Uint32Array;
  panels: Panel[];
  skin: Skin | null;
  maps: Map<string, MapStyle>;
  order: string[];
  bodies: { form: Surface | null; under: Surface | null }[];
  sites: Site[];
  lines: Line[];
  ranking: Ranking | null;
  colours: { sequential: Uint8Array; diverging: Uint8Array };
  postures: string[];
  donnings: number;
  /** Index of the drape of a posture after a donning, or -1. */
  find(posture: number, donning: number): number;
  state(i: number): State;
}

function bytesOf(base64: string): Uint8Array<ArrayBuffer> {
  const text = atob(base64.trim());
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

async function unzipped(bytes: Uint8Array<ArrayBuffer>): Promise<ArrayBuffer> {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  return await new Response(stream).arrayBuffer();
}

/** As packed_arrays.h has written them: differences to the item before, byte by byte. */
class Block {
  constructor(private readonly block: Uint8Array) {}

  counts(packed: Packed): Uint32Array {
    const { at, count, bytes, size } = packed, { block } = this;
    const out = new Uint32Array(count), mask = bytes === 4 ? 0xffffffff : 2 ** (8 * bytes) - 1;
    for (let i = 0; i < count; ++i) {
      let change = 0;
      for (let plane = bytes - 1; plane >= 0; --plane)
        change = (change << 8) | block[at + plane * count + i];
      out[i] = (change + (i < size ? 0 : out[i - size])) & mask;
    }
    return out;
  }
  bytes(packed: Packed): Uint8Array {
    return Uint8Array.from(this.counts(packed));
  }
  numbers(packed: Packed): Float32Array {
    const raw = this.counts(packed), { size } = packed;
    const low = packed.low ?? [], step = packed.step ?? [];
    const out = new Float32Array(packed.count);
    for (let i = 0; i < out.length; ++i) {
      const k = i % size;
      out[i] = raw[i] === 65535 ? NaN : low[k] + step[k] * raw[i];
    }
    return out;
  }
}

/** Normals of the vertices, each triangle counting by its area, and how deep in a fold each lies. */
function shape(positions: Float32Array, triangles: Uint32Array, vertex: Uint32Array) {
  const n = positions.length / 3;
  const normals = new Float32Array(3 * n), middle = new Float32Array(3 * n);
  const count = new Float32Array(n);
  for (let t = 0; t < triangles.length; t += 3) {
    const a = 3 * vertex[triangles[t]], b = 3 * vertex[triangles[t + 1]];
    const c = 3 * vertex[triangles[t + 2]];
    const ux = positions[b] - positions[a], uy = positions[b + 1] - positions[a + 1];
    const uz = positions[b + 2] - positions[a + 2];
    const vx = positions[c] - positions[a], vy = positions[c + 1] - positions[a + 1];
    const vz = positions[c + 2] - positions[a + 2];
    const x = uy * vz - uz * vy, y = uz * vx - ux * vz, z = ux * vy - uy * vx;
    for (const [p, q, r] of [[a, b, c], [b, c, a], [c, a, b]]) {
      normals[p] += x;
      normals[p + 1] += y;
      normals[p + 2] += z;
      for (let k = 0; k < 3; ++k) middle[p + k] += positions[q + k] + positions[r + k];
      count[p / 3] += 2;
    }
  }
  let edge = 0;
  const hollow = new Float32Array(n);
  for (let v = 0; v < n; ++v) {
    const at = 3 * v, length = Math.hypot(normals[at], normals[at + 1], normals[at + 2]) || 1;
    let along = 0, far = 0;
    for (let k = 0; k < 3; ++k) {
      normals[at + k] /= length;
      const off = count[v] ? middle[at + k] / count[v] - positions[at + k] : 0;
      along += off * normals[at + k];
      far += off * off;
    }
    hollow[v] = along;
    edge += Math.sqrt(far);
  }
  // Smoothed over two rings, in units of a fold of 20 mm across.
  for (let pass = 0; pass < 2; ++pass) {
    const sum = new Float32Array(n), weight = new Float32Array(n);
    for (let t = 0; t < triangles.length; t += 3) {
      const a = vertex[triangles[t]], b = vertex[triangles[t + 1]], c = vertex[triangles[t + 2]];
      const mean = (hollow[a] + hollow[b] + hollow[c]) / 3;
      for (const v of [a, b, c]) {
        sum[v] += mean;
        weight[v] += 1;
      }
    }
    for (let v = 0; v < n; ++v) hollow[v] = weight[v] ? sum[v] / weight[v] : 0;
  }
  let spread = 0;
  for (let v = 0; v < n; ++v) spread += hollow[v] * hollow[v];
  spread = Math.sqrt(spread / n) || 1;
  for (let v = 0; v < n; ++v) hollow[v] = Math.max(-1, Math.min(1, hollow[v] / (3 * spread)));
  return { normals, hollow };
}

export async function readCase(json: CaseJson, arrays: string): Promise<Case> {
  const block = new Block(new Uint8Array(await unzipped(bytesOf(arrays))));
  const { garment, bodies, states, maps, order, colours } = json.scene;
  const cornerVertex = block.counts(garment.vertex), triangles = block.counts(garment.triangles);
  const surface = (s: SurfaceJson | null): Surface | null =>
    s && { points: block.numbers(s.points), triangles: block.counts(s.triangles) };
  const made = new Map<number, State>();
  const makeState = (i: number): State => {
    const s = states[i];
    const positions = block.numbers(s.positions);
    return {
      name: s.name, posture: s.posture, donning: s.donning, holds: s.holds, body: s.body, positions,
      ...shape(positions, triangles, cornerVertex),
      touching: s.touching && block.bytes(s.touching),
      maps: new Map(Object.entries(s.maps).map(([array, m]) =>
        [array, { title: m.title, values: block.numbers(m.values), min: m.min, median: m.median, max: m.max }])),
      slip: s.slip && { from: block.numbers(s.slip.from), to: block.numbers(s.slip.to) },
    };
  };
  return {
    json, vertices: garment.vertices, cornerVertex, triangles,
    cornerPanel: block.counts(garment.panel), cornerUv: block.numbers(garment.uv),
    edges: block.counts(garment.edges), seams: block.counts(garment.seams),
    panels: garment.panels,
    skin: garment.skin && {
      points: block.numbers(garment.skin.points), region: block.bytes(garment.skin.region),
      regions: garment.skin.regions, segment: block.bytes(garment.skin.segment),
      segments: garment.skin.segments, percent: block.numbers(garment.skin.percent),
    },
    maps: new Map(Object.entries(maps)), order,
    bodies: bodies.map((b) => ({ form: surface(b.form), under: surface(b.under) })),
    sites: json.places.sites, lines: json.places.lines ?? [], ranking: json.places.ranking,
    colours: { sequential: bytesOf(colours.sequential), diverging: bytesOf(colours.diverging) },
    postures: states.reduce<string[]>((names, s) => {
      names[s.posture] = s.name;
      return names;
    }, []),
    donnings: 1 + Math.max(...states.map((s) => s.donning)),
    find: (posture, donning) => states.findIndex((s) => s.posture === posture && s.donning === donning),
    state: (i) => {
      let state = made.get(i);
      if (!state) made.set(i, state = makeState(i));
      return state;
    },
  };
}

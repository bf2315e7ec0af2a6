// Which point of a surface lies under a ray, which point of the flat pattern under a place.

/** A point of the garment: triangle (of corners) and weights of its three corners. */
export interface SurfacePoint {
  triangle: number;
  weights: [number, number, number];
}

export interface RayHit extends SurfacePoint {
  distance: number;
}

type Triple = readonly [number, number, number];

/**
 * Nearest triangle along a ray, both sides count (Möller and Trumbore 1997). `vertex`: from
 * corners to points; null: the triangles are of points. Hits nearer than `least` do not count.
 */
export function hitSurface(points: Float32Array, triangles: Uint32Array, vertex: Uint32Array | null,
                           from: Triple, along: Triple, least = 0): RayHit | null {
  const [ox, oy, oz] = from, [dx, dy, dz] = along;
  let best = Infinity, hit = -1, hu = 0, hv = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    let a = triangles[t], b = triangles[t + 1], c = triangles[t + 2];
    if (vertex) {
      a = vertex[a];
      b = vertex[b];
      c = vertex[c];
    }
    a *= 3;
    b *= 3;
    c *= 3;
    const ax = points[a], ay = points[a + 1], az = points[a + 2];
    const ux = points[b] - ax, uy = points[b + 1] - ay, uz = points[b + 2] - az;
    const vx = points[c] - ax, vy = points[c + 1] - ay, vz = points[c + 2] - az;
    const px = dy * vz - dz * vy, py = dz * vx - dx * vz, pz = dx * vy - dy * vx;
    const det = ux * px + uy * py + uz * pz;
    if (det > -1e-18 && det < 1e-18) continue;
    const tx = ox - ax, ty = oy - ay, tz = oz - az;
    const u = (tx * px + ty * py + tz * pz) / det;
    if (u < 0 || u > 1) continue;
    const qx = ty * uz - tz * uy, qy = tz * ux - tx * uz, qz = tx * uy - ty * ux;
    const v = (dx * qx + dy * qy + dz * qz) / det;
    if (v < 0 || u + v > 1) continue;
    const distance = (vx * qx + vy * qy + vz * qz) / det;
    if (distance <= least || distance >= best) continue;
    best = distance;
    hit = t / 3;
    hu = u;
    hv = v;
  }
  return hit < 0 ? null : { triangle: hit, weights: [1 - hu - hv, hu, hv], distance: best };
}

/** The triangle of a panel that holds a place of the flat pattern; `nearest`: or the nearest one. */
export function findInPattern(uv: Float32Array, panelOf: Uint32Array, triangles: Uint32Array,
                              panel: number, u: number, v: number,
                              nearest = false): SurfacePoint | null {
  let best: SurfacePoint | null = null, off = Infinity;
  for (let t = 0; t < triangles.length; t += 3) {
    const a = triangles[t], b = triangles[t + 1], c = triangles[t + 2];
    if (panelOf[a] !== panel) continue;
    const ax = uv[2 * a], ay = uv[2 * a + 1];
    const ux = uv[2 * b] - ax, uy = uv[2 * b + 1] - ay, vx = uv[2 * c] - ax, vy = uv[2 * c + 1] - ay;
    const det = ux * vy - uy * vx;
    if (det === 0) continue;
    const px = u - ax, py = v - ay;
    const wb = (px * vy - py * vx) / det, wc = (ux * py - uy * px) / det, wa = 1 - wb - wc;
    if (wa >= -1e-9 && wb >= -1e-9 && wc >= -1e-9)
      return { triangle: t / 3, weights: [wa, wb, wc] };
    if (!nearest) continue;
    const w = [wa, wb, wc].map((x) => Math.max(0, x)), sum = w[0] + w[1] + w[2];
    const qu = (w[0] * ax + w[1] * uv[2 * b] + w[2] * uv[2 * c]) / sum - u;
    const qv = (w[0] * ay + w[1] * uv[2 * b + 1] + w[2] * uv[2 * c + 1]) / sum - v;
    if (qu * qu + qv * qv < off) {
      off = qu * qu + qv * qv;
      best = { triangle: t / 3, weights: [w[0] / sum, w[1] / sum, w[2] / sum] };
    }
  }
  return best;
}

/** A field of corners or, through `vertex`, of vertices, linear over the triangle. */
export function interpolated(point: SurfacePoint, triangles: Uint32Array,
                             vertex: Uint32Array | null, field: Float32Array,
                             size: number): number[] {
  const out = new Array<number>(size).fill(0);
  for (let k = 0; k < 3; ++k) {
    const corner = triangles[3 * point.triangle + k];
    const at = size * (vertex ? vertex[corner] : corner);
    for (let i = 0; i < size; ++i) out[i] += point.weights[k] * field[at + i];
  }
  return out;
}

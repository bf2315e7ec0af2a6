// The flat pieces with the same map, seen from the outside of the cloth, warp upwards.
import { BufferAttribute, BufferGeometry, LinearSRGBColorSpace, Mesh, OrthographicCamera, Scene,
         ShaderMaterial, WebGLRenderer } from "three";
import type { Case, Place, RankedPlace, Ranking } from "./case_data";
import { kCloth, MapAttributes, surfaceMaterial } from "./map_material";
import { drawLine, type LineMark } from "./lines";
import { drawCross, drawMark, type Ink, type Mark } from "./marks";
import { findInPattern, interpolated, type SurfacePoint } from "./picking";

interface Laid {
  low: [number, number]; // extent of the piece in its own coordinates [m]
  high: [number, number];
  x: number; // of its upper left corner on the sheet [m], y down
  y: number;
}

const kGap = 0.05; // between pieces [m]
const kTitle = 0.035; // above each piece for its name [m]

export class PatternView {
  readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new OrthographicCamera();
  private readonly geometry = new BufferGeometry();
  private readonly cloth: ShaderMaterial;
  private laid: Laid[] = [];
  private sheet: [number, number] = [1, 1];
  private scale = 1; // CSS pixels per metre
  private offset: [number, number] = [0, 0]; // CSS pixels
  private zoomed = false;
  private marks: Mark[] = [];
  lines: LineMark[] = [];
  private probe: SurfacePoint | null = null;
  private frame = 0;
  showPlaces = true;

  constructor(private readonly data: Case, private readonly canvas: HTMLCanvasElement,
              private readonly overlay: HTMLCanvasElement, attributes: MapAttributes,
              private readonly ink: () => Ink) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true,
                                        preserveDrawingBuffer: true });
    this.renderer.outputColorSpace = LinearSRGBColorSpace;
    this.renderer.setClearAlpha(0);
    const corners = data.cornerVertex.length;
    this.geometry.setAttribute("position", new BufferAttribute(new Float32Array(3 * corners), 3));
    const normals = new Float32Array(3 * corners);
    for (let i = 0; i < corners; ++i) normals[3 * i + 2] = 1;
    this.geometry.setAttribute("normal", new BufferAttribute(normals, 3));
    this.geometry.setIndex(new BufferAttribute(data.triangles, 1));
    attributes.addTo(this.geometry);
    this.cloth = surfaceMaterial(kCloth, false);
    const mesh = new Mesh(this.geometry, this.cloth);
    mesh.frustumCulled = false;
    this.scene.add(mesh);
    this.camera.near = -1;
    this.camera.far = 1;
    this.listen();
  }

  private extents(): void {
    const { cornerUv, cornerPanel, panels } = this.data;
    this.laid = panels.map(() => ({ low: [Infinity, Infinity], high: [-Infinity, -Infinity], x: 0, y: 0 }));
    const extend = (p: Laid, u: number, v: number) => {
      p.low = [Math.min(p.low[0], u), Math.min(p.low[1], v)];
      p.high = [Math.max(p.high[0], u), Math.max(p.high[1], v)];
    };
    for (let i = 0; i < cornerPanel.length; ++i)
      extend(this.laid[cornerPanel[i]], cornerUv[2 * i], cornerUv[2 * i + 1]);
    panels.forEach((panel, i) =>
      panel.edges.forEach((edge) => edge.points.forEach(([u, v]) => extend(this.laid[i], u, v))));
  }

  /**
   * Pieces in rows, the tallest first, with the row length that lets them be drawn largest.
   * `letter`: width of one letter of their names [m].
   */
  private arrange(ratio: number, letter = 0): void {
    this.extents();
    const names = new Map(this.laid.map((p, i) => [p, this.data.panels[i].name]));
    const size = (p: Laid) => [Math.max(p.high[0] - p.low[0], letter * names.get(p)!.length) + kGap,
                               p.high[1] - p.low[1] + kGap + kTitle];
    const order = this.laid.map((_, i) => i).filter((i) => this.laid[i].low[0] <= this.laid[i].high[0]);
    order.sort((a, b) => size(this.laid[b])[1] - size(this.laid[a])[1] || a - b);
    const rows = (limit: number, place: boolean): [number, number] => {
      let x = 0, y = 0, tall = 0, wide = 0;
      for (const i of order) {
        const [w, h] = size(this.laid[i]);
        if (x > 0 && x + w > limit) {
          y += tall;
          x = tall = 0;
        }
        if (place) {
          this.laid[i].x = x + (w - (this.laid[i].high[0] - this.laid[i].low[0])) / 2;
          this.laid[i].y = y + kTitle + kGap / 2;
        }
        x += w;
        tall = Math.max(tall, h);
        wide = Math.max(wide, x);
      }
      return [wide, y + tall];
    };
    const total = order.reduce((sum, i) => sum + size(this.laid[i])[0], 0);
    const widest = Math.max(...order.map((i) => size(this.laid[i])[0]));
    let best = total, need = Infinity;
    for (let k = 0; k <= 60; ++k) {
      const limit = widest + (total - widest) * k / 60 + 1e-9;
      const [w, h] = rows(limit, false);
      if (Math.max(w / ratio, h) < need - 1e-9) {
        need = Math.max(w / ratio, h);
        best = limit;
      }
    }
    this.sheet = rows(best, true);
    const position = this.geometry.getAttribute("position") as BufferAttribute;
    for (let i = 0; i < this.data.cornerPanel.length; ++i) {
      const [x, y] = this.onSheet(this.data.cornerPanel[i], this.data.cornerUv[2 * i], this.data.cornerUv[2 * i + 1]);
      position.setXYZ(i, x, -y, 0);
    }
    position.needsUpdate = true;
  }

  private onSheet(panel: number, u: number, v: number): [number, number] {
    const p = this.laid[panel];
    return [p.x + u - p.low[0], p.y + p.high[1] - v];
  }

  private toScreen(panel: number, u: number, v: number): [number, number] {
    const [x, y] = this.onSheet(panel, u, v);
    return [this.offset[0] + x * this.scale, this.offset[1] + y * this.scale];
  }

  resize(): void {
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    if (!width || !height) return;
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio || 1));
    this.renderer.setSize(width, height, false);
    const ratio = this.renderer.getPixelRatio();
    this.overlay.width = Math.round(width * ratio);
    this.overlay.height = Math.round(height * ratio);
    this.arrange(width / height);
    this.arrange(width / height, 6.4 * Math.max(this.sheet[0] / width, this.sheet[1] / height));
    this.reset();
  }

  reset(): void {
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    this.scale = Math.min(width / this.sheet[0], height / this.sheet[1]);
    this.offset = [(width - this.sheet[0] * this.scale) / 2, (height - this.sheet[1] * this.scale) / 2];
    this.zoomed = false;
    this.draw();
  }

  zoomAt(x: number, y: number, factor: number): void {
    const whole = Math.min(this.canvas.clientWidth / this.sheet[0], this.canvas.clientHeight / this.sheet[1]);
    const next = Math.max(whole, Math.min(40 * whole, this.scale * factor));
    if (next <= whole * 1.0001) {
      this.reset();
      return;
    }
    const share = next / this.scale;
    this.offset = [x - (x - this.offset[0]) * share, y - (y - this.offset[1]) * share];
    this.scale = next;
    this.zoomed = true;
    this.draw();
  }

  private listen(): void {
    this.canvas.addEventListener("wheel", (event) => {
      if (!(event.ctrlKey || event.metaKey || document.activeElement === this.canvas)) return;
      event.preventDefault();
      this.zoomAt(event.offsetX, event.offsetY, Math.exp(-event.deltaY * (event.ctrlKey ? 0.01 : 0.002)));
    }, { passive: false });
    let from: [number, number] | null = null;
    this.canvas.addEventListener("pointerdown", (event) => {
      if (!this.zoomed) return;
      from = [event.clientX, event.clientY];
      this.canvas.setPointerCapture(event.pointerId);
    });
    this.canvas.addEventListener("pointermove", (event) => {
      if (!from || !(event.buttons & 1)) return;
      this.offset = [this.offset[0] + event.clientX - from[0], this.offset[1] + event.clientY - from[1]];
      from = [event.clientX, event.clientY];
      this.draw();
    });
    this.canvas.addEventListener("pointerup", () => { from = null; });
    this.canvas.addEventListener("dblclick", () => this.reset());
  }

  setLook(mapped: boolean, table: unknown, contours: number, middle: boolean, contact: boolean): void {
    this.cloth.uniforms.mapped.value = mapped ? 1 : 0;
    this.cloth.uniforms.table.value = table;
    this.cloth.uniforms.contours.value = contours;
    this.cloth.uniforms.middle.value = middle ? 1 : 0;
    this.cloth.uniforms.contact.value = contact ? 1 : 0;
    this.draw();
  }

  setMarks(marks: Mark[]): void {
    this.marks = marks;
    this.draw();
  }

  nameMarkAt(x: number, y: number): void {
    for (const mark of this.marks) {
      const [mx, my] = this.screenOf(mark.point);
      mark.near = Math.hypot(mx - x, my - y) < 9;
    }
  }

  setProbe(probe: SurfacePoint | null): void {
    this.probe = probe;
    this.drawOverlay();
  }

  placeOf(point: SurfacePoint): { panel: number; u: number; v: number } {
    const [u, v] = interpolated(point, this.data.triangles, null, this.data.cornerUv, 2);
    return { panel: this.data.cornerPanel[this.data.triangles[3 * point.triangle]], u, v };
  }

  find(panel: number, u: number, v: number, nearest = false): SurfacePoint | null {
    return findInPattern(this.data.cornerUv, this.data.cornerPanel, this.data.triangles, panel, u, v, nearest);
  }

  findPlace(place: Place): SurfacePoint | null {
    const panel = this.data.panels.findIndex((p) => p.id === place.panel);
    return panel < 0 ? null : this.find(panel, place.at[0], place.at[1], true);
  }

  pick(x: number, y: number): SurfacePoint | null {
    const sx = (x - this.offset[0]) / this.scale, sy = (y - this.offset[1]) / this.scale;
    for (let i = 0; i < this.laid.length; ++i) {
      const p = this.laid[i];
      const u = sx - p.x + p.low[0], v = p.high[1] - (sy - p.y);
      if (u < p.low[0] || u > p.high[0] || v < p.low[1] || v > p.high[1]) continue;
      const found = this.find(i, u, v);
      if (found) return found;
    }
    return null;
  }

  screenOf(point: SurfacePoint): [number, number] {
    const { panel, u, v } = this.placeOf(point);
    return this.toScreen(panel, u, v);
  }

  draw(): void {
    if (this.frame) return;
    this.frame = requestAnimationFrame(() => {
      this.frame = 0;
      this.render();
    });
  }

  render(): void {
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    this.camera.left = -this.offset[0] / this.scale;
    this.camera.right = (width - this.offset[0]) / this.scale;
    this.camera.top = this.offset[1] / this.scale;
    this.camera.bottom = -(height - this.offset[1]) / this.scale;
    this.camera.updateProjectionMatrix();
    this.renderer.render(this.scene, this.camera);
    this.drawOverlay();
  }

  drawOverlay(): void {
    const context = this.overlay.getContext("2d")!;
    const ratio = this.renderer.getPixelRatio(), ink = this.ink();
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, this.overlay.width, this.overlay.height);
    const ranking = this.showPlaces ? this.data.ranking : null;
    this.data.panels.forEach((_, i) => this.drawPiece(context, i, ranking, ink));
    if (ranking) for (const place of ranking.places) this.drawPlace(context, place, ink);
    if (this.showPlaces)
      for (const line of this.lines) drawLine(context, line, (p) => this.screenOf(p), () => true, ink);
    if (this.showPlaces)
      for (const mark of this.marks) drawMark(context, this.screenOf(mark.point), mark, ink, true);
    if (this.probe && !this.marks.some((m) => m.chosen && m.point === this.probe)) drawCross(context, this.screenOf(this.probe), ink);
  }

  private outline(context: CanvasRenderingContext2D, panel: number): Path2D {
    const path = new Path2D();
    let first = true;
    for (const edge of this.data.panels[panel].edges)
      for (const [u, v] of edge.points) {
        const [x, y] = this.toScreen(panel, u, v);
        if (first) path.moveTo(x, y);
        else path.lineTo(x, y);
        first = false;
      }
    path.closePath();
    context.lineJoin = "round";
    return path;
  }

  private drawPiece(context: CanvasRenderingContext2D, panel: number, ranking: Ranking | null, ink: Ink): void {
    const piece = this.data.panels[panel];
    const outline = this.outline(context, panel);
    if (ranking) { // where no sensor was looked for
      context.save();
      context.clip(outline);
      for (const edge of piece.edges) {
        const clearance = edge.sewn ? ranking.seam_clearance : ranking.edge_clearance;
        context.lineWidth = 2 * clearance * this.scale;
        context.strokeStyle = "rgba(255,255,255,0.38)";
        context.beginPath();
        edge.points.forEach(([u, v], i) => {
          const [x, y] = this.toScreen(panel, u, v);
          if (i === 0) context.moveTo(x, y);
          else context.lineTo(x, y);
        });
        context.stroke();
      }
      context.restore();
    }
    for (const edge of piece.edges) {
      context.beginPath();
      edge.points.forEach(([u, v], i) => {
        const [x, y] = this.toScreen(panel, u, v);
        if (i === 0) context.moveTo(x, y);
        else context.lineTo(x, y);
      });
      context.strokeStyle = ink.text;
      context.lineWidth = edge.sewn ? 1 : 2.4;
      context.stroke();
    }
    if (!piece.edges.length) return;
    const p = this.laid[panel];
    const [x, y] = this.toScreen(panel, (p.low[0] + p.high[0]) / 2, p.high[1]);
    context.font = "12px system-ui, sans-serif";
    context.textAlign = "center";
    context.textBaseline = "alphabetic";
    context.fillStyle = ink.soft;
    context.fillText(piece.name, x, y - 5);
  }

  /** Outline of the sensor, its axis, and the ellipse in which its centre may lie. */
  private drawPlace(context: CanvasRenderingContext2D, place: RankedPlace, ink: Ink): void {
    const panel = this.data.panels.findIndex((p) => p.id === place.panel);
    if (panel < 0 || place.rank === null) return;
    const [x, y] = this.toScreen(panel, place.at[0], place.at[1]);
    const look = (width: number, colour: string, dash: number[]) => {
      context.lineWidth = width;
      context.strokeStyle = colour;
      context.setLineDash(dash);
      context.stroke();
      context.setLineDash([]);
    };
    context.save();
    context.translate(x, y);
    context.rotate(-place.angle); // counter-clockwise from the warp; y down
    context.beginPath();
    const { shape } = place, s = this.scale;
    if (shape.kind === "disc") context.arc(0, 0, (shape.radius ?? 0) * s, 0, 2 * Math.PI);
    if (shape.kind === "rectangle")
      context.rect(-(shape.across ?? 0) * s / 2, -(shape.along ?? 0) * s / 2, (shape.across ?? 0) * s, (shape.along ?? 0) * s);
    if (shape.kind === "line") {
      context.moveTo(0, -(shape.length ?? 0) * s / 2);
      context.lineTo(0, (shape.length ?? 0) * s / 2);
    }
    look(3.5, ink.paper, []);
    look(1.8, ink.text, []);
    context.restore();
    if (!place.tolerance) return;
    const { along, around, direction } = place.tolerance;
    context.save();
    context.translate(x, y);
    context.rotate(-Math.atan2(direction[1], direction[0]));
    context.beginPath();
    context.ellipse(0, 0, Math.max(along * s, 0.5), Math.max(around * s, 0.5), 0, 0, 2 * Math.PI);
    look(3.5, ink.paper, []);
    look(1.8, ink.text, [5, 4]);
    context.restore();
  }
}

// The garment as worn on its mannequin, with marks drawn over it.
import { BufferAttribute, BufferGeometry, LineBasicMaterial, LineSegments, Mesh,
         OrthographicCamera, Scene, ShaderMaterial, Vector3, WebGLRenderer, LinearSRGBColorSpace,
         BackSide, FrontSide, DoubleSide } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Case, State } from "./case_data";
import { kCloth, kMannequin, kUnder, MapAttributes, setOpacity, surfaceMaterial } from "./map_material";
import { hitSurface, interpolated, type SurfacePoint } from "./picking";
import { drawLine, type LineMark } from "./lines";
import { drawArrow, drawCross, drawMark, type Ink, type Mark } from "./marks";

export type View = "front" | "back" | "left" | "right";
const kDirections: Record<View, [number, number, number]> = {
  front: [0, -1, 0], back: [0, 1, 0], left: [1, 0, 0], right: [-1, 0, 0],
};

export class WornView {
  readonly renderer: WebGLRenderer;
  private readonly scene = new Scene();
  private readonly camera = new OrthographicCamera(-1, 1, 1, -1, 0.01, 20);
  private readonly controls: OrbitControls;
  private readonly geometry = new BufferGeometry();
  private readonly cloth: ShaderMaterial;
  private readonly clothBack: ShaderMaterial;
  private readonly body = surfaceMaterial(kMannequin, true, 4);
  private readonly under = surfaceMaterial(kUnder, true, 2.5);
  private readonly bodyMesh: Mesh;
  private readonly underMesh: Mesh;
  private readonly backMesh: Mesh;
  private readonly edges: LineSegments;
  private readonly seams: LineSegments;
  private readonly lower = new Vector3();
  private readonly upper = new Vector3();
  private state: State;
  private marks: Mark[] = [];
  private hidden = new Set<Mark>();
  lines: LineMark[] = [];
  private hiddenPieces = new Set<object>();
  private probe: SurfacePoint | null = null;
  private skinPoint: number[] | null = null;
  private arrowNormals: Float32Array | null = null;
  private frame = 0;
  private settle = 0;
  private flight = 0;
  showArrows = true;
  showPlaces = true;
  onDrawn: (() => void) | null = null;

  constructor(private readonly data: Case, private readonly canvas: HTMLCanvasElement,
              private readonly overlay: HTMLCanvasElement, attributes: MapAttributes,
              private readonly ink: () => Ink) {
    this.renderer = new WebGLRenderer({ canvas, antialias: true, alpha: true,
                                        preserveDrawingBuffer: true });
    this.renderer.outputColorSpace = LinearSRGBColorSpace; // colours come as the display has them
    this.renderer.setClearAlpha(0);
    this.state = data.state(0);
    const corners = data.cornerVertex.length;
    this.geometry.setAttribute("position", new BufferAttribute(new Float32Array(3 * corners), 3));
    this.geometry.setAttribute("normal", new BufferAttribute(new Float32Array(3 * corners), 3));
    this.geometry.setIndex(new BufferAttribute(data.triangles, 1));
    attributes.addTo(this.geometry);
    this.cloth = surfaceMaterial(kCloth, true);
    this.clothBack = surfaceMaterial(kCloth, true);
    this.clothBack.side = BackSide;
    this.bodyMesh = new Mesh(new BufferGeometry(), this.body);
    this.underMesh = new Mesh(new BufferGeometry(), this.under);
    const clothMesh = new Mesh(this.geometry, this.cloth);
    this.backMesh = new Mesh(this.geometry, this.clothBack);
    this.backMesh.visible = false;
    const lines = (color: number, opacity: number) =>
      new LineSegments(new BufferGeometry(), new LineBasicMaterial({ color, transparent: true, opacity }));
    this.edges = lines(0x161616, 0.95);
    this.seams = lines(0x161616, 0.6);
    this.bodyMesh.renderOrder = 0;
    this.underMesh.renderOrder = 1;
    this.backMesh.renderOrder = 2;
    clothMesh.renderOrder = 3;
    this.edges.renderOrder = this.seams.renderOrder = 4;
    for (const part of [this.bodyMesh, this.underMesh, this.backMesh, clothMesh, this.edges, this.seams]) {
      part.frustumCulled = false;
      this.scene.add(part);
    }
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.zoomToCursor = true;
    this.controls.minZoom = 0.6;
    this.controls.maxZoom = 40;
    this.controls.addEventListener("change", () => this.draw());
    // Scrolling the page over the picture scrolls the page; pinching or Ctrl and wheel zoom.
    canvas.addEventListener("wheel", (event) => {
      this.controls.enableZoom = event.ctrlKey || event.metaKey || document.activeElement === canvas;
    }, { capture: true, passive: true });
    this.setState(this.state);
    this.look("front", false);
  }

  setState(state: State): void {
    this.state = state;
    const { cornerVertex } = this.data;
    const position = this.geometry.getAttribute("position") as BufferAttribute;
    const normal = this.geometry.getAttribute("normal") as BufferAttribute;
    for (let i = 0; i < cornerVertex.length; ++i)
      for (let k = 0; k < 3; ++k) {
        position.array[3 * i + k] = state.positions[3 * cornerVertex[i] + k];
        normal.array[3 * i + k] = state.normals[3 * cornerVertex[i] + k];
      }
    position.needsUpdate = normal.needsUpdate = true;
    const lines = (object: LineSegments, pairs: Uint32Array) => {
      const points = new Float32Array(3 * pairs.length);
      pairs.forEach((v, i) => points.set(state.positions.subarray(3 * v, 3 * v + 3), 3 * i));
      object.geometry.setAttribute("position", new BufferAttribute(points, 3));
    };
    lines(this.edges, this.data.edges);
    lines(this.seams, this.data.seams);
    const body = this.data.bodies[state.body];
    const form = (mesh: Mesh, surface: { points: Float32Array; triangles: Uint32Array } | null) => {
      mesh.visible = surface !== null;
      if (!surface) return;
      const geometry = new BufferGeometry();
      geometry.setAttribute("position", new BufferAttribute(surface.points, 3));
      geometry.setIndex(new BufferAttribute(surface.triangles, 1));
      geometry.computeVertexNormals();
      // Drawn a millimetre inside itself: edges of flat triangles would else peep through cloth that lies on it.
      const inside = surface.points.slice(), n = geometry.getAttribute("normal").array;
      for (let i = 0; i < inside.length; ++i) inside[i] -= 0.001 * n[i];
      geometry.setAttribute("position", new BufferAttribute(inside, 3));
      mesh.geometry.dispose();
      mesh.geometry = geometry;
    };
    form(this.bodyMesh, body.form);
    form(this.underMesh, body.under);
    this.arrowNormals = state.slip && this.normalsAt(state.slip.to);
    this.measure();
    this.draw();
  }

  /** Normal of the vertex that lies nearest to each point. */
  private normalsAt(points: Float32Array): Float32Array {
    const out = new Float32Array(points.length), { positions, normals } = this.state;
    for (let i = 0; i < points.length; i += 3) {
      let best = Infinity, at = 0;
      for (let v = 0; v < positions.length; v += 3) {
        const d = Math.abs(positions[v] - points[i]) + Math.abs(positions[v + 1] - points[i + 1]) +
          Math.abs(positions[v + 2] - points[i + 2]);
        if (d < best) {
          best = d;
          at = v;
        }
      }
      out.set(normals.subarray(at, at + 3), i);
    }
    return out;
  }

  private measure(): void {
    this.lower.set(Infinity, Infinity, Infinity);
    this.upper.set(-Infinity, -Infinity, -Infinity);
    const extend = (points: Float32Array) => {
      for (let i = 0; i < points.length; i += 3) {
        this.lower.set(Math.min(this.lower.x, points[i]), Math.min(this.lower.y, points[i + 1]),
                       Math.min(this.lower.z, points[i + 2]));
        this.upper.set(Math.max(this.upper.x, points[i]), Math.max(this.upper.y, points[i + 1]),
                       Math.max(this.upper.z, points[i + 2]));
      }
    };
    extend(this.state.positions);
    const { form } = this.data.bodies[this.state.body];
    if (form) extend(form.points);
  }

  /** `mapped`: colours by the map; else plain cloth. */
  setLook(mapped: boolean, table: unknown, contours: number, middle: boolean, contact: boolean, clothOpacity: number,
          bodyOpacity: number): void {
    for (const material of [this.cloth, this.clothBack]) {
      material.uniforms.mapped.value = mapped ? 1 : 0;
      material.uniforms.ambient.value = mapped ? 0.5 : 0.3;
      material.uniforms.table.value = table;
      material.uniforms.contours.value = contours;
      material.uniforms.middle.value = middle ? 1 : 0;
      material.uniforms.contact.value = contact ? 1 : 0;
      setOpacity(material, clothOpacity);
    }
    const seen = clothOpacity < 0.999;
    this.backMesh.visible = seen;
    this.cloth.side = seen ? FrontSide : DoubleSide;
    setOpacity(this.body, bodyOpacity);
    setOpacity(this.under, bodyOpacity);
    this.bodyMesh.visible = bodyOpacity > 0.01 && this.data.bodies[this.state.body].form !== null;
    this.underMesh.visible = bodyOpacity > 0.01 && this.data.bodies[this.state.body].under !== null;
    this.draw();
  }

  resize(): void {
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    if (!width || !height) return;
    this.renderer.setPixelRatio(Math.min(2, window.devicePixelRatio || 1));
    this.renderer.setSize(width, height, false);
    const ratio = this.renderer.getPixelRatio();
    this.overlay.width = Math.round(width * ratio);
    this.overlay.height = Math.round(height * ratio);
    this.fit();
    this.draw();
  }

  private fit(): void {
    const width = this.canvas.clientWidth || 1, height = this.canvas.clientHeight || 1;
    const size = this.upper.clone().sub(this.lower);
    const across = Math.max(size.x, size.y);
    const half = 0.5 * 1.08 * Math.max(size.z, across * height / width);
    this.camera.top = half;
    this.camera.bottom = -half;
    this.camera.left = -half * width / height;
    this.camera.right = half * width / height;
    this.camera.updateProjectionMatrix();
  }

  private centre(): Vector3 {
    return this.lower.clone().add(this.upper).multiplyScalar(0.5);
  }

  look(view: View, animate = true): void {
    this.fly(this.centre(), new Vector3(...kDirections[view]), 1, animate);
  }

  /** Turns to a point of the garment so that it is seen from outside. */
  flyTo(point: SurfacePoint, animate = true): void {
    const at = new Vector3(...(this.positionOf(point) as [number, number, number]));
    const n = interpolated(point, this.data.triangles, this.data.cornerVertex, this.state.normals, 3);
    const direction = new Vector3(n[0], n[1], 0.35 * n[2]);
    if (direction.length() < 0.2) direction.set(0, -1, 0);
    this.fly(at, direction.normalize(), Math.max(2.2, this.camera.zoom), animate);
  }

  private fly(target: Vector3, direction: Vector3, zoom: number, animate: boolean): void {
    cancelAnimationFrame(this.flight);
    const distance = 4;
    const from = { target: this.controls.target.clone(), zoom: this.camera.zoom,
                   offset: this.camera.position.clone().sub(this.controls.target) };
    const angle = (v: Vector3) => Math.atan2(v.y, v.x);
    const start = from.offset.lengthSq() > 0 ? angle(from.offset) : angle(direction);
    let turn = angle(direction) - start;
    if (turn > Math.PI) turn -= 2 * Math.PI;
    if (turn < -Math.PI) turn += 2 * Math.PI;
    const rise0 = from.offset.lengthSq() > 0 ? Math.asin(from.offset.z / from.offset.length()) : 0;
    const rise1 = Math.asin(direction.z / direction.length());
    const step = (share: number) => {
      const s = share * share * (3 - 2 * share);
      const a = start + s * turn, r = rise0 + s * (rise1 - rise0);
      this.controls.target.copy(from.target).lerp(target, s);
      this.camera.position.set(Math.cos(r) * Math.cos(a), Math.cos(r) * Math.sin(a), Math.sin(r))
        .multiplyScalar(distance).add(this.controls.target);
      this.camera.zoom = from.zoom + s * (zoom - from.zoom);
      this.camera.updateProjectionMatrix();
      this.controls.update();
      this.draw();
    };
    const calm = window.matchMedia("(prefers-reduced-motion: reduce)").matches;
    if (!animate || calm) {
      step(1);
      return;
    }
    const begun = performance.now();
    const tick = () => {
      const share = Math.min(1, (performance.now() - begun) / 450);
      step(share);
      if (share < 1) this.flight = requestAnimationFrame(tick);
    };
    tick();
  }

  turn(right: number, up: number): void {
    const offset = this.camera.position.clone().sub(this.controls.target);
    const r = offset.length();
    const a = Math.atan2(offset.y, offset.x) + right;
    const rise = Math.max(-1.4, Math.min(1.4, Math.asin(offset.z / r) + up));
    this.camera.position.set(Math.cos(rise) * Math.cos(a), Math.cos(rise) * Math.sin(a), Math.sin(rise))
      .multiplyScalar(r).add(this.controls.target);
    this.controls.update();
    this.draw();
  }

  zoom(factor: number): void {
    this.camera.zoom = Math.max(0.6, Math.min(40, this.camera.zoom * factor));
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  setMarks(marks: Mark[]): void {
    this.marks = marks;
    this.draw();
  }

  /** Shows the name of the mark at a place of the canvas. */
  nameMarkAt(x: number, y: number): void {
    for (const mark of this.marks) {
      const [mx, my] = this.project(this.positionOf(mark.point));
      mark.near = Math.hypot(mx - x, my - y) < 9 && !this.hidden.has(mark);
    }
  }

  setProbe(probe: SurfacePoint | null, skin: number[] | null): void {
    this.probe = probe;
    this.skinPoint = skin;
    this.drawOverlay();
  }

  positionOf(point: SurfacePoint): number[] {
    return interpolated(point, this.data.triangles, this.data.cornerVertex, this.state.positions, 3);
  }

  /** The ray through a place of the canvas, in CSS pixels. */
  private ray(x: number, y: number): { from: Vector3; along: Vector3 } {
    const w = this.canvas.clientWidth, h = this.canvas.clientHeight;
    const from = new Vector3(2 * x / w - 1, 1 - 2 * y / h, -1).unproject(this.camera);
    const along = new Vector3(0, 0, -1).transformDirection(this.camera.matrixWorld);
    from.addScaledVector(along, -1);
    return { from, along };
  }

  /** The point of the cloth that is seen at a place of the canvas. */
  pick(x: number, y: number): SurfacePoint | null {
    this.camera.updateMatrixWorld();
    const { from, along } = this.ray(x, y);
    const o = from.toArray() as [number, number, number], d = along.toArray() as [number, number, number];
    const cloth = hitSurface(this.state.positions, this.data.triangles, this.data.cornerVertex, o, d);
    if (!cloth) return null;
    if (this.bodyMesh.visible && this.body.uniforms.opacity.value > 0.9) {
      const form = this.data.bodies[this.state.body].form;
      const skin = form && hitSurface(form.points, form.triangles, null, o, d);
      // Flat triangles may lie a little inside each other.
      if (skin && skin.distance < cloth.distance - 0.004) return null;
    }
    return { triangle: cloth.triangle, weights: cloth.weights };
  }

  /** Where a point of space appears, in CSS pixels. */
  project(point: ArrayLike<number>): [number, number] {
    const p = new Vector3(point[0], point[1], point[2]).project(this.camera);
    return [(p.x + 1) * 0.5 * this.canvas.clientWidth, (1 - p.y) * 0.5 * this.canvas.clientHeight];
  }

  draw(): void {
    if (this.frame) return;
    this.frame = requestAnimationFrame(() => {
      this.frame = 0;
      this.render();
    });
  }

  render(): void {
    this.renderer.render(this.scene, this.camera);
    this.drawOverlay();
    window.clearTimeout(this.settle);
    this.settle = window.setTimeout(() => this.hide(), 120);
    this.onDrawn?.();
  }

  /** Marks behind cloth or body, found once the picture stands still. */
  private hide(): void {
    this.camera.updateMatrixWorld();
    const along = new Vector3(0, 0, 1).transformDirection(this.camera.matrixWorld);
    const d = along.toArray() as [number, number, number];
    const form = this.data.bodies[this.state.body].form;
    const covered = (point: SurfacePoint) => {
      const o = this.positionOf(point) as [number, number, number];
      return hitSurface(this.state.positions, this.data.triangles, this.data.cornerVertex, o, d, 0.012) ||
             (form && hitSurface(form.points, form.triangles, null, o, d, 0.012));
    };
    this.hidden = new Set(this.marks.filter((mark) => covered(mark.point)));
    this.hiddenPieces = new Set(this.lines.flatMap((line) => line.pieces).filter(
      (piece) => this.facesEye(piece.middle, along) && covered(piece.middle)));
    this.drawOverlay();
  }

  private facesEye(point: SurfacePoint, toEye: Vector3): boolean {
    const n = interpolated(point, this.data.triangles, this.data.cornerVertex, this.state.normals, 3);
    return n[0] * toEye.x + n[1] * toEye.y + n[2] * toEye.z > 0;
  }

  drawOverlay(): void {
    const context = this.overlay.getContext("2d")!;
    const ratio = this.renderer.getPixelRatio(), ink = this.ink();
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, this.overlay.width, this.overlay.height);
    this.camera.updateMatrixWorld();
    const toEye = new Vector3(0, 0, 1).transformDirection(this.camera.matrixWorld);
    const facing = (n: ArrayLike<number>, i = 0) =>
      n[i] * toEye.x + n[i + 1] * toEye.y + n[i + 2] * toEye.z;
    const { slip } = this.state;
    if (this.showArrows && slip && this.arrowNormals)
      for (let i = 0; i < slip.to.length; i += 3)
        if (facing(this.arrowNormals, i) > 0.15)
          drawArrow(context, this.project(slip.from.subarray(i, i + 3)),
                    this.project(slip.to.subarray(i, i + 3)), ink);
    if (this.showPlaces)
      for (const line of this.lines)
        drawLine(context, line, (p) => this.project(this.positionOf(p)),
                 (i) => this.facesEye(line.pieces[i].middle, toEye) && !this.hiddenPieces.has(line.pieces[i]), ink);
    if (this.showPlaces)
      for (const mark of this.marks) {
        const n = interpolated(mark.point, this.data.triangles, this.data.cornerVertex, this.state.normals, 3);
        const seen = facing(n) > 0 && !this.hidden.has(mark);
        if (seen || mark.chosen) drawMark(context, this.project(this.positionOf(mark.point)), mark, ink, seen);
      }
    if (!this.probe) return;
    const at = this.project(this.positionOf(this.probe));
    if (this.skinPoint) {
      const skin = this.project(this.skinPoint);
      context.lineWidth = 1.5;
      context.strokeStyle = ink.accent;
      context.beginPath();
      context.moveTo(...at);
      context.lineTo(...skin);
      context.stroke();
    }
    if (!this.marks.some((m) => m.chosen && m.point === this.probe)) drawCross(context, at, ink);
  }
}

// Pointer and keys on the two views.
import type { PatternView } from "./pattern_view";
import type { SurfacePoint } from "./picking";
import type { WornView } from "./worn_view";

/** What they ask for. */
export interface GestureActions {
  hover(point: SurfacePoint | null): void;
  pin(point: SurfacePoint | null): void;
  /** Moves the pinned point in the flat pattern [m]. */
  step(du: number, dv: number): void;
  /** Turns the 3-D view to the pinned point. */
  flyToPinned(): void;
}

const kStill = 4; // pixels a pointer may move in a click

type Keys = Record<string, () => void>;

function onKeys(canvas: HTMLCanvasElement, keys: (event: KeyboardEvent) => Keys): void {
  canvas.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const act = keys(event), found = act[event.key] ?? act[event.key.toLowerCase()];
    if (!found) return;
    event.preventDefault();
    found();
  });
}

function onPointer(canvas: HTMLCanvasElement, view: WornView | PatternView, act: GestureActions): void {
  let pending = 0, at: [number, number] = [0, 0], down: [number, number] | null = null;
  canvas.addEventListener("pointermove", (event) => {
    at = [event.offsetX, event.offsetY];
    if (event.buttons || pending) return;
    pending = requestAnimationFrame(() => {
      pending = 0;
      view.nameMarkAt(at[0], at[1]);
      act.hover(view.pick(at[0], at[1]));
    });
  });
  canvas.addEventListener("pointerleave", () => {
    view.nameMarkAt(-99, -99);
    act.hover(null);
  });
  canvas.addEventListener("pointerdown", (event) => { down = [event.offsetX, event.offsetY]; });
  canvas.addEventListener("pointerup", (event) => {
    if (!down || Math.hypot(event.offsetX - down[0], event.offsetY - down[1]) > kStill) return;
    const point = view.pick(event.offsetX, event.offsetY);
    if (point) act.pin(point);
  });
}

export function listenToWorn(canvas: HTMLCanvasElement, view: WornView, act: GestureActions): void {
  onPointer(canvas, view, act);
  onKeys(canvas, () => ({
    ArrowLeft: () => view.turn(-0.15, 0), ArrowRight: () => view.turn(0.15, 0),
    ArrowUp: () => view.turn(0, 0.15), ArrowDown: () => view.turn(0, -0.15),
    "+": () => view.zoom(1.25), "=": () => view.zoom(1.25), "-": () => view.zoom(0.8),
    f: () => view.look("front"), b: () => view.look("back"),
    l: () => view.look("left"), r: () => view.look("right"),
    Enter: () => {
      const point = view.pick(canvas.clientWidth / 2, canvas.clientHeight / 2);
      if (point) act.pin(point);
    },
    Escape: () => act.pin(null),
  }));
}

export function listenToPattern(canvas: HTMLCanvasElement, view: PatternView, act: GestureActions): void {
  onPointer(canvas, view, act);
  const middle = (): [number, number] => [canvas.clientWidth / 2, canvas.clientHeight / 2];
  onKeys(canvas, (event) => {
    const step = event.shiftKey ? 0.02 : 0.005;
    return {
      ArrowLeft: () => act.step(-step, 0), ArrowRight: () => act.step(step, 0),
      ArrowUp: () => act.step(0, step), ArrowDown: () => act.step(0, -step),
      "+": () => view.zoomAt(...middle(), 1.25), "=": () => view.zoomAt(...middle(), 1.25),
      "-": () => view.zoomAt(...middle(), 0.8), "0": () => view.reset(),
      Enter: () => act.flyToPinned(),
      Escape: () => act.pin(null),
    };
  });
}

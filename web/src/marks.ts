// Marks that are drawn over both views. They differ by shape and number, not by colour alone.
import type { SurfacePoint } from "./picking";

export interface Ink {
  text: string;
  paper: string;
  soft: string;
  accent: string;
  dark: boolean;
}

export interface Mark {
  point: SurfacePoint;
  label: string; // a rank, or empty
  name: string;
  passes: boolean | null; // null: a site that is not ranked
  chosen: boolean;
  near: boolean; // the pointer is at it
}

type Context = CanvasRenderingContext2D;
type Spot = [number, number];

/** A numbered disc (passes), a numbered square (does not), a small ring (a site). */
export function drawMark(c: Context, [x, y]: Spot, mark: Mark, ink: Ink, seen: boolean): void {
  c.save();
  c.globalAlpha = seen ? 1 : 0.45;
  const r = mark.passes === null ? 4.5 : 9;
  c.beginPath();
  if (mark.passes === false) c.rect(x - r, y - r, 2 * r, 2 * r);
  else c.arc(x, y, r, 0, 2 * Math.PI);
  c.fillStyle = mark.passes === null ? "#ffffff" : mark.passes ? "#0b5fa5" : "#8a4b00";
  c.fill();
  c.lineWidth = mark.chosen ? 3 : 1.5;
  c.strokeStyle = mark.passes === null ? "#10151a" : "#ffffff";
  c.stroke();
  if (mark.chosen) {
    c.beginPath();
    c.arc(x, y, r + 5, 0, 2 * Math.PI);
    c.lineWidth = 2;
    c.strokeStyle = ink.accent;
    c.stroke();
  }
  if (mark.passes !== null) {
    c.fillStyle = "#ffffff";
    c.font = "600 11px system-ui, sans-serif";
    c.textAlign = "center";
    c.textBaseline = "middle";
    c.fillText(mark.label, x, y + 0.5);
  }
  if (mark.chosen || mark.near) drawLabel(c, [x + r + 10, y], mark.name, ink);
  c.restore();
}

export function drawLabel(c: Context, [x, y]: Spot, text: string, ink: Ink): void {
  c.font = "12px system-ui, sans-serif";
  c.textAlign = "left";
  c.textBaseline = "middle";
  const width = c.measureText(text).width;
  c.fillStyle = ink.paper;
  c.globalAlpha = 0.9;
  c.fillRect(x - 4, y - 10, width + 8, 20);
  c.globalAlpha = 1;
  c.fillStyle = ink.text;
  c.fillText(text, x, y);
}

export function drawCross(c: Context, [x, y]: Spot, ink: Ink): void {
  for (const [width, colour] of [[4, ink.paper], [1.8, ink.accent]] as [number, string][]) {
    c.lineWidth = width;
    c.strokeStyle = colour;
    c.beginPath();
    c.arc(x, y, 6, 0, 2 * Math.PI);
    for (const [dx, dy] of [[1, 0], [-1, 0], [0, 1], [0, -1]]) {
      c.moveTo(x + 3 * dx, y + 3 * dy);
      c.lineTo(x + 11 * dx, y + 11 * dy);
    }
    c.stroke();
  }
}

export function drawArrow(c: Context, from: Spot, to: Spot, ink: Ink): void {
  const dx = to[0] - from[0], dy = to[1] - from[1], length = Math.hypot(dx, dy);
  if (length < 2) return;
  const head = Math.min(6, 0.6 * length), ux = dx / length, uy = dy / length;
  for (const [width, colour] of [[3.4, ink.paper], [1.5, ink.accent]] as [number, string][]) {
    c.lineWidth = width;
    c.strokeStyle = colour;
    c.beginPath();
    c.moveTo(...from);
    c.lineTo(...to);
    c.moveTo(to[0] - head * (ux + 0.6 * uy), to[1] - head * (uy - 0.6 * ux));
    c.lineTo(...to);
    c.lineTo(to[0] - head * (ux - 0.6 * uy), to[1] - head * (uy + 0.6 * ux));
    c.stroke();
  }
}

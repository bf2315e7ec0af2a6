// Stretch sensors and leads: lines over the garment, drawn over both views.
import type { Line } from "./case_data";
import { drawLabel, type Ink } from "./marks";
import type { SurfacePoint } from "./picking";

export interface LineMark {
  name: string;
  colour: string;
  pieces: { from: SurfacePoint; to: SurfacePoint; middle: SurfacePoint }[];
  chosen: boolean;
}

// Okabe and Ito (2008), as in pictures and on the pattern (render/line_mark.h).
const kColours = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00"];

export function makeLineMarks(lines: Line[]): LineMark[] {
  const point = (triangle: number, a: number, b: number): SurfacePoint =>
    ({ triangle, weights: [a, b, 1 - a - b] });
  return lines.map((line, i) => ({
    name: line.name,
    colour: kColours[i % kColours.length],
    chosen: false,
    pieces: line.pieces.map(([triangle, a, b, c, d]) => ({
      from: point(triangle, a, b), to: point(triangle, c, d),
      middle: point(triangle, (a + c) / 2, (b + d) / 2),
    })),
  }));
}

type Spot = [number, number];

/** The pieces that `seen` tells of, with a rim in the paper's colour; its name where it begins. */
export function drawLine(c: CanvasRenderingContext2D, line: LineMark, at: (p: SurfacePoint) => Spot,
                         seen: (i: number) => boolean, ink: Ink): void {
  c.save();
  c.lineCap = "round";
  const width = line.chosen ? 4.5 : 2.5;
  for (const [pixels, colour] of [[width + 2.5, ink.paper], [width, line.colour]] as [number, string][]) {
    c.lineWidth = pixels;
    c.strokeStyle = colour;
    c.beginPath();
    line.pieces.forEach((piece, i) => {
      if (!seen(i)) return;
      c.moveTo(...at(piece.from));
      c.lineTo(...at(piece.to));
    });
    c.stroke();
  }
  const first = line.pieces.findIndex((_, i) => seen(i));
  if (first >= 0) {
    const [x, y] = at(line.pieces[first].from);
    c.beginPath();
    c.arc(x, y, width, 0, 2 * Math.PI);
    c.fillStyle = line.colour;
    c.fill();
    if (line.chosen) drawLabel(c, [x + 10, y], line.name, ink);
  }
  c.restore();
}

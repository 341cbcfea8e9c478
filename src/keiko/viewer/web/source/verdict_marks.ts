import { Point } from "./polyline";

/** Colours of verdicts over the picture; those that matter more come later. */
export const verdictColors: Record<string, string> = { none: "#9aa4ad", pass: "#4cd964", undecided: "#ffb300", fail: "#ff4a4a" };

const apart = 16; // px between labels

/** Draws labels on dark ground, but for those that would cover an earlier one. */
export function drawLabels(context: CanvasRenderingContext2D, labels: readonly { text: string; at: Point }[], color: string): void {
  const placed: Point[] = [], high = 8; // px
  Object.assign(context, { font: "bold 12px sans-serif", textAlign: "center", textBaseline: "middle" });
  for (const { text, at } of labels) {
    const [x, y] = at, half = context.measureText(text).width / 2 + 3;
    if (placed.some((other) => Math.hypot(other[0] - x, other[1] - y) < apart)) continue;
    context.fillStyle = "#000c";
    context.fillRect(x - half, y - high, 2 * half, 2 * high);
    context.fillStyle = color;
    context.fillText(text, x, y + 0.5);
    placed.push(at);
  }
}

import { Camera } from "./camera";
import { EyeOverlay } from "./eye_overlay";
import { Point, stroke } from "./polyline";
import { Projection } from "./projection";
import { scaled, sum, Vector } from "./vector";

/** A curve of keiko-combs/1, as far as the page draws it. */
export interface Curve {
  length: number;
  largest_curvature: { value: number };
  pieces: { samples: { place: Vector; curvature: number; towards: Vector }[] }[];
}

/** The longest tooth of a comb, as a share of the body's size. */
const longestTooth = 0.06;

/** Curves of a section with their combs over the picture, and the outline of its plane. */
export class SectionCurves {
  private curves: Curve[] = [];
  private outline: Vector[] = [];
  private readonly overlay: EyeOverlay;

  /** `size`: of the body, mm. */
  constructor(picture: HTMLElement, camera: () => Camera, private readonly size: number) {
    this.overlay = new EyeOverlay("section-lines", picture, camera, (context, eye) => this.draw(context, new Projection(eye)));
  }

  /** Shows curves, none or more, on a plane with an outline of none or more corners. */
  show(curves: Curve[], outline: Vector[]): void {
    this.curves = curves;
    this.outline = outline;
    this.overlay.show(curves.length + outline.length > 0);
  }

  private draw(context: CanvasRenderingContext2D, projection: Projection): void {
    const pixel = (at: Vector): Point | null => projection.set(at) ? [projection.x, projection.y] : null;
    const { outline: [first], outline } = this;
    context.strokeStyle = "#ffd23a", context.setLineDash([6, 5]);
    if (first) stroke(context, [...outline, first].map(pixel));
    context.setLineDash([]);
    this.drawCombs(context, pixel);
  }

  private drawCombs(context: CanvasRenderingContext2D, pixel: (at: Vector) => Point | null): void {
    const tooth = longestTooth * this.size / Math.max(largestCurvature(this.curves), 1e-12);
    for (const { samples } of this.curves.flatMap(({ pieces }) => pieces)) {
      const foot = samples.map((s) => pixel(s.place));
      const tip = samples.map((s) => pixel(sum(s.place, scaled(s.towards, -s.curvature * tooth))));
      context.strokeStyle = "#3ad0ff88";
      foot.forEach((from, i) => stroke(context, [from, tip[i]]));
      stroke(context, tip);
      context.strokeStyle = "#ffd23a";
      stroke(context, foot);
    }
  }
}

const largestCurvature = (curves: Curve[]): number => Math.max(0, ...curves.map((curve) => Math.abs(curve.largest_curvature.value)));

/** One line on the curves of a plane. */
export function summaryOf(curves: Curve[], plane: string): string {
  if (curves.length === 0) return `${plane} misses the body`;
  const long = curves.reduce((all, curve) => all + curve.length, 0);
  return `${plane}: ${long.toFixed(1)} mm, radii from ${(1 / Math.max(largestCurvature(curves), 1e-12)).toPrecision(4)} mm`;
}

import { Camera } from "./camera";
import { EyeOverlay } from "./eye_overlay";
import { stroke } from "./polyline";
import { Projection } from "./projection";
import { Vector } from "./vector";

const arm = 7, gap = 2; // px of a cross

/** The place that was clicked on or flown to as a cross, and the stretch of a seam that it is about as a line. */
export class Marks {
  private place: Vector | null = null;
  private stretch: Vector[][] = [];
  private readonly overlay: EyeOverlay;

  constructor(picture: HTMLElement, camera: () => Camera) {
    this.overlay = new EyeOverlay("marks", picture, camera, (context, eye) => this.draw(context, new Projection(eye)));
  }

  /** Shows a place, and a stretch of which none, one or several pieces are there. */
  show(place: Vector, stretch: Vector[][]): void {
    this.place = place;
    this.stretch = stretch;
    this.overlay.show(true);
  }

  /** Shows another place beside the stretch; null: nothing at all. */
  move(place: Vector | null): void {
    if (place) return this.show(place, this.stretch);
    this.stretch = [];
    this.overlay.show(false);
  }

  private draw(context: CanvasRenderingContext2D, projection: Projection): void {
    const pixel = (at: Vector): [number, number] | null => projection.set(at) ? [projection.x, projection.y] : null;
    const lines = this.stretch.map((piece) => piece.map(pixel)), cross = this.place ? crossAt(pixel(this.place)) : [];
    // Dark below bright: it is seen on stripes of either kind.
    for (const [color, width] of [["#000", 4], ["#ff4fd8", 2]] as const) {
      Object.assign(context, { strokeStyle: color, lineWidth: width });
      for (const line of [...lines, ...cross]) stroke(context, line);
    }
  }
}

function crossAt(pixel: [number, number] | null): [number, number][][] {
  if (!pixel) return [];
  const [x, y] = pixel;
  return [[-arm, -gap], [gap, arm]].flatMap(([from, to]): [number, number][][] => [
    [[x + from, y], [x + to, y]], [[x, y + from], [x, y + to]],
  ]);
}

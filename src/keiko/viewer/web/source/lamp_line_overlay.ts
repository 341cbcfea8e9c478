import { Camera } from "./camera";
import { EyeOverlay } from "./eye_overlay";
import { Crossing, LampLines, verdictsOf } from "./lamp_lines";
import { Point, strokeAll } from "./polyline";
import { Projection } from "./projection";
import { Vector } from "./vector";
import { drawLabels, verdictColors } from "./verdict_marks";

/** What the lines ask of the page. */
export interface LampLinesHost {
  /** The eye that is shown. */
  camera(): Camera;
  /** The faces that are not shown. */
  hidden(): number[];
}

const colors: Record<string, string> = { ...verdictColors, none: "#5cc8ff" };
const numbered = 20; // crossings of the list
const reach = 8;    // px between a click and the crossing that it means

/** Reflection lines of lamps over the picture of the eye that they were found for, and where they break. */
export class LampLineOverlay {
  private found: LampLines = { lines: [], crossings: [] };
  private verdicts: string[] = []; // by line
  private marks: { crossing: Crossing; at: Point }[] = []; // the worst first
  private readonly overlay: EyeOverlay;

  constructor(picture: HTMLElement, private readonly host: LampLinesHost) {
    this.overlay = new EyeOverlay("lamp-lines", picture, () => host.camera(), (context, camera) => this.draw(context, camera));
  }

  /** Shows lines that were found for the eye that is shown; null: none. */
  show(found: LampLines | null): void {
    this.found = found ?? { lines: [], crossings: [] };
    this.verdicts = verdictsOf(this.found);
    this.marks = [];
    this.overlay.show(this.found.lines.length > 0);
  }

  /** The worst crossing at a pixel of the picture; null without one. */
  at(x: number, y: number): Crossing | null {
    return this.marks.find(({ at }) => Math.hypot(at[0] - x, at[1] - y) <= reach)?.crossing ?? null;
  }

  private draw(context: CanvasRenderingContext2D, camera: Camera): void {
    const projection = new Projection(camera), { width, height } = camera, hidden = new Set(this.host.hidden()), { lines, crossings } = this.found;
    const pixel = (place: Vector): Point | null => projection.set(place) ? [projection.x, projection.y] : null;
    for (const [verdict, color] of Object.entries(colors)) {
      const drawn = lines.filter((_, i) => this.verdicts[i] === verdict)
        .flatMap(({ pieces }) => pieces.filter(({ face }) => !hidden.has(face)).map(({ points }) => points.map(pixel)));
      strokeAll(context, drawn, "#000", 3);
      strokeAll(context, drawn, color, 1.5);
    }
    this.marks = crossings.flatMap((crossing) => {
      const at = crossing.verdict ? pixel(crossing.place) : null;
      return at && at[0] >= 0 && at[0] <= width && at[1] >= 0 && at[1] <= height ? [{ crossing, at }] : [];
    });
    for (const mark of [...this.marks].reverse()) drawMark(context, mark.at, mark.crossing.verdict!);
    const labels = this.marks.map(({ crossing, at: [x, y] }) => ({ number: crossings.indexOf(crossing) + 1, crossing, at: [x, y - 14] as Point }));
    drawLabels(context, labels.filter(({ number, crossing }) => crossing.verdict === "fail" && number <= numbered)
      .map(({ number, at }) => ({ text: String(number), at })), colors.fail);
  }
}

/** A disc where a line crosses a seam, larger where it breaks. */
function drawMark(context: CanvasRenderingContext2D, [x, y]: Point, verdict: string): void {
  context.beginPath();
  context.arc(x, y, verdict === "pass" ? 2 : 4, 0, 2 * Math.PI);
  Object.assign(context, { fillStyle: colors[verdict], strokeStyle: "#000", lineWidth: 1.5 });
  context.fill();
  context.stroke();
}

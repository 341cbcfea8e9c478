import { Camera } from "./camera";
import { EyeOverlay } from "./eye_overlay";
import { Point, strokeAll } from "./polyline";
import { Projection } from "./projection";
import { failing, Seam, worstPlace } from "./seam";
import { Sight } from "./sight";
import { Vector } from "./vector";
import { drawLabels, verdictColors } from "./verdict_marks";

/** What the lines ask of the page. */
export interface SeamLinesHost {
  /** The eye that is shown. */
  camera(): Camera;
  /** The faces that are not shown. */
  hidden(): number[];
  /** What the shown picture sees; null without one. */
  sight(): Sight | null;
}

interface DrawnSeam { seam: Seam; lines: (Point | null)[][]; label: { text: string; at: Point } | null }

const reach = 6;  // px between a click and the seam that it means
const step = 4;   // px from one place to the next that is looked at
const order = Object.keys(verdictColors);
const styleOf = (seam: Seam): string => seam.scrap ? "none" : seam.verdict;

/** The visible parts of seams over the picture, coloured by verdict; what fails is named at its worst place. */
export class SeamLines {
  private seams: Seam[] = [];
  private drawn: DrawnSeam[] = [];
  private readonly overlay: EyeOverlay;

  constructor(picture: HTMLElement, private readonly host: SeamLinesHost) {
    this.overlay = new EyeOverlay("seam-lines", picture, () => host.camera(), (context, camera) => this.draw(context, camera));
  }

  /** Shows these seams, none or more. */
  show(seams: Seam[]): void {
    this.seams = seams;
    this.drawn = [];
    this.overlay.show(seams.length > 0);
  }

  /** The picture sees other surfaces than when the seams were drawn. */
  update(): void {
    if (this.seams.length > 0) this.overlay.show(true);
  }

  /** The visible seam at a pixel of the picture, of several that which fails; null without one. */
  at(x: number, y: number): Seam | null {
    const isNear = (point: Point | null): boolean => point !== null && Math.hypot(point[0] - x, point[1] - y) <= reach;
    const near = this.drawn.filter(({ lines, label }) => isNear(label && label.at) || lines.some((line) => line.some(isNear)));
    return near[near.length - 1]?.seam ?? null;
  }

  private draw(context: CanvasRenderingContext2D, camera: Camera): void {
    const sight = this.host.sight(), hidden = new Set(this.host.hidden());
    if (!sight) return;
    const found = new VisibleCurves(camera, sight);
    this.drawn = this.seams.filter(({ face_ids: [a, b] }) => !hidden.has(a) || !hidden.has(b))
      .map((seam) => ({ seam, lines: seam.course.map((piece) => found.curve(piece)), label: labelOf(seam, found) }))
      .sort((a, b) => order.indexOf(styleOf(a.seam)) - order.indexOf(styleOf(b.seam)));
    for (const style of order) {
      const lines = this.drawn.filter(({ seam }) => styleOf(seam) === style).flatMap((seam) => seam.lines);
      strokeAll(context, lines, "#000", 3);
      strokeAll(context, lines, verdictColors[style], 1.5);
    }
    drawLabels(context, this.drawn.flatMap(({ label }) => label ?? []), verdictColors.fail);
  }
}

/** What a seam fails, beside its worst place, if that is visible. */
function labelOf(seam: Seam, found: VisibleCurves): DrawnSeam["label"] {
  const fails = failing(seam), place = fails && found.point(worstPlace(seam)), above = 14; // px
  return place ? { text: fails!.label, at: [place[0], place[1] - above] } : null;
}

/** Curves as pixels of an eye's picture; null where something hides them. */
class VisibleCurves extends Projection {
  constructor(camera: Camera, private readonly sight: Sight) {
    super(camera);
  }

  point(place: Vector): Point | null {
    return this.set(place) && this.sight.sees(place) ? [this.x, this.y] : null;
  }

  curve(places: Vector[]): (Point | null)[] {
    const ends = places.map((place): Point | null => this.set(place) ? [this.x, this.y] : null);
    return places.flatMap((place, i) => i === 0 ? [this.point(place)] : this.chord(places[i - 1], place, ends[i - 1], ends[i]));
  }

  /** The places of a chord but for its first. */
  private chord(a: Vector, b: Vector, from: Point | null, to: Point | null): (Point | null)[] {
    if (!from || !to || this.isBeside(from, to)) return [null];
    const steps = Math.min(Math.max(1, Math.ceil(Math.hypot(to[0] - from[0], to[1] - from[1]) / step)), 1000);
    return Array.from({ length: steps }, (_, k) => {
      const share = (k + 1) / steps;
      return this.point([a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share, a[2] + (b[2] - a[2]) * share]);
    });
  }

  private isBeside(a: Point, b: Point): boolean {
    const { width, height } = this.camera;
    return Math.max(a[0], b[0]) < 0 || Math.min(a[0], b[0]) > width || Math.max(a[1], b[1]) < 0 || Math.min(a[1], b[1]) > height;
  }
}

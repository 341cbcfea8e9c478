import { Camera } from "./camera";
import { EyeOverlay } from "./eye_overlay";
import { Host } from "./host";
import { element } from "./panel";
import { Point, stroke } from "./polyline";
import { Projection } from "./projection";
import { ask } from "./server";
import { difference, length, scaled, sum, Vector } from "./vector";

/** A curve of keiko-combs/1, as far as the page draws it. */
interface Curve {
  length: number;
  largest_curvature: { value: number };
  pieces: { samples: { place: Vector; curvature: number; towards: Vector }[] }[];
}

/** The longest tooth of a comb, as a share of the body's size. */
const longestTooth = 0.06;

/** Draws curves with their combs as an eye sees them. */
function drawCombs(context: CanvasRenderingContext2D, camera: Camera, curves: Curve[], size: number): void {
  const projection = new Projection(camera);
  const place = (at: Vector): Point | null => projection.set(at) ? [projection.x, projection.y] : null;
  const bent = Math.max(...curves.map((curve) => Math.abs(curve.largest_curvature.value)), 1e-12);
  const tooth = longestTooth * size / bent;
  for (const { pieces } of curves)
    for (const { samples } of pieces) {
      const foot = samples.map((s) => place(s.place));
      const tip = samples.map((s) => place(sum(s.place, scaled(s.towards, -s.curvature * tooth))));
      context.strokeStyle = "#3ad0ff88";
      foot.forEach((from, i) => stroke(context, [from, tip[i]]));
      stroke(context, tip);
      context.strokeStyle = "#ffd23a";
      stroke(context, foot);
    }
}

function summary(curves: Curve[], plane: string): string {
  if (curves.length === 0) return `${plane} misses the body`;
  const long = curves.reduce((all, curve) => all + curve.length, 0);
  const bent = Math.max(...curves.map((curve) => Math.abs(curve.largest_curvature.value)));
  return `${plane}: ${long.toFixed(1)} mm, radii from ${(1 / bent).toPrecision(4)} mm`;
}

const axes = ["x", "y", "z"];

/** A plane across an axis, moved by a slider, or one of an analysis; its exact section with the curvature comb. */
export class SectionPanel {
  private readonly choice = element("select", "", { ariaLabel: "axis" }) as HTMLSelectElement;
  private readonly slider = element("input", "", { type: "range", ariaLabel: "position", step: "any", disabled: true }) as HTMLInputElement;
  private readonly text = element("p");
  private readonly overlay: EyeOverlay;
  private curves: Curve[] = [];
  private kept: string[] = []; // planes of an analysis
  private running = new AbortController();

  constructor(into: HTMLElement, private readonly host: Host, picture: HTMLElement) {
    const { lower, upper } = host.facts.bounds, size = length(difference(upper, lower));
    this.overlay = new EyeOverlay("section-lines", picture, () => host.camera(),
      (context, camera) => drawCombs(context, camera, this.curves, size));
    this.choice.onchange = () => this.choose(this.choice.value);
    this.slider.oninput = () => void this.cut();
    into.replaceChildren(this.choice, this.slider, this.text);
    this.offer([]);
  }

  /** The plane that is shown, "y=120", or "". */
  get plane(): string {
    const { value } = this.choice;
    if (value === "none") return "";
    return axes.includes(value) ? `${value}=${Number(this.slider.value).toFixed(2)}` : value;
  }

  /** The plane that is shown, and those of the analysis. */
  get planes(): string[] {
    return [...new Set([this.plane, ...this.kept])].filter((plane) => plane !== "");
  }

  /** Offers the planes of an analysis, and shows the first. */
  take(planes: string[]): void {
    this.offer(planes);
    this.show(planes[0] ?? "");
  }

  /** Shows a plane; "": none. */
  show(plane: string): void {
    const [axis, at] = plane.split("=");
    if (plane && !axes.includes(axis) && !this.kept.includes(plane)) this.offer([...this.kept, plane]);
    if (!axes.includes(axis)) return this.choose(plane || "none");
    this.choose(axis, Number(at));
  }

  private offer(kept: string[]): void {
    this.kept = kept;
    this.choice.replaceChildren(...["none", ...axes, ...kept].map((name) => element("option", name)));
  }

  private choose(name: string, position?: number): void {
    const { lower, upper } = this.host.facts.bounds, at = axes.indexOf(name);
    this.choice.value = name;
    this.slider.disabled = at < 0;
    if (at >= 0) {
      Object.assign(this.slider, { min: String(lower[at]), max: String(upper[at]) });
      this.slider.value = String(position ?? (lower[at] + upper[at]) / 2);
    }
    void this.cut();
  }

  private draw(curves: Curve[], summary: string): void {
    this.curves = curves;
    this.overlay.show(curves.length > 0);
    this.text.textContent = summary;
    this.host.keep();
  }

  private async cut(): Promise<void> {
    this.running.abort();
    const own = this.running = new AbortController(), { plane } = this;
    if (!plane) return this.draw([], "");
    try {
      const { curves } = await (await ask("POST", "/section", plane, own.signal)).json();
      if (!own.signal.aborted) this.draw(curves, summary(curves, plane));
    } catch (error) {
      if (!own.signal.aborted) this.host.fail(error);
    }
  }
}

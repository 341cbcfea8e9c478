import { Camera } from "./camera";
import { Host } from "./host";
import { element } from "./panel";
import { Projection } from "./projection";
import { ask } from "./server";
import { difference, length, scaled, sum, Vector } from "./vector";

/** A curve of keiko-combs/1, as far as the page draws it. */
interface Curve {
  length: number;
  largest_curvature: { value: number };
  pieces: { samples: { place: Vector; curvature: number; towards: Vector }[] }[];
}

type Point = [number, number];

/** The longest tooth of a comb, as a share of the body's size. */
const longestTooth = 0.06;

/** Curves with their combs, drawn over the picture for whichever eye is shown. */
class Overlay {
  private curves: Curve[] = [];
  private drawn: Camera | null = null;
  private readonly canvas = element("canvas", "", { id: "section-lines" }) as HTMLCanvasElement;

  constructor(private readonly host: Host, private readonly picture: HTMLElement) {
    picture.after(this.canvas);
  }

  show(curves: Curve[]): void {
    const isFirst = this.curves.length === 0;
    this.curves = curves;
    this.drawn = null;
    if (isFirst && curves.length > 0) this.follow();
  }

  /** Draws anew whenever the eye has moved, as long as there are curves. */
  private follow(): void {
    const camera = this.host.camera(), { width, height } = this.picture.style;
    Object.assign(this.canvas.style, { width, height });
    if (camera !== this.drawn) this.draw(camera);
    if (this.curves.length > 0) requestAnimationFrame(() => this.follow());
  }

  private draw(camera: Camera): void {
    this.drawn = camera;
    Object.assign(this.canvas, { width: camera.width, height: camera.height });
    const context = this.canvas.getContext("2d")!, projection = new Projection(camera);
    const place = (at: Vector): Point | null => projection.set(at) ? [projection.x, projection.y] : null;
    const { upper, lower } = this.host.facts.bounds;
    const bent = Math.max(...this.curves.map((curve) => Math.abs(curve.largest_curvature.value)), 1e-12);
    const tooth = longestTooth * length(difference(upper, lower)) / bent;
    for (const { pieces } of this.curves)
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
}

function stroke(context: CanvasRenderingContext2D, points: (Point | null)[]): void {
  context.beginPath();
  let isDown = false;
  for (const point of points) {
    if (point && isDown) context.lineTo(...point);
    else if (point) context.moveTo(...point);
    isDown = point !== null;
  }
  context.stroke();
}

function summary(curves: Curve[], plane: string): string {
  if (curves.length === 0) return `${plane} misses the body`;
  const long = curves.reduce((all, curve) => all + curve.length, 0);
  const bent = Math.max(...curves.map((curve) => Math.abs(curve.largest_curvature.value)));
  return `${plane}: ${long.toFixed(1)} mm, radii from ${(1 / bent).toPrecision(4)} mm`;
}

/** A plane across an axis, moved by a slider, and its exact section with the curvature comb. */
export function sectionPanel(into: HTMLElement, host: Host, picture: HTMLElement): void {
  const overlay = new Overlay(host, picture), { lower, upper } = host.facts.bounds;
  const axis = element("select", ["none", "x", "y", "z"].map((name) => element("option", name)), { ariaLabel: "axis" }) as HTMLSelectElement;
  const slider = element("input", "", { type: "range", ariaLabel: "position", step: "any", disabled: true }) as HTMLInputElement;
  const text = element("p");
  let running = new AbortController();
  const cut = async (): Promise<void> => {
    running.abort();
    const own = running = new AbortController(), plane = `${axis.value}=${Number(slider.value).toFixed(2)}`;
    try {
      const { curves } = await (await ask("POST", "/section", plane, own.signal)).json();
      if (own.signal.aborted) return;
      overlay.show(curves);
      text.textContent = summary(curves, plane);
    } catch (error) {
      if (!own.signal.aborted) host.fail(error);
    }
  };
  axis.onchange = () => {
    const at = ["x", "y", "z"].indexOf(axis.value);
    slider.disabled = at < 0;
    running.abort();
    overlay.show([]);
    text.textContent = "";
    if (at < 0) return;
    Object.assign(slider, { min: String(lower[at]), max: String(upper[at]) });
    slider.value = String((lower[at] + upper[at]) / 2);
    void cut();
  };
  slider.oninput = () => void cut();
  into.replaceChildren(axis, slider, text);
}

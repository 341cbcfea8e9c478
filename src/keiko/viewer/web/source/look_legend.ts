import { curvatureColorAt, radiusColorAt } from "./look_colors";
import { element } from "./panel";
import { Display } from "./picture";

const long = 220, high = 10; // px of the bar

/** Both ends of a look's scale in words, and its colours by share of the way between them; null without a scale. */
function scaleOf({ look, kind, fullCurvature, radii }: Display): { ends: [string, string]; colorAt: (share: number) => readonly number[] } | null {
  if (look === "radius") return { ends: [`${radii[0]} mm`, `${radii[1]} mm`], colorAt: radiusColorAt };
  if (look !== "curvature") return null;
  const colorAt = curvatureColorAt(kind), unit = kind === "gauss" ? "/mm²" : "/mm";
  return kind === "absolute" ? { ends: [`0${unit}`, `${fullCurvature} ${unit}`], colorAt }
    : { ends: [`−${fullCurvature} ${unit}`, `${fullCurvature} ${unit}`], colorAt: (share) => colorAt(2 * share - 1) };
}

/** What the colours of the look stand for, as a bar between the ends of its scale. */
export class LookLegend {
  private readonly bar = element("canvas", "", { width: long, height: high }) as HTMLCanvasElement;
  private shown = "";

  constructor(private readonly into: HTMLElement) {}

  /** Shows the scale of a display, if it has one. */
  show(display: Display): void {
    const scale = scaleOf(display), shown = scale ? `${display.look} ${display.kind} ${scale.ends.join()}` : "";
    if (shown === this.shown) return;
    this.shown = shown;
    this.into.replaceChildren(...scale ? [element("span", scale.ends[0]), this.bar, element("span", scale.ends[1])] : []);
    if (scale) this.draw(scale.colorAt);
  }

  private draw(colorAt: (share: number) => readonly number[]): void {
    const context = this.bar.getContext("2d")!;
    for (let x = 0; x < long; ++x) {
      const [r, g, b] = colorAt((x + 0.5) / long).map((share) => Math.round(255 * share));
      context.fillStyle = `rgb(${r}, ${g}, ${b})`;
      context.fillRect(x, 0, 1, high);
    }
  }
}

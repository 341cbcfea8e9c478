import { Host } from "./host";
import { element } from "./panel";
import { axes, facingPlane, heightsOf, middlePlane, outlineOf, planeOf, planeWords, SectionPlane, turnedPlane } from "./section_plane";
import { Curve, SectionCurves, summaryOf } from "./section_curves";
import { ask } from "./server";
import { difference, length } from "./vector";

const free = "free"; // the name of a plane across no axis
const perPixel = 1 / 200; // radians by which a drag turns the plane

/** A plane that is moved by a slider, and turned by numbers or by hand; its exact section with the curvature comb. */
export class SectionPanel {
  private readonly choice = element("select", "", { ariaLabel: "axis" }) as HTMLSelectElement;
  private readonly normal = element("input", "", { ariaLabel: "normal of the section", size: 22 }) as HTMLInputElement;
  private readonly slider = element("input", "", { type: "range", ariaLabel: "position", step: "any" }) as HTMLInputElement;
  private readonly height = element("input", "", { type: "number", ariaLabel: "position in mm", step: "any" }) as HTMLInputElement;
  private readonly turning = element("p", [this.normal]);
  private readonly moving = element("p", [this.slider, this.height]);
  private readonly text = element("p");
  private readonly curves: SectionCurves;
  private words = ""; // of the plane
  private shown: SectionPlane | null = null;
  private kept: string[] = []; // planes of an analysis
  private isCutting = false;

  constructor(into: HTMLElement, private readonly host: Host, picture: HTMLElement) {
    const { bounds: { lower, upper } } = host.facts;
    this.curves = new SectionCurves(picture, () => host.camera(), length(difference(upper, lower)));
    this.choice.onchange = () => this.choose(this.choice.value);
    this.normal.onchange = () => this.face(this.normal.value);
    this.slider.oninput = () => this.move(Number(this.slider.value));
    this.height.onchange = () => this.move(Number(this.height.value));
    into.replaceChildren(this.choice, this.turning, this.moving, this.text,
      element("p", "Ctrl + Shift + drag on the picture turns the plane", { className: "soft" }));
    this.offer([]);
    this.present("none");
  }

  /** The words of the plane that is shown, or "". */
  get plane(): string {
    return this.words;
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

  /** Shows a plane by its words; none for others. */
  show(words: string): void {
    const plane = planeOf(words);
    this.set(plane, plane ? words : "");
  }

  /** Turns the plane about its middle on the body, as a drag by pixels on the picture; without one, a plane across y. */
  turn(x: number, y: number): void {
    this.set(turnedPlane(this.shown ?? this.across("y"), this.host.camera(), x * perPixel, y * perPixel, this.host.facts.bounds));
  }

  private offer(kept: string[]): void {
    this.kept = kept;
    this.choice.replaceChildren(...["none", ...Object.keys(axes), free, ...kept].map((name) => element("option", name)));
  }

  private choose(name: string): void {
    if (name === free) this.set(this.shown ?? this.across("y"), undefined, free);
    else if (axes[name]) this.set(this.across(name));
    else this.show(name);
  }

  /** The plane across an axis through the middle of the body. */
  private across(axis: string): SectionPlane {
    return middlePlane(axis, this.host.facts.bounds);
  }

  private move(height: number): void {
    if (this.shown && Number.isFinite(height)) this.set({ ...this.shown, height });
  }

  /** Turns the plane about its middle on the body to a direction. */
  private face(facing: string): void {
    const faced = this.shown && facingPlane(this.shown, facing.replace(/\s/g, ""), this.host.facts.bounds);
    this.set(faced ?? this.shown, undefined, free);
  }

  private set(plane: SectionPlane | null, words = plane ? planeWords(plane) : "", name = !plane ? "none" : axes[plane.facing] ? plane.facing : free): void {
    this.shown = plane;
    this.words = words;
    this.present(name);
    if (!this.isCutting) void this.cut();
  }

  /** Shows the plane's numbers, and what changes them. */
  private present(name: string): void {
    const { shown } = this;
    this.choice.value = name;
    this.turning.hidden = name !== free;
    this.moving.hidden = shown === null;
    if (!shown) return;
    const [min, max] = heightsOf(this.host.facts.bounds, shown.normal);
    Object.assign(this.slider, { min: String(min), max: String(max) });
    this.slider.value = String(shown.height);
    this.height.value = shown.height.toFixed(2);
    this.normal.value = axes[shown.facing]?.join(",") ?? shown.facing;
  }

  /** Cuts the body by the plane; again and again while that moves on. */
  private async cut(): Promise<void> {
    this.isCutting = true;
    try {
      for (let cut: string | null = null; cut !== this.words;) {
        cut = this.words;
        const curves: Curve[] = cut ? (await (await ask("POST", "/section", cut)).json()).curves : [];
        this.draw(curves, cut);
      }
      this.host.keep(); // browsers allow few changes of the address a second
    } catch (error) {
      this.draw([], "");
      this.host.fail(error);
    }
    this.isCutting = false;
  }

  private draw(curves: Curve[], words: string): void {
    this.curves.show(curves, this.shown ? outlineOf(this.shown, this.host.facts.bounds) : []);
    this.text.textContent = words ? summaryOf(curves, words) : "";
  }
}

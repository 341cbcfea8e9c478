import { Camera } from "./camera";
import { ExactPicture, exposureOf } from "./exact_picture";
import { Facts } from "./facts";
import { Host } from "./host";
import { byId, choice, element } from "./panel";
import { Display, Picture } from "./picture";
import { ask } from "./server";
import { Tracing } from "./tracing";

const ways = ["new", "both", "difference"] as const;
type Way = typeof ways[number];
const slice = 12; // ms of work between two looks at the mouse

/** What a comparison asks of the page. */
export interface CompareHost extends Host {
  /** Something that the pictures depend on has changed. */
  changed(isEye: boolean, isOver: boolean): void;
}

/** The earlier revision under the same eye and lamps, over a part of the picture or subtracted. */
class Earlier {
  private readonly canvas = element("canvas", "", { id: "earlier", hidden: true }) as HTMLCanvasElement;
  private readonly exact: ExactPicture;
  private picture: Picture | null = null;
  private traced: Camera | null = null;
  private drawn = "";
  private tracing: Tracing | null = null;
  way: Way = "new";

  constructor(private readonly host: CompareHost, private readonly over: HTMLElement) {
    const still = element("canvas", "", { id: "earlier-still", hidden: true }) as HTMLCanvasElement;
    this.exact = new ExactPicture(still, "/against/still", (line) => host.tell(line), (error) => host.fail(error));
    byId("still").after(this.canvas, still);
  }

  async show(way: Way): Promise<void> {
    const wasShown = this.way !== "new";
    this.way = way;
    this.canvas.hidden = way === "new";
    for (const shown of this.canvases) shown.style.mixBlendMode = way === "difference" ? "difference" : "normal";
    this.over.parentElement!.classList.toggle("comparing", way !== "new");
    if (way === "new") this.exact.outdate();
    if (wasShown || way === "new") return;
    const facts: Facts = await (await ask("GET", "/against/scene")).json();
    const picture = this.picture ??= new Picture(this.canvas, facts);
    this.tracing ??= new Tracing(facts.reflections, (camera, spent) => picture.bufferFor(camera, spent), (buffer) => {
      picture.show(buffer);
      this.draw(this.host.display());
    }, { path: "/against/deep" });
    this.traced = null;
    this.follow();
  }

  /** Share of the picture, from the left, that shows the new revision. */
  split(share: number): void {
    for (const { style } of this.canvases) style.clipPath = `inset(0 0 0 ${(100 * share).toFixed(2)}%)`;
  }

  private get canvases(): HTMLCanvasElement[] {
    return [this.canvas, this.exact.canvas];
  }

  /** Follows eye, look and lamps as long as it is shown. */
  private follow(): void {
    if (this.way === "new") return;
    const camera = this.host.camera(), { width, height } = this.over.style;
    for (const { style } of this.canvases) Object.assign(style, { width, height });
    const display = this.host.display(), now = JSON.stringify(display), isEye = camera !== this.traced;
    if (isEye) void this.trace(camera);
    if (now !== this.drawn) this.draw(display);
    if (isEye || now !== this.drawn) this.request(camera, display);
    this.drawn = now;
    // Half of an exact picture beside a live one would show differences that are none.
    this.over.parentElement!.classList.toggle("both-exact", !byId("still").hidden && !this.exact.canvas.hidden);
    requestAnimationFrame(() => this.follow());
  }

  /** Takes the exact picture off; another one follows after a while. */
  private request(camera: Camera, { look, planes, white }: Display): void {
    this.exact.outdate();
    if (look === "lamps") this.exact.follow({ camera, planes, hidden: [], ev: exposureOf(white) });
  }

  private draw(display: Display): void {
    this.picture!.draw(display);
  }

  private async trace(camera: Camera): Promise<void> {
    this.traced = camera;
    try {
      if (!await this.tracing!.rest(camera)) return;
      while (camera === this.traced && !this.picture!.refine(this.host.display(), slice))
        await new Promise((resolve) => setTimeout(resolve));
      this.canvas.dataset.traced = "whole";
    } catch (error) {
      this.host.fail(error);
    }
  }
}

/** Buttons that show the earlier revision beside the new one, or the difference, and a slider. */
export class Comparison {
  private readonly earlier: Earlier | null = null;

  constructor(into: HTMLElement, host: CompareHost, over: HTMLElement) {
    into.parentElement!.hidden = !host.facts.against;
    if (!host.facts.against) return;
    const earlier = this.earlier = new Earlier(host, over), buttons = element("p");
    const slider = element("input", "", { type: "range", min: "0", max: "1", step: "any", value: "0.5", ariaLabel: "border between the revisions" }) as HTMLInputElement;
    const show = (way: Way): void => {
      const wasShown = this.isShown;
      slider.disabled = way !== "both";
      earlier.split(way === "both" ? Number(slider.value) : 0);
      earlier.show(way).catch((error) => host.fail(error));
      if (this.isShown !== wasShown) host.changed(false, true);
    };
    slider.oninput = () => earlier.split(Number(slider.value));
    choice(buttons, ways, "new", (name) => show(name as Way));
    slider.disabled = true;
    into.replaceChildren(buttons, slider);
  }

  /** True while the earlier revision is shown. */
  get isShown(): boolean {
    return this.earlier !== null && this.earlier.way !== "new";
  }
}

import { Camera } from "./camera";
import { Facts } from "./facts";
import { Host } from "./host";
import { byId, choice, element } from "./panel";
import { Display, Picture } from "./picture";
import { ask } from "./server";
import { Tracing } from "./tracing";

const ways = ["new", "both", "difference"] as const;
type Way = typeof ways[number];
const slice = 12; // ms of work between two looks at the mouse

/** The earlier revision under the same eye and lamps, over a part of the picture or subtracted. */
class Earlier {
  private readonly canvas = element("canvas", "", { id: "earlier", hidden: true }) as HTMLCanvasElement;
  private picture: Picture | null = null;
  private traced: Camera | null = null;
  private drawn = "";
  private way: Way = "new";
  private tracing: Tracing | null = null;

  constructor(private readonly host: Host, private readonly over: HTMLElement) {
    byId("still").after(this.canvas);
  }

  async show(way: Way): Promise<void> {
    const wasShown = this.way !== "new";
    this.way = way;
    this.canvas.hidden = way === "new";
    this.canvas.style.mixBlendMode = way === "difference" ? "difference" : "normal";
    this.over.parentElement!.classList.toggle("comparing", way !== "new");
    if (wasShown || way === "new") return;
    const facts: Facts = await (await ask("GET", "/against/scene")).json();
    const picture = this.picture ??= new Picture(this.canvas, facts);
    this.tracing ??= new Tracing(facts.reflections, (camera, spent) => picture.bufferFor(camera, spent), (buffer) => {
      picture.show(buffer);
      this.draw(this.host.display());
    }, { path: "/against/deep" });
    this.follow();
  }

  /** Share of the picture, from the left, that shows the new revision. */
  split(share: number): void {
    this.canvas.style.clipPath = `inset(0 0 0 ${(100 * share).toFixed(2)}%)`;
  }

  /** Follows eye, look and lamps as long as it is shown. */
  private follow(): void {
    if (this.way === "new") return;
    const camera = this.host.camera(), { width, height } = this.over.style;
    Object.assign(this.canvas.style, { width, height });
    if (camera !== this.traced) void this.trace(camera);
    const display = this.host.display(), now = JSON.stringify(display);
    if (now !== this.drawn) this.draw(display);
    this.drawn = now;
    requestAnimationFrame(() => this.follow());
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
export function comparePanel(into: HTMLElement, host: Host, over: HTMLElement): void {
  const section = into.parentElement!;
  section.hidden = !host.facts.against;
  if (section.hidden) return;
  const earlier = new Earlier(host, over), buttons = element("p");
  const slider = element("input", "", { type: "range", min: "0", max: "1", step: "any", value: "0.5", ariaLabel: "border between the revisions" }) as HTMLInputElement;
  const show = (way: Way): void => {
    slider.disabled = way !== "both";
    earlier.split(way === "both" ? Number(slider.value) : 0);
    earlier.show(way).catch((error) => host.fail(error));
  };
  slider.oninput = () => earlier.split(Number(slider.value));
  choice(buttons, ways, "new", (name) => show(name as Way));
  slider.disabled = true;
  into.replaceChildren(buttons, slider);
}

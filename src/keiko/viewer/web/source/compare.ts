import { Camera } from "./camera";
import { readPasses } from "./deep_buffer";
import { Facts } from "./facts";
import { Host } from "./host";
import { byId, choice, element } from "./panel";
import { Display, Picture } from "./picture";
import { ask, requestText } from "./server";

const ways = ["new", "both", "difference"] as const;
type Way = typeof ways[number];

/** The earlier revision under the same eye and lamps, over a part of the picture or subtracted. */
class Earlier {
  private readonly canvas = element("canvas", "", { id: "earlier", hidden: true }) as HTMLCanvasElement;
  private picture: Picture | null = null;
  private traced: Camera | null = null;
  private drawn = "";
  private way: Way = "new";
  private running = new AbortController();

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
    this.picture ??= new Picture(this.canvas, facts);
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
    this.running.abort();
    const own = this.running = new AbortController();
    let isFirst = true;
    try {
      const reply = await ask("POST", "/against/deep", requestText(camera), own.signal);
      await readPasses(reply, (pass) => {
        if (own.signal.aborted) return;
        this.picture!.add(pass, camera, isFirst);
        isFirst = false;
        this.draw(this.host.display());
      });
      this.canvas.dataset.traced = "whole";
    } catch (error) {
      if (!own.signal.aborted) this.host.fail(error);
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

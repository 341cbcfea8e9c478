import { Camera } from "./camera";
import { Plane } from "./facts";
import { Host } from "./host";
import { Crossing, failingOf, LampLines, measuresOf } from "./lamp_lines";
import { LampLineOverlay, LampLinesHost } from "./lamp_line_overlay";
import { button, element, longList } from "./panel";
import { ask, requestText } from "./server";
import { Vector } from "./vector";

const atOnce = 20; // entries of the list

/** The reflection lines of the shown lamps for the shown eye: over the picture, and a list of where they break. */
export class LampLinesPanel {
  private isOver = false; // they are drawn over the picture, or will be at rest
  private asked: { camera: Camera; planes: Plane[]; lines: LampLines | null } | null = null; // null: not answered yet
  private running = new AbortController();
  private readonly overlay: LampLineOverlay;
  private readonly toggler = button("over the picture", () => this.toggle());
  private readonly detail = element("div", "", { id: "crossing" });
  private readonly list = element("div");
  private readonly buttons = new Map<Crossing, HTMLElement>();

  constructor(into: HTMLElement, private readonly host: Host & LampLinesHost, picture: HTMLElement) {
    this.overlay = new LampLineOverlay(picture, host);
    into.replaceChildren(element("p", [this.toggler]), this.detail, this.list);
    this.toggler.title = "follows the lines that the lamps' axes make in this view, over seams";
  }

  /** True if they are drawn over the picture, or will be. */
  get shown(): boolean {
    return this.isOver;
  }

  toggle(): void {
    this.isOver = !this.isOver;
    this.host.keep();
    this.settle();
  }

  /** Draws them at rest, or takes them off. */
  show(isOver: boolean): void {
    this.isOver = isOver;
    this.toggler.setAttribute("aria-pressed", String(isOver));
  }

  /** Eye, lamps or faces may be others: lines that are out of date go. */
  outdate(): void {
    if (this.isOver && !this.isCurrent()) this.clear();
  }

  /** Eye and lamps are at rest: the lines follow. */
  settle(): void {
    this.show(this.isOver);
    if (!this.isOver) this.clear();
    else if (!this.isCurrent()) void this.follow();
    else if (this.asked!.lines) this.present(this.asked!.lines);
  }

  /** Chooses the crossing at a pixel of the picture; false without one. */
  pick(x: number, y: number): boolean {
    const crossing = this.isOver ? this.overlay.at(x, y) : null;
    if (crossing) this.choose(crossing);
    return crossing !== null;
  }

  private isCurrent(): boolean {
    return this.asked?.camera === this.host.camera() && this.asked.planes === this.host.display().planes;
  }

  private clear(): void {
    this.running.abort();
    if (!this.asked?.lines) this.asked = null;
    this.overlay.show(null);
    this.detail.replaceChildren();
    this.list.replaceChildren();
  }

  private async follow(): Promise<void> {
    this.clear();
    const own = this.running = new AbortController(), { host } = this, camera = host.camera(), { planes } = host.display();
    this.asked = { camera, planes, lines: null };
    try {
      host.tell("following the lines of the lamps");
      const lines: LampLines = await (await ask("POST", "/lines", requestText(camera, planes), own.signal)).json();
      if (own.signal.aborted) return;
      this.asked = { camera, planes, lines };
      this.present(lines);
    } catch (error) {
      if (own.signal.aborted) return;
      this.asked = null;
      this.show(false);
      host.fail(error);
    }
  }

  private present(found: LampLines): void {
    this.overlay.show(found);
    if (!this.list.hasChildNodes()) this.showList(found);
  }

  private showList({ lines, crossings }: LampLines): void {
    const judged = crossings.filter(({ verdict }) => verdict !== null), faulty = judged.filter(({ verdict }) => verdict !== "pass");
    const words = `${lines.length} lines, ${judged.length} crossings of seams, of which ${faulty.length} do not pass`;
    this.buttons.clear();
    this.list.replaceChildren(element("p", words), longList(element("ol"), faulty, (crossing) => this.entry(crossing), atOnce, (left) => `${left} more`));
    this.host.tell(words);
  }

  private entry(crossing: Crossing): HTMLElement {
    const named = button(crossing.faces, () => this.choose(crossing));
    this.buttons.set(crossing, named);
    return element("li", [named, new Text(failingOf(crossing) ?? crossing.verdict!)], { className: crossing.verdict });
  }

  /** Marks a crossing with its line, and shows what is known of it above the list. */
  private choose(crossing: Crossing): void {
    for (const [other, named] of this.buttons) named.setAttribute("aria-pressed", String(other === crossing));
    const line: Vector[][] = this.asked!.lines!.lines[crossing.line].pieces.map(({ points }) => points);
    this.host.mark(crossing.place, line);
    this.detail.replaceChildren(element("p", crossing.faces),
      ...measuresOf(crossing).map(({ words, verdict }) => element("div", words, { className: verdict })));
    this.detail.scrollIntoView({ block: "nearest" });
  }
}

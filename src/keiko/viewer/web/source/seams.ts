import { Host } from "./host";
import { button, element, longList } from "./panel";
import { Profile, profilePlot } from "./profile_plot";
import { failing, measures, Seam, worstPlace } from "./seam";
import { SeamLines, SeamLinesHost } from "./seam_lines";
import { ask } from "./server";

/** What the seams ask of the page. */
export interface SeamsHost extends Host, SeamLinesHost {}

const order = ["fail", "undecided", "pass"];
const atOnce = 20; // entries of a list in which nothing fails

/** The seams: a list, the worst first; lines over the picture; and the one that is chosen, with its profile. */
export class SeamsPanel {
  private seams: Promise<Seam[]> | null = null; // judged on request, once
  private isOver = false; // they are drawn over the picture, or will be
  private chosen = new AbortController();
  private readonly lines: SeamLines;
  private readonly head = element("p");
  private readonly detail = element("div", "", { id: "seam" });
  private readonly found = element("div");
  private readonly buttons = new Map<Seam, HTMLElement>();

  constructor(into: HTMLElement, private readonly host: SeamsHost, picture: HTMLElement) {
    this.lines = new SeamLines(picture, host);
    into.replaceChildren(this.head, this.detail, this.found);
    this.head.append(button("judge", () => void this.show(true)));
  }

  /** True if they are drawn over the picture. */
  get shown(): boolean {
    return this.isOver;
  }

  /** Draws the seams over the picture, or takes them off; judges them before if nobody has. */
  async show(isOver: boolean): Promise<void> {
    this.isOver = isOver;
    this.host.keep();
    try {
      const seams = isOver ? await (this.seams ??= this.judged()) : [];
      if (isOver !== this.isOver) return;
      this.lines.show(seams);
      this.head.firstElementChild!.setAttribute("aria-pressed", String(isOver));
    } catch (error) {
      this.seams = null;
      this.isOver = false;
      this.host.fail(error);
    }
  }

  toggle(): void {
    void this.show(!this.isOver);
  }

  /** The picture sees other surfaces than when the seams were drawn. */
  update(): void {
    this.lines.update();
  }

  /** Chooses the seam at a pixel of the picture; null without one. */
  pick(x: number, y: number): Seam | null {
    const seam = this.isOver ? this.lines.at(x, y) : null;
    if (seam) this.choose(seam);
    return seam;
  }

  private async judged(): Promise<Seam[]> {
    this.host.tell("judging the seams");
    const { seams }: { seams: Seam[] } = await (await ask("GET", "/seams")).json();
    if (seams.some((seam) => !seam.course)) throw new Error("the report is of an earlier version: its seams have no course");
    const sorted = [...seams].sort((a, b) => order.indexOf(a.verdict) - order.indexOf(b.verdict) || b.severity - a.severity || a.number - b.number);
    this.host.tell(`${seams.length} stretches of seams, the worst first`);
    this.head.replaceChildren(button("over the picture", () => this.toggle()));
    this.found.replaceChildren(seams.length > 0 ? this.list(sorted) : element("p", "no seams"));
    return sorted;
  }

  /** The seams in their order; many that pass on request. */
  private list(seams: Seam[]): HTMLElement {
    const faulty = seams.filter((seam) => seam.verdict !== "pass").length, first = Math.max(faulty, atOnce);
    return longList(element("table"), seams, (seam) => this.entry(seam), first, (left) => `${left} more, which pass`);
  }

  private entry(seam: Seam): HTMLElement {
    const named = button(seam.faces, () => this.flyTo(seam));
    this.buttons.set(seam, named);
    return element("tr", [
      element("td", seam.verdict, { className: seam.verdict }), element("td", failing(seam)?.label ?? seam.kind), element("td", [named]),
    ]);
  }

  private flyTo(seam: Seam): void {
    this.host.flyTo(worstPlace(seam), seam.length);
    this.host.mark(worstPlace(seam), seam.course);
    this.choose(seam);
  }

  /** Shows what is known of a seam above the list. */
  private choose(seam: Seam): void {
    for (const [other, named] of this.buttons) named.setAttribute("aria-pressed", String(other === seam));
    const plot = element("div");
    this.detail.replaceChildren(
      element("p", [button("fly there", () => this.flyTo(seam)), new Text(`${seam.faces}, ${seam.kind}, ${seam.length.toFixed(1)} mm`)]),
      ...measures(seam).map(({ words, verdict }) => element("div", words, { className: verdict })), plot,
    );
    this.detail.scrollIntoView({ block: "nearest" });
    this.chosen.abort();
    this.chosen = new AbortController();
    void this.plot(seam, plot, this.chosen.signal);
  }

  private async plot(seam: Seam, into: HTMLElement, signal: AbortSignal): Promise<void> {
    try {
      const { profiles: [profile] }: { profiles: Profile[] } = await (await ask("POST", "/profile", String(seam.number), signal)).json();
      into.replaceChildren(profilePlot(profile, failing(seam)?.mending ?? "tangent"));
      into.scrollIntoView({ block: "nearest" });
    } catch (error) {
      if (!signal.aborted) into.replaceChildren(element("p", error instanceof Error ? error.message : String(error), { className: "soft" }));
    }
  }
}

import { analysisFile, keptView, KeptView, Note, openAnalysis, OpenedAnalysis, shownView } from "./analysis";
import { Host } from "./host";
import { lookOf } from "./look_words";
import { Notes } from "./notes";
import { button, download, element, pickedText } from "./panel";

/** What the panel of the analysis asks of the page besides. */
export interface AnalysisHost extends Host {
  hidden(): number[];
  sections(): string[];
  /** Shows all that an opened analysis has but its notes and further views. */
  take(analysis: OpenedAnalysis): void;
  /** Notes or kept views have changed. */
  keep(): void;
}

const storedViews = "views"; // of the session: a reload keeps them

/** Kept views and notes; and all that is shown, as a file that runs again on another revision. */
export class AnalysisPanel {
  readonly notes: Notes;
  private views: KeptView[] = JSON.parse(sessionStorage.getItem(storedViews) ?? "[]");
  private readonly list = element("p");
  private readonly remarks = element("div", "", { className: "soft" });

  constructor(into: HTMLElement, private readonly host: AnalysisHost, picture: HTMLElement) {
    const notes = element("div");
    this.notes = new Notes(notes, host, picture, () => host.keep());
    into.replaceChildren(
      element("p", [button("keep this view", () => this.keepView()), button("save analysis", () => void this.save()),
        button("open analysis", () => void this.open())]),
      this.list, this.remarks, element("h3", "Notes"), notes);
    this.notes.show([]);
    this.showViews();
  }

  /** Shows what a file or the server has. */
  take(analysis: OpenedAnalysis): void {
    this.setViews(analysis.views.filter(({ name }) => name !== shownView));
    this.notes.show(analysis.notes);
    this.remarks.replaceChildren(...analysis.remarks.map((remark) => element("div", remark)));
    this.host.take(analysis);
  }

  addNote(note: Note): void {
    this.notes.add(note);
  }

  private keepView(): void {
    const taken = new Set(this.views.map(({ name }) => name));
    let number = 1;
    while (taken.has(`view-${number}`)) ++number;
    this.setViews([...this.views, keptView(`view-${number}`, this.host.camera(), this.host.display())]);
  }

  private setViews(views: KeptView[]): void {
    this.views = views;
    sessionStorage.setItem(storedViews, JSON.stringify(views));
    this.showViews();
  }

  private showViews(): void {
    this.list.replaceChildren(...this.views.flatMap((view) => {
      const remove = button("×", () => this.setViews(this.views.filter((other) => other !== view)));
      remove.title = "forget the view";
      return [button(view.name, () => this.show(view)), remove, new Text(" ")];
    }));
  }

  private show({ camera, look, across }: KeptView): void {
    const stated = lookOf(look, across);
    if (stated) this.host.choose(stated);
    this.host.lookFrom(camera);
    if (!stated) this.host.tell(`this page does not draw ${look}`);
  }

  private async save(): Promise<void> {
    const { host } = this;
    try {
      download("analysis.json", await analysisFile({
        camera: host.camera(), display: host.display(), hidden: host.hidden(), sections: host.sections(), views: this.views,
        notes: this.notes.all,
      }));
      host.tell("analysis.json is in your downloads; keiko view, inspect, render and compare take it with --analysis");
    } catch (error) {
      host.fail(error);
    }
  }

  private async open(): Promise<void> {
    const text = await pickedText(".json");
    try {
      this.take(await openAnalysis(text));
    } catch (error) {
      this.host.fail(error);
    }
  }
}

import { fetchAnalysis, Note, OpenedAnalysis } from "./analysis";
import { AnalysisHost, AnalysisPanel } from "./analysis_panel";
import { Camera, lookingAt, sized } from "./camera";
import { CompareHost, Comparison } from "./compare";
import { Pictured } from "./exact_picture";
import { Facts, Plane } from "./facts";
import { Gizmo } from "./gizmo";
import { listenToKeys } from "./keys";
import { LampLinesPanel } from "./lamp_lines_panel";
import { LampRows, RowsHost } from "./lamp_rows";
import { showLamps } from "./lamps_panel";
import { keepInAddress, stateOfAddress, ViewState } from "./link";
import { LivePicture, PicturedHost } from "./live_picture";
import { LookLegend } from "./look_legend";
import { firstLook, lookOf, StatedLook } from "./look_words";
import { Marks } from "./marks";
import { mouseHelp, MouseStyle, mouseStyles } from "./mouse";
import { namedViews, PageHost, showLooks, showPanel } from "./page_panel";
import { byId } from "./panel";
import { PickHost, PickPanel } from "./pick_panel";
import { Display, Look } from "./picture";
import { Pointer } from "./pointer";
import { copyLink, savePicture } from "./saving";
import { SeamsHost, SeamsPanel } from "./seams";
import { SectionPanel } from "./section";
import { Sight } from "./sight";
import { Tree } from "./tree";
import { difference, length, Vector } from "./vector";

/** The page: one scene, the eye, the lamps and the look, and the parts that show and change them. */
export class Viewer implements PageHost, AnalysisHost, CompareHost, PickHost, PicturedHost, RowsHost, SeamsHost {
  readonly lamps: LampRows;
  private eye: Camera;
  private left: number[] = []; // faces that are not shown
  private stated = firstLook;
  private mouse: MouseStyle;
  private readonly picture: LivePicture;
  private readonly gizmo: Gizmo;
  private readonly section: SectionPanel;
  private readonly places: PickPanel;
  private readonly legend = new LookLegend(byId("legend"));
  private readonly seams: SeamsPanel;
  private readonly lines: LampLinesPanel;
  private readonly comparison: Comparison;
  private readonly tree: Tree;
  private readonly marks: Marks;
  private readonly analysis: AnalysisPanel;

  constructor(readonly facts: Facts) {
    this.eye = facts.camera;
    this.lamps = new LampRows(facts.rig.planes, this);
    this.mouse = mouseStyles.find((style) => style === localStorage.getItem("mouse")) ?? "Keiko";
    this.picture = new LivePicture(facts, this);
    const { canvas } = this.picture;
    this.gizmo = new Gizmo(canvas.parentElement!, (move, amount, isOver) => this.lamps.move(move, amount, isOver));
    this.section = new SectionPanel(byId("section"), this, canvas);
    this.places = new PickPanel(this);
    this.comparison = new Comparison(byId("compare"), this, canvas);
    this.seams = new SeamsPanel(byId("seams"), this, canvas);
    this.lines = new LampLinesPanel(byId("lines"), this, canvas);
    this.tree = new Tree(byId("tree"), this);
    this.marks = new Marks(canvas, () => this.eye);
    this.analysis = new AnalysisPanel(byId("analysis"), this, canvas);
  }

  /** Shows what the address states, or else the analysis that the server was started with, or else its view. */
  async start(): Promise<void> {
    const linked = stateOfAddress(), analysis = await fetchAnalysis(), { canvas } = this.picture;
    if (linked) this.restore(linked);
    else if (analysis) this.analysis.take(analysis);
    this.showLooks();
    showPanel(this);
    new Pointer(canvas, this);
    listenToKeys(canvas, this);
    window.onresize = () => this.picture.fit(this.eye);
    this.picture.fit(this.eye);
    this.changed(true, true);
  }

  camera(): Camera { return this.eye; }
  look(): StatedLook { return this.stated; }
  hidden(): number[] { return this.left; }
  sections(): string[] { return this.section.planes; }
  style(): MouseStyle { return this.mouse; }
  display(): Display { return this.picture.display(); }
  sight(): Sight | null { return this.picture.sight(); }
  pictured(): Pictured { return { camera: this.eye, planes: this.lamps.all, hidden: this.left, ev: null }; }
  isCompared(): boolean { return this.comparison.isShown; }
  rowAt(x: number, y: number): number { return this.picture.rowAt(x, y, this.lamps.all); }
  mirroredOn(x: number, y: number, plane: Plane): Vector | null { return this.picture.mirroredOn(x, y, plane); }

  private restore({ camera, look, planes, hidden, section, seams, lines, notes }: ViewState): void {
    this.eye = { ...this.facts.camera, ...camera };
    this.lamps.take(planes ?? this.lamps.all);
    this.stated = look;
    this.left = hidden;
    this.analysis.notes.show(notes);
    if (section) this.section.show(section);
    if (seams) void this.seams.show(true);
    this.lines.show(lines);
  }

  take({ views: [first], sections, hidden, rig }: OpenedAnalysis): void {
    this.lamps.take(rig.planes);
    this.section.take(sections);
    if (first) this.eye = { ...this.eye, ...first.camera, width: this.eye.width, height: this.eye.height };
    this.choose(lookOf(first?.look ?? "lamps", first?.across) ?? this.stated);
    this.lamps.choose(0);
    this.hide(hidden);
  }

  private state(): ViewState {
    const { all } = this.lamps;
    return {
      camera: this.eye, look: this.stated, planes: all === this.facts.rig.planes ? null : all, hidden: this.left,
      section: this.section.plane, seams: this.seams.shown, lines: this.lines.shown,
      notes: this.analysis.notes.all,
    };
  }

  keep(): void {
    keepInAddress(this.state());
  }

  settled(): void {
    this.seams.update();
    this.lines.settle();
    this.keep();
  }

  drawn(): void {
    this.gizmo.show(this.lamps.row, this.eye);
    this.legend.show(this.display());
  }

  rowChosen(): void {
    showLamps(this);
    this.drawn();
  }

  changed(isEye: boolean, isOver: boolean): void {
    this.picture.changed(isEye, isOver);
    this.lines.outdate();
  }

  setCamera(camera: Camera): void {
    this.eye = camera;
  }

  lookFrom(camera: Camera): void {
    this.eye = sized(camera, this.eye.width, this.eye.height);
    this.changed(true, true);
  }

  flyTo(place: Vector, long = Infinity): void {
    const size = length(difference(this.facts.bounds.upper, this.facts.bounds.lower));
    this.lookFrom(lookingAt(this.eye, place, Math.min(Math.max(3 * long, size / 20), size / 2)));
    this.mark(place);
  }

  pick(x: number, y: number): void {
    const picked = this.picture.pick(x, y);
    this.places.show(picked);
    if (this.lines.pick(x, y)) return;
    const seam = picked && this.seams.pick(x, y);
    if (seam) this.mark(picked.place, seam.course);
    else this.marks.move(picked && picked.place);
  }

  mark(place: Vector, stretch: Vector[][] = []): void {
    this.marks.show(place, stretch);
  }

  addNote(note: Note): void {
    this.analysis.addNote(note);
  }

  hide(faces: number[]): void {
    this.left = faces;
    this.tree.update();
    this.changed(true, true);
  }

  choose(stated: StatedLook): void {
    this.stated = stated;
    this.showLooks();
    if (stated.look === "curvature" || stated.look === "radius") this.picture.measure();
    this.changed(false, true);
  }

  chooseLook(look: Look): void {
    this.choose({ ...this.stated, look });
  }

  private showLooks(): void {
    showLooks(this.stated, this.lamps.row, (look) => this.choose(look));
  }

  views(): { name: string; show: () => void }[] {
    return namedViews(this.facts).map(({ name, camera }) => ({ name, show: () => this.lookFrom(camera) }));
  }

  setStyle(style: MouseStyle): void {
    this.mouse = style;
    localStorage.setItem("mouse", style);
    this.tell(mouseHelp[style]);
  }

  toggleSeams(): void {
    this.seams.toggle();
  }

  turnSection(x: number, y: number): void {
    this.section.turn(x, y);
  }

  toggleLines(): void {
    this.lines.toggle();
  }

  copyLink(): void {
    void copyLink(this.state(), (line) => this.tell(line));
  }

  savePicture(): void {
    const isLamps = this.stated.look === "lamps";
    this.tell("making the picture");
    this.picture.file().then((bytes) => {
      savePicture(bytes, this.facts, this.display(), this.eye);
      if (!isLamps) this.tell("");
    }).catch((error) => this.fail(error));
  }

  tell(line: string): void {
    byId("state").textContent = line;
  }

  fail(error: unknown): void {
    this.tell(error instanceof Error ? error.message : String(error));
  }
}

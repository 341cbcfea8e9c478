import { fetchAnalysis, Note, OpenedAnalysis } from "./analysis";
import { AnalysisHost, AnalysisPanel } from "./analysis_panel";
import { Camera, lookingAt, sized } from "./camera";
import { comparePanel } from "./compare";
import { ExactPicture, Pictured } from "./exact_picture";
import { Facts, Plane, Rig } from "./facts";
import { faultsPanel } from "./faults";
import { Gizmo } from "./gizmo";
import { KeyHost, listenToKeys, showKeys } from "./keys";
import { Marks } from "./marks";
import { lampButtons, LampsHost, showLamps } from "./lamps_panel";
import { keepInAddress, stateOfAddress, ViewState } from "./link";
import { curvatureKinds, CurvatureKind, lookOf, StatedLook } from "./look_words";
import { mouseHelp, MouseStyle, mouseStyles } from "./mouse";
import { button, byId, choice, download, selection, showFacts } from "./panel";
import { showPlace } from "./pick_panel";
import { Display, Look, looks, Picture } from "./picture";
import { Pointer } from "./pointer";
import { afterMove, dragged, RowMove } from "./row_moves";
import { copyLink, savePicture } from "./saving";
import { seamsPanel } from "./seams";
import { SectionPanel } from "./section";
import { viewText } from "./server";
import { showInColours } from "./colours";
import { Tracing } from "./tracing";
import { Tree } from "./tree";
import { difference, length, Vector } from "./vector";

const shownViews = ["front", "rear", "left", "right", "top", "three-quarter-front", "three-quarter-rear"];
const slice = 12; // ms of work between two looks at the mouse

/** The page: one scene, its camera, its lamps, and what is on the way. */
export class Viewer implements KeyHost, LampsHost, AnalysisHost {
  private eye: Camera;
  private rows: Plane[];
  private left: number[] = []; // faces that are not shown
  private stated: StatedLook = { look: "lamps", kind: "mean" };
  private chosenRow = 0;
  private white = 0;
  private fullCurvature = 1e-3;
  private mouse: MouseStyle = "Keiko";
  private readonly canvas = byId("picture") as HTMLCanvasElement;
  private readonly picture: Picture;
  private readonly exact: ExactPicture;
  private readonly tracing: Tracing;
  private readonly gizmo: Gizmo;
  private readonly section: SectionPanel;
  private readonly tree: Tree;
  private readonly marks: Marks;
  private readonly analysis: AnalysisPanel;
  private frame = 0;
  private spent = 0; // ms of work since the last frame
  private turn = 0;  // of the changes: work for an earlier one is out of date

  constructor(readonly facts: Facts) {
    this.eye = facts.camera;
    this.rows = facts.rig.planes;
    this.mouse = mouseStyles.find((style) => style === localStorage.getItem("mouse")) ?? "Keiko";
    this.picture = new Picture(this.canvas, facts);
    this.exact = new ExactPicture(byId("still") as HTMLCanvasElement, (line) => this.tell(line), (error) => this.fail(error));
    this.tracing = new Tracing(facts.reflections, (camera) => this.picture.bufferFor(camera), (buffer) => {
      this.picture.show(buffer);
      this.paint();
    }, { hidden: () => this.left });
    this.gizmo = new Gizmo(this.canvas.parentElement!, (move, amount, isOver) => this.moveRow(move, amount, isOver));
    this.section = new SectionPanel(byId("section"), this, this.canvas);
    this.tree = new Tree(byId("tree"), this);
    this.marks = new Marks(this.canvas, () => this.eye);
    this.analysis = new AnalysisPanel(byId("analysis"), this, this.canvas);
  }

  /** Shows what the address states, or else the analysis that the server was started with, or else its view. */
  async start(): Promise<void> {
    const linked = stateOfAddress(), analysis = await fetchAnalysis();
    if (linked) this.restore(linked);
    else if (analysis) this.analysis.take(analysis);
    this.showPanel();
    new Pointer(this.canvas, this);
    listenToKeys(this.canvas, this);
    window.onresize = () => this.fit();
    this.fit();
    this.changed(true, true);
  }

  camera(): Camera { return this.eye; }
  planes(): Plane[] { return this.rows; }
  row(): number { return this.chosenRow; }
  hidden(): number[] { return this.left; }
  sections(): string[] { return this.section.planes; }
  style(): MouseStyle { return this.mouse; }

  display(): Display {
    return { ...this.stated, planes: this.rows, white: this.white || 1, fullCurvature: this.fullCurvature };
  }

  private restore({ camera, look, planes, hidden, section, notes }: ViewState): void {
    this.eye = { ...this.facts.camera, ...camera };
    this.rows = planes ?? this.rows;
    this.stated = look;
    this.left = hidden;
    this.analysis.notes.show(notes);
    if (section) this.section.show(section);
  }

  take({ views: [first], sections, hidden, rig }: OpenedAnalysis): void {
    this.rows = rig.planes;
    this.left = hidden;
    this.section.take(sections);
    if (first) this.eye = { ...this.eye, ...first.camera, width: this.eye.width, height: this.eye.height };
    this.choose(lookOf(first?.look ?? "lamps") ?? this.stated);
    this.chooseRow(0);
    this.hide(hidden);
  }

  /** Completes the picture after a change: surfaces, bent pixels, white, and after a while the exact picture. */
  private async settle(isEye: boolean): Promise<void> {
    const own = ++this.turn, began = performance.now();
    try {
      if (isEye && !await this.tracing.rest(this.eye)) return;
      const taken = performance.now() - began;
      if (!await this.refine(own)) return;
      this.measure();
      this.draw();
      if (isEye) this.tell(`surfaces in ${taken.toFixed(0)} ms`);
      this.keep();
      if (this.stated.look === "lamps") this.exact.follow(this.pictured());
    } catch (error) {
      this.fail(error);
    }
  }

  /** Divides bent pixels in slices of time; false if something changed meanwhile. */
  private async refine(own: number): Promise<boolean> {
    cancelAnimationFrame(this.frame);
    this.draw();
    while (own === this.turn) {
      if (this.picture.refine(this.display(), slice)) return true;
      await new Promise((resolve) => setTimeout(resolve));
    }
    return false;
  }

  /** White or the scale of curvature, by the picture as it is drawn. */
  private measure(): void {
    const { look, kind } = this.stated;
    if (look === "curvature") this.fullCurvature = this.picture.usualCurvature(kind);
    if (look === "lamps") this.white = this.picture.whiteOf();
  }

  private pictured(): Pictured {
    return { camera: this.eye, planes: this.rows, hidden: this.left };
  }

  private state(): ViewState {
    return {
      camera: this.eye, look: this.stated, planes: this.rows === this.facts.rig.planes ? null : this.rows,
      hidden: this.left, section: this.section.plane, notes: this.analysis.notes.all,
    };
  }

  keep(): void {
    keepInAddress(this.state());
  }

  private paint(): void {
    cancelAnimationFrame(this.frame);
    this.frame = requestAnimationFrame(() => this.drawFrame());
  }

  private drawFrame(): void {
    const began = performance.now();
    this.draw();
    this.canvas.dataset.frame = (performance.now() - began + this.spent).toFixed(1);
    this.spent = 0;
    if (this.white === 0) {
      this.measure();
      this.draw();
    }
  }

  private draw(): void {
    this.picture.draw(this.display());
    this.gizmo.show(this.rows[this.chosenRow], this.eye);
  }

  /** Something has moved: the exact picture is out of date, and follows at rest. */
  changed(isEye: boolean, isOver: boolean): void {
    this.exact.outdate();
    ++this.turn;
    const began = performance.now();
    if (isEye && !isOver) this.tracing.move(this.eye).catch((error) => this.fail(error));
    else this.paint();
    this.spent += performance.now() - began;
    if (isOver) void this.settle(isEye);
  }

  /** Shows pictures as large as the window allows, in the shape of the camera's. */
  private fit(): void {
    const room = this.canvas.parentElement!, { width, height } = this.eye;
    const scale = Math.min(room.clientWidth / width, room.clientHeight / height);
    for (const shown of [this.canvas, this.exact.canvas])
      Object.assign(shown.style, { width: `${width * scale}px`, height: `${height * scale}px` });
  }

  setCamera(camera: Camera): void {
    this.eye = camera;
  }

  lookFrom(camera: Camera): void {
    this.eye = sized(camera, this.eye.width, this.eye.height);
    this.changed(true, true);
  }

  flyTo(place: Vector): void {
    const near = length(difference(this.facts.bounds.upper, this.facts.bounds.lower)) / 2;
    this.lookFrom(lookingAt(this.eye, place, near));
    this.mark(place);
  }

  pick(x: number, y: number): void {
    const place = showPlace(this.picture, this.facts, x, y, (note: Note) => this.analysis.addNote(note));
    this.marks.move(place);
  }

  mark(place: Vector, stretch: Vector[][] = []): void {
    this.marks.show(place, stretch);
  }

  hide(faces: number[]): void {
    this.left = faces;
    this.tree.update();
    this.changed(true, true);
  }

  private edit(row: number, change: (plane: Plane) => Plane): void {
    this.rows = this.rows.map((plane, i) => i === row ? change(plane) : plane);
  }

  grabRow(x: number, y: number): void {
    const row = this.picture.rowAt(x, y, this.rows);
    if (row >= 0 && row !== this.chosenRow) this.chooseRow(row);
  }

  dragRow(x: number, y: number): void {
    this.edit(this.chosenRow, (plane) => dragged(plane, this.eye, x, y));
  }

  moveRow(move: RowMove, amount: number, isOver = true): void {
    this.edit(this.chosenRow, (plane) => afterMove(plane, move, amount));
    this.changed(false, isOver);
  }

  change(row: number, plane: Plane): void {
    this.edit(row, () => plane);
    this.changed(false, true);
  }

  nextRow(): void {
    this.chooseRow((this.chosenRow + 1) % Math.max(this.rows.length, 1));
  }

  chooseRow(row: number): void {
    this.chosenRow = row;
    showLamps(this);
    this.gizmo.show(this.rows[row], this.eye);
  }

  setRig(rig: Rig): void {
    this.rows = rig.planes;
    this.chooseRow(0);
    this.changed(false, true);
  }

  choose(stated: StatedLook): void {
    this.stated = stated;
    this.showLooks();
    if (stated.look === "curvature") this.measure();
    this.changed(false, true);
  }

  chooseLook(look: Look): void {
    this.choose({ ...this.stated, look });
  }

  views(): { name: string; show: () => void }[] {
    const { facts } = this, shown = facts.views.filter(({ name }) => shownViews.includes(name));
    return [{ name: "opened", camera: facts.camera }, ...facts.own_views, ...shown]
      .map(({ name, camera }) => ({ name, show: () => this.lookFrom(camera) }));
  }

  private showLooks(): void {
    const { look, kind } = this.stated;
    choice(byId("look-buttons"), looks, look, (name) => this.chooseLook(name as Look));
    byId("curvature-kind").replaceChildren(...look === "curvature" ? [
      selection("of", curvatureKinds, kind, (name) => this.choose({ look, kind: name as CurvatureKind })),
    ] : []);
  }

  private showPanel(): void {
    this.showLooks();
    byId("views").replaceChildren(...this.views().map(({ name, show }) => button(name, show)),
      button("save view", () => download("view.toml", new Blob([viewText(this.eye)]))));
    showLamps(this);
    lampButtons(this);
    seamsPanel(byId("seams"), this);
    faultsPanel(byId("faults"), this);
    comparePanel(byId("compare"), this, this.canvas);
    byId("page").replaceChildren(button("picture", () => void this.savePicture()),
      button("copy link", () => void copyLink(this.state(), (line) => this.tell(line))), button("keys", () => showKeys(this)),
      selection("mouse", mouseStyles, this.mouse, (style) => this.setStyle(style as MouseStyle)),
      selection("colours", ["light dark", "light", "dark"], localStorage.getItem("colours") ?? "light dark", showInColours));
    showFacts(this.facts);
  }

  private setStyle(style: MouseStyle): void {
    this.mouse = style;
    localStorage.setItem("mouse", style);
    this.tell(mouseHelp[style]);
  }

  /** The exact picture, or that of another look, as a file. */
  async savePicture(): Promise<void> {
    const isLamps = this.stated.look === "lamps";
    try {
      this.tell("making the picture");
      const picture = isLamps ? await this.exact.file(this.pictured())
        : await new Promise<Blob>((use) => this.canvas.toBlob((blob) => use(blob!)));
      savePicture(picture, this.facts, this.display(), this.eye);
      if (!isLamps) this.tell("");
    } catch (error) {
      this.fail(error);
    }
  }

  tell(line: string): void {
    byId("state").textContent = line;
  }

  fail(error: unknown): void {
    this.tell(error instanceof Error ? error.message : String(error));
  }
}

import { Camera, dollied, lookingAt, orbited, panned, rayOf, sized } from "./camera";
import { comparePanel } from "./compare";
import { Facts, Plane, Rig } from "./facts";
import { faultsPanel } from "./faults";
import { Gizmo } from "./gizmo";
import { Key, showDialog } from "./help";
import { Host } from "./host";
import { keepInAddress, linkOf, stateOfAddress, ViewState } from "./link";
import { mouseAction, MouseAction, mouseHelp, MouseStyle, mouseStyles } from "./mouse";
import { button, byId, choice, download, selection, showFacts, showPairs, showRows, showSeams } from "./panel";
import { Display, Look, looks, Picture } from "./picture";
import { afterMove, dragged, RowMove, withRoom } from "./row_moves";
import { sectionPanel } from "./section";
import { ask, facts as fetchFacts, followProgress, hiddenText, newRig, requestText, viewText } from "./server";
import { Tracing } from "./tracing";
import { treePanel } from "./tree";
import { difference, length, scaled, sum, Vector } from "./vector";

const shownViews = ["front", "rear", "left", "right", "top", "three-quarter-front", "three-quarter-rear"];
const lookKeys: Record<string, Look> = {
  l: "lamps", z: "zebra", i: "isophotes", h: "highlight lines", c: "curvature", d: "draft", f: "faces",
};
const rest = 300; // ms without a change before the exact picture is requested
const slice = 12; // ms of work between two looks at the mouse

/** The page: one scene, its camera, its lamps, and what is on the way. */
class Viewer {
  private camera: Camera;
  private planes: Plane[];
  private hidden: number[] = [];
  private look: Look = "lamps";
  private row = 0;
  private white = 0;
  private fullCurvature = 1e-3;
  private style: MouseStyle = "Keiko";
  private readonly canvas = byId("picture") as HTMLCanvasElement;
  private readonly still = byId("still") as HTMLCanvasElement;
  private readonly picture: Picture;
  private readonly tracing: Tracing;
  private readonly gizmo: Gizmo;
  private exact = new AbortController();
  private timer = 0;
  private frame = 0;
  private spent = 0; // ms of work since the last frame
  private turn = 0;  // of the changes: work for an earlier one is out of date
  private drag: { x: number; y: number; action: MouseAction; moved: boolean } | null = null;

  constructor(private readonly facts: Facts) {
    const linked = stateOfAddress();
    this.camera = { ...facts.camera, ...linked?.camera };
    this.planes = linked?.planes ?? facts.rig.planes;
    this.look = linked?.look ?? "lamps";
    this.style = mouseStyles.find((style) => style === localStorage.getItem("mouse")) ?? "Keiko";
    this.picture = new Picture(this.canvas, facts);
    this.tracing = new Tracing(facts.reflections, (camera) => this.picture.bufferFor(camera), (buffer) => {
      this.picture.show(buffer);
      this.paint();
    }, { hidden: () => this.hidden });
    this.gizmo = new Gizmo(this.canvas.parentElement!, (move, amount, isOver) => this.moveRow(move, amount, isOver));
    this.showPanel();
    this.listen();
    window.onresize = () => this.fit();
    this.fit();
    void this.settle(true);
  }

  /** Completes the picture after a change: surfaces, bent pixels, white, and after a while the exact picture. */
  private async settle(isEye: boolean): Promise<void> {
    const own = ++this.turn, began = performance.now();
    try {
      if (isEye && !await this.tracing.rest(this.camera)) return;
      const taken = performance.now() - began;
      if (!await this.refine(own)) return;
      this.measure();
      this.draw();
      if (isEye) this.tell(`surfaces in ${taken.toFixed(0)} ms`);
      keepInAddress(this.state());
      if (this.look === "lamps") this.timer = window.setTimeout(() => void this.fetchStill(), rest);
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
    if (this.look === "curvature") this.fullCurvature = this.picture.usualCurvature();
    if (this.look === "lamps") this.white = this.picture.whiteOf();
  }

  private display(): Display {
    const { look, planes, fullCurvature } = this;
    return { look, planes, white: this.white || 1, fullCurvature };
  }

  private state(): ViewState {
    return { camera: this.camera, look: this.look, planes: this.planes === this.facts.rig.planes ? null : this.planes };
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
    this.gizmo.show(this.planes[this.row], this.camera);
  }

  /** Something has moved: the exact picture is out of date, and follows at rest. */
  private changed(isEye: boolean, isOver: boolean): void {
    if (!this.still.hidden) this.tell("");
    this.still.hidden = true;
    this.exact.abort();
    clearTimeout(this.timer);
    ++this.turn;
    const began = performance.now();
    if (isEye && !isOver) this.tracing.move(this.camera).catch((error) => this.fail(error));
    else this.paint();
    this.spent += performance.now() - began;
    if (isOver) void this.settle(isEye);
  }

  private async fetchStill(): Promise<void> {
    const own = this.exact = new AbortController();
    try {
      const image = await createImageBitmap(await this.stillFile(own.signal));
      if (own.signal.aborted) return;
      Object.assign(this.still, { width: image.width, height: image.height, hidden: false });
      this.still.getContext("2d")!.drawImage(image, 0, 0);
      this.tell("exact picture");
    } catch (error) {
      if (!own.signal.aborted) this.fail(error);
    }
  }

  private async stillFile(signal?: AbortSignal): Promise<Blob> {
    return (await ask("POST", "/still", requestText(this.camera, this.planes, hiddenText(this.hidden)), signal)).blob();
  }

  /** Shows picture and still as large as the window allows, in the shape of the camera's. */
  private fit(): void {
    const room = this.canvas.parentElement!, { width, height } = this.camera;
    const scale = Math.min(room.clientWidth / width, room.clientHeight / height);
    for (const shown of [this.canvas, this.still])
      Object.assign(shown.style, { width: `${width * scale}px`, height: `${height * scale}px` });
  }

  private listen(): void {
    this.canvas.onpointerdown = (event) => {
      this.canvas.setPointerCapture(event.pointerId);
      this.drag = { x: event.clientX, y: event.clientY, action: mouseAction(this.style, event), moved: false };
    };
    this.canvas.onpointermove = (event) => this.move(event);
    this.canvas.onpointerup = (event) => {
      const { drag } = this;
      this.drag = null;
      if (drag?.moved) this.changed(drag.action !== "lamps", true);
      else if (event.button === 0) this.pick(event);
    };
    this.canvas.oncontextmenu = (event) => event.preventDefault();
    this.canvas.onwheel = (event) => {
      event.preventDefault();
      this.camera = dollied(this.camera, Math.exp(event.deltaY / 1000));
      this.changed(true, false);
      this.timer = window.setTimeout(() => this.changed(true, true), rest);
    };
    const keys = new Map(this.keys().map((key) => [key.key, key.act]));
    this.canvas.onkeydown = (event) => this.key(event, keys);
  }

  private move(event: PointerEvent): void {
    const { drag } = this;
    if (!drag) return;
    const x = event.clientX - drag.x, y = event.clientY - drag.y, threshold = 3; // px
    if (!drag.moved && Math.hypot(x, y) < threshold) return;
    // A second button changes what CATIA's middle one does.
    if (drag.action !== "lamps") drag.action = mouseAction(this.style, event);
    if (drag.action === "none") return;
    Object.assign(drag, { x: event.clientX, y: event.clientY, moved: true });
    const scale = this.camera.height / this.canvas.clientHeight;
    this.act(drag.action, x * scale, y * scale);
    this.changed(drag.action !== "lamps", false);
  }

  /** Does what a drag by pixels of the picture means. */
  private act(action: MouseAction, x: number, y: number): void {
    if (action === "lamps") this.edit(this.row, (plane) => dragged(plane, this.camera, x, y));
    if (action === "pan") this.camera = panned(this.camera, x, y);
    if (action === "zoom") this.camera = dollied(this.camera, Math.exp(y / 200));
    if (action === "orbit") this.camera = orbited(this.camera, this.camera.target, -x / 200, -y / 200);
  }

  private edit(row: number, change: (plane: Plane) => Plane): void {
    this.planes = this.planes.map((plane, i) => i === row ? change(plane) : plane);
  }

  private moveRow(move: RowMove, amount: number, isOver: boolean): void {
    this.edit(this.row, (plane) => afterMove(plane, move, amount));
    this.changed(false, isOver);
  }

  private keys(): Key[] {
    const views = this.views(), step = 50, angle = 2; // mm, degrees
    return [
      ...Object.entries(lookKeys).map(([key, look]) => ({ key, words: look, act: () => this.choose(look) })),
      ...views.map(({ name, camera }, i) => ({ key: String(i), words: `view: ${name}`, act: () => this.lookFrom(camera) })),
      { key: "n", words: "the next row of lamps", act: () => this.chooseRow((this.row + 1) % Math.max(this.planes.length, 1)) },
      { key: "+", words: "row 50 mm along its normal", act: () => this.moveRow("normal", step, true) },
      { key: "-", words: "row 50 mm back", act: () => this.moveRow("normal", -step, true) },
      { key: "[", words: "turn the row by 2 degrees", act: () => this.moveRow("turn", angle, true) },
      { key: "]", words: "turn the row back", act: () => this.moveRow("turn", -angle, true) },
      { key: "p", words: "the picture as a file, with its command line", act: () => void this.savePicture() },
      { key: "?", words: "this list", act: () => this.help() },
    ];
  }

  private key(event: KeyboardEvent, keys: Map<string, () => void>): void {
    const step = 10, arrows: Record<string, [number, number]> = {
      ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step],
    };
    const way = arrows[event.key], act = keys.get(event.key);
    if (!way && !act || event.altKey) return;
    if (act && (event.ctrlKey || event.metaKey)) return;
    event.preventDefault();
    if (act) return act();
    this.act(event.ctrlKey ? "lamps" : event.shiftKey ? "pan" : "orbit", ...way);
    this.changed(!event.ctrlKey, true);
  }

  private help(): void {
    const words = this.keys().map(({ key, words }) => [key, words] as const);
    showDialog("Keys and mouse", [
      ["mouse", `${mouseHelp[this.style]}; wheel zooms`], ["Ctrl + drag", "moves the chosen row of lamps in its plane"],
      ["click", "place, normal and radii"], ["arrows", "turn; with Shift pan; with Ctrl move the row"], ...words,
    ]);
  }

  private pick(event: PointerEvent): void {
    const box = this.canvas.getBoundingClientRect();
    const x = Math.floor((event.clientX - box.left) / box.width * this.canvas.width);
    const y = Math.floor((event.clientY - box.top) / box.height * this.canvas.height);
    const at = this.picture.pick(x, y), seen = this.picture.surfaces?.camera ?? this.camera;
    if (!at) return showPairs(byId("pick"), [["nothing", ""]]);
    const { origin, direction } = rayOf(seen, x + 0.5, y + 0.5), place = sum(origin, scaled(direction, at.t));
    const face = at.face > 0 ? this.facts.faces[at.face - 1] : null;
    const numbers = (v: readonly number[], digits: number): string => v.map((n) => n.toFixed(digits)).join(", ");
    showPairs(byId("pick"), [
      ["face", face ? `${face.id} ${face.name}` : "ground"],
      ["place", `${numbers(place, 2)} mm`],
      ["normal", numbers(at.normal, 4)],
      ["radii", at.radii.map((r) => Math.abs(r) < 1e6 ? `${r.toPrecision(4)} mm` : "flat").join(", ")],
    ]);
  }

  private choose(look: Look): void {
    this.look = look;
    choice(byId("looks"), looks, look, (name) => this.choose(name as Look));
    if (look === "curvature") this.measure();
    this.changed(false, true);
  }

  private setRig(rig: Rig): void {
    this.planes = rig.planes;
    this.chooseRow(0);
    this.changed(false, true);
  }

  private chooseRow(row: number): void {
    this.row = row;
    this.showLamps();
    this.gizmo.show(this.planes[row], this.camera);
  }

  private showLamps(): void {
    showRows(this.planes, this.row, (row) => this.chooseRow(row), (row, plane) => {
      this.edit(row, () => withRoom(plane));
      this.changed(false, true);
    });
  }

  private views(): { name: string; camera: Camera }[] {
    return [{ name: "opened", camera: this.facts.camera }, ...this.facts.own_views,
      ...this.facts.views.filter(({ name }) => shownViews.includes(name))];
  }

  private showPanel(): void {
    choice(byId("looks"), looks, this.look, (name) => this.choose(name as Look));
    byId("views").replaceChildren(...this.views().map(({ name, camera }) => button(name, () => this.lookFrom(camera))),
      button("save view", () => download("view.toml", new Blob([viewText(this.camera)]))));
    this.showLamps();
    byId("lamp-buttons").replaceChildren(
      button("place for this view", () => void this.run("/place", async (reply) => this.setRig((await reply.json()).rig))),
      button("save", () => void this.saveRig()), button("open", () => this.open()));
    byId("seams").replaceChildren(button("judge", () => void this.judge()));
    faultsPanel(byId("faults"), this.host());
    comparePanel(byId("compare"), this.host(), this.canvas);
    treePanel(byId("tree"), this.host());
    sectionPanel(byId("section"), this.host(), this.canvas);
    byId("page").replaceChildren(button("picture", () => void this.savePicture()), button("copy link", () => void this.copyLink()),
      button("keys", () => this.help()), selection("mouse", mouseStyles, this.style, (style) => this.setStyle(style as MouseStyle)),
      selection("colours", ["light dark", "light", "dark"], localStorage.getItem("colours") ?? "light dark", showInColours));
    showFacts(this.facts);
  }

  private host(): Host {
    return {
      facts: this.facts, camera: () => this.camera, display: () => this.display(),
      lookFrom: (camera) => this.lookFrom(camera), fail: (error) => this.fail(error),
      hide: (faces) => {
        this.hidden = faces;
        this.changed(true, true);
      },
    };
  }

  private setStyle(style: MouseStyle): void {
    this.style = style;
    localStorage.setItem("mouse", style);
    this.tell(mouseHelp[style]);
  }

  private lookFrom(camera: Camera): void {
    this.camera = sized(camera, this.camera.width, this.camera.height);
    this.changed(true, true);
  }

  /** Asks for work on the view and the lamps that are shown. */
  private async run(path: string, use: (reply: Response) => Promise<void>): Promise<void> {
    try {
      await use(await ask("POST", path, requestText(this.camera, this.planes)));
      this.tell("");
    } catch (error) {
      this.fail(error);
    }
  }

  private async saveRig(): Promise<void> {
    await this.run("/rig", async (reply) => download("rig.toml", await reply.blob()));
  }

  /** Hands out the exact picture, or that of another look, and tells which command makes it. */
  private async savePicture(): Promise<void> {
    const { width, height } = this.camera, isLamps = this.look === "lamps";
    try {
      this.tell("making the picture");
      download("picture.png", isLamps ? await this.stillFile() : await new Promise<Blob>((use) => this.canvas.toBlob((blob) => use(blob!))));
    } catch (error) {
      return this.fail(error);
    }
    const names: Partial<Record<Look, string>> = { isophotes: "isophote", "highlight lines": "highlight", curvature: `curvature:mean=${this.fullCurvature}` };
    const look = isLamps ? "" : ` --look ${names[this.look] ?? this.look}`;
    const command = `keiko render ${this.facts.inputs.join(" ")} --view view.toml --rig rig.toml --size ${width}x${height}${look} -o picture.png`;
    showDialog("Picture", [
      ["file", "picture.png, in your downloads"],
      ["made by", this.look === "faces" ? "this page alone" : command],
      ["", "save view and save write the view and the rig"],
    ]);
    this.tell("");
  }

  private async copyLink(): Promise<void> {
    try {
      await navigator.clipboard.writeText(linkOf(this.state()));
      this.tell("the link is copied; it opens this view as long as the server goes on");
    } catch {
      showDialog("Link", [["address", linkOf(this.state())]]);
    }
  }

  private open(): void {
    const input = Object.assign(document.createElement("input"), { type: "file", accept: ".toml" });
    input.onchange = async () => {
      try {
        if (input.files?.[0]) this.setRig(await newRig(await input.files[0].text()));
      } catch (error) {
        this.fail(error);
      }
    };
    input.click();
  }

  private async judge(): Promise<void> {
    try {
      this.tell("judging the seams");
      const { seams } = await (await ask("GET", "/seams")).json();
      showSeams(seams, (seam) => this.fly(seam.middle));
      this.tell(`${seams.length} stretches of seams, the worst first`);
    } catch (error) {
      this.fail(error);
    }
  }

  private fly(place: Vector): void {
    const near = length(difference(this.facts.bounds.upper, this.facts.bounds.lower)) / 2;
    this.lookFrom(lookingAt(this.camera, place, near));
  }

  private tell(line: string): void {
    byId("state").textContent = line;
  }

  private fail(error: unknown): void {
    this.tell(error instanceof Error ? error.message : String(error));
  }
}

/** Light colours, dark ones, or those of the system. */
function showInColours(scheme: string): void {
  localStorage.setItem("colours", scheme);
  document.documentElement.style.colorScheme = scheme;
}

let progressTimer = 0;

/** Shows what the server works on, until it is done or nothing has been heard of it for a second. */
function showProgress(stage: string, fraction: number): void {
  const shown = byId("work"), clear = (): void => { shown.textContent = ""; };
  clearTimeout(progressTimer);
  shown.textContent = fraction < 1 ? `${stage} ${Math.round(100 * fraction)} %` : "";
  progressTimer = window.setTimeout(clear, 1000);
}

async function start(): Promise<void> {
  try {
    showInColours(localStorage.getItem("colours") ?? "light dark");
    new Viewer(await fetchFacts());
    await followProgress(showProgress);
  } catch (error) {
    byId("state").textContent = error instanceof Error ? error.message : String(error);
  }
}

void start();

import { axesOf, Camera, dollied, lookingAt, orbited, panned, rayOf, sized } from "./camera";
import { comparePanel } from "./compare";
import { readPasses } from "./deep_buffer";
import { Facts, Plane, Rig } from "./facts";
import { faultsPanel } from "./faults";
import { Host } from "./host";
import { button, byId, choice, download, showFacts, showPairs, showRows, showSeams } from "./panel";
import { Look, looks, Picture } from "./picture";
import { sectionPanel } from "./section";
import { ask, facts as fetchFacts, followProgress, hiddenText, newRig, requestText, viewText } from "./server";
import { treePanel } from "./tree";
import { difference, dot, length, scaled, sum, unit, Vector } from "./vector";

const shownViews = ["front", "rear", "left", "right", "top", "three-quarter-front", "three-quarter-rear"];
const rest = 300; // ms without a change before the exact picture is requested

/** The page: one scene, its camera, its lamps, and what is on the way. */
class Viewer {
  private camera: Camera;
  private planes: Plane[];
  private hidden: number[] = [];
  private look: Look = "lamps";
  private row = 0;
  private white = 0;
  private fullCurvature = 1e-3;
  private readonly canvas = byId("picture") as HTMLCanvasElement;
  private readonly still = byId("still") as HTMLCanvasElement;
  private readonly picture: Picture;
  private deep = new AbortController();
  private exact = new AbortController();
  private timer = 0;
  private frame = 0;
  private stride = 1; // of the frames of a drag
  private drag: { x: number; y: number; movesLamps: boolean; pans: boolean; moved: boolean } | null = null;

  constructor(private readonly facts: Facts) {
    this.camera = facts.camera;
    this.planes = facts.rig.planes;
    this.picture = new Picture(this.canvas, facts);
    this.showPanel();
    this.listen();
    window.onresize = () => this.fit();
    this.fit();
    void this.trace(false);
  }

  /** Fetches the surfaces of the view, coarse rows first, or a small draft of it. */
  private async trace(isDraft: boolean): Promise<void> {
    this.deep.abort();
    const own = this.deep = new AbortController();
    const camera = isDraft ? sized(this.camera, this.camera.width >> 1, this.camera.height >> 1) : this.camera;
    const began = performance.now();
    let isFirst = true;
    try {
      const more = `interlaced = ${!isDraft}\nreflections = ${Math.min(8, Math.max(1, this.facts.reflections))}\n${hiddenText(this.hidden)}`;
      const reply = await ask("POST", "/deep", requestText(camera, undefined, more), own.signal);
      await readPasses(reply, (pass) => {
        if (own.signal.aborted) return;
        this.picture.add(pass, camera, isFirst);
        if (isFirst && this.white === 0) this.measure(8);
        isFirst = false;
        this.paint();
      });
      if (!isDraft) this.measure(1);
      this.paint();
      if (!isDraft && this.look === "lamps") this.picture.prepare({ ...this.display(), isHurried: true });
      this.tell(`${isDraft ? "draft" : "surfaces"} in ${(performance.now() - began).toFixed(0)} ms`);
    } catch (error) {
      if (!own.signal.aborted) this.fail(error);
    }
  }

  /** White or the scale of curvature, by every stride-th pixel. */
  private measure(stride: number): void {
    if (this.look === "curvature") this.fullCurvature = this.picture.usualCurvature();
    if (this.look === "lamps") this.white = this.picture.whiteOf(this.display(), stride);
  }

  private display() {
    return {
      look: this.look, planes: this.planes, white: this.white || 1, fullCurvature: this.fullCurvature,
      isHurried: this.drag !== null,
    };
  }

  private paint(): void {
    cancelAnimationFrame(this.frame);
    this.frame = requestAnimationFrame(() => this.drawFrame());
  }

  /** Draws a frame; of a drag every second or fourth pixel where frames take long. */
  private drawFrame(): void {
    const slow = 60, fast = 12, coarsest = 4; // ms; ms; pixels
    const display = this.display(), began = performance.now();
    if (!display.isHurried || this.stride === 1) this.picture.draw(display);
    else this.picture.drawCoarsely(display, this.stride);
    if (!display.isHurried) return;
    this.picture.finish();
    const taken = performance.now() - began;
    if (taken > slow) this.stride = Math.min(coarsest, 2 * this.stride);
    if (taken < fast) this.stride = Math.max(1, this.stride / 2);
  }

  /** Something has moved: the exact picture is out of date, and follows at rest. */
  private changed(isEye: boolean, isOver: boolean): void {
    this.still.hidden = true;
    this.exact.abort();
    clearTimeout(this.timer);
    if (isEye) void this.trace(!isOver);
    else this.paint();
    if (!isOver) return;
    if (!isEye) this.measure(1);
    if (this.look === "lamps") this.timer = window.setTimeout(() => void this.fetchStill(), rest);
  }

  private async fetchStill(): Promise<void> {
    const own = this.exact = new AbortController();
    try {
      const reply = await ask("POST", "/still", requestText(this.camera, this.planes, hiddenText(this.hidden)), own.signal);
      const image = await createImageBitmap(await reply.blob());
      if (own.signal.aborted) return;
      Object.assign(this.still, { width: image.width, height: image.height, hidden: false });
      this.still.getContext("2d")!.drawImage(image, 0, 0);
      this.tell("exact picture");
    } catch (error) {
      if (!own.signal.aborted) this.fail(error);
    }
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
      const movesLamps = event.ctrlKey || event.metaKey;
      this.drag = { x: event.clientX, y: event.clientY, movesLamps, pans: event.shiftKey || event.button > 0, moved: false };
    };
    this.canvas.onpointermove = (event) => this.move(event);
    this.canvas.onpointerup = (event) => {
      const { drag } = this;
      this.drag = null;
      if (drag?.moved) this.changed(!drag.movesLamps, true);
      else this.pick(event);
    };
    this.canvas.oncontextmenu = (event) => event.preventDefault();
    this.canvas.onwheel = (event) => {
      event.preventDefault();
      this.camera = dollied(this.camera, Math.exp(event.deltaY / 1000));
      this.changed(true, false);
      this.timer = window.setTimeout(() => this.changed(true, true), rest);
    };
    this.canvas.onkeydown = (event) => this.key(event);
  }

  private move(event: PointerEvent): void {
    const { drag } = this;
    if (!drag) return;
    const x = event.clientX - drag.x, y = event.clientY - drag.y;
    if (!drag.moved && Math.hypot(x, y) < 3) return;
    Object.assign(drag, { x: event.clientX, y: event.clientY, moved: true });
    if (drag.movesLamps) this.moveRow(x, y);
    else if (drag.pans) this.camera = panned(this.camera, x, y);
    else this.camera = orbited(this.camera, this.camera.target, -x / 200, -y / 200);
    this.changed(!drag.movesLamps, false);
  }

  /** Moves the chosen row within its plane, as far as the pointer at the body. */
  private moveRow(x: number, y: number): void {
    const plane = this.planes[this.row];
    if (!plane) return;
    const { right, up } = axesOf(this.camera), far = length(difference(this.camera.target, this.camera.eye));
    const way = scaled(sum(scaled(right, x), scaled(up, -y)), far * 2 * Math.tan(this.camera.vertical_fov * Math.PI / 360) / this.camera.height);
    const u = unit(plane.u), v = unit(plane.v);
    const step = sum(scaled(u, dot(way, u)), scaled(v, dot(way, v)));
    this.planes = this.planes.map((p, i) => i === this.row ? { ...p, origin: sum(p.origin, step) } : p);
  }

  private key(event: KeyboardEvent): void {
    const step = 10, arrows: Record<string, [number, number]> = {
      ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step],
    };
    const way = arrows[event.key];
    const look = looks["lzc".indexOf(event.key)];
    if (look) this.choose(look);
    if (!way) return;
    event.preventDefault();
    if (event.ctrlKey) this.moveRow(...way);
    else this.camera = orbited(this.camera, this.camera.target, -way[0] / 200, -way[1] / 200);
    this.changed(!event.ctrlKey, true);
  }

  private pick(event: PointerEvent): void {
    const box = this.canvas.getBoundingClientRect();
    const x = Math.floor((event.clientX - box.left) / box.width * this.canvas.width);
    const y = Math.floor((event.clientY - box.top) / box.height * this.canvas.height);
    const at = this.picture.pick(x, y);
    if (!at) return showPairs(byId("pick"), [["nothing", ""]]);
    const { origin, direction } = rayOf(sized(this.camera, this.canvas.width, this.canvas.height), x + 0.5, y + 0.5);
    const face = at.face > 0 ? this.facts.faces[at.face - 1] : null;
    const numbers = (v: readonly number[], digits: number): string => v.map((n) => n.toFixed(digits)).join(", ");
    showPairs(byId("pick"), [
      ["face", face ? `${face.id} ${face.name}` : "ground"],
      ["place", `${numbers(sum(origin, scaled(direction, at.t)), 2)} mm`],
      ["normal", numbers(at.normal, 4)],
      ["radii", at.radii.map((r) => Math.abs(r) < 1e6 ? `${r.toPrecision(4)} mm` : "flat").join(", ")],
    ]);
  }

  private choose(look: Look): void {
    this.look = look;
    choice(byId("looks"), looks, look, (name) => this.choose(name as Look));
    this.changed(false, true);
  }

  private setRig(rig: Rig): void {
    this.planes = rig.planes;
    this.row = 0;
    this.showLamps();
    this.changed(false, true);
  }

  private showLamps(): void {
    showRows(this.planes, this.row, (row) => { this.row = row; }, (row, plane) => {
      this.planes = this.planes.map((p, i) => i === row ? withRoom(plane) : p);
      this.changed(false, true);
    });
  }

  private showPanel(): void {
    choice(byId("looks"), looks, this.look, (name) => this.choose(name as Look));
    const views = [{ name: "opened", camera: this.facts.camera }, ...this.facts.own_views,
      ...this.facts.views.filter(({ name }) => shownViews.includes(name))];
    byId("views").replaceChildren(...views.map(({ name, camera }) => button(name, () => this.lookFrom(camera))),
      button("save view", () => download("view.toml", new Blob([viewText(this.camera)]))));
    this.showLamps();
    byId("lamp-buttons").replaceChildren(
      button("place for this view", () => void this.run("/place", async (reply) => this.setRig((await reply.json()).rig))),
      button("save", () => void this.save()), button("open", () => this.open()));
    faultsPanel(byId("faults"), this.host());
    comparePanel(byId("compare"), this.host(), this.canvas);
    treePanel(byId("tree"), this.host());
    sectionPanel(byId("section"), this.host(), this.canvas);
    byId("seams").replaceChildren(button("judge", () => void this.judge()));
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

  private async save(): Promise<void> {
    await this.run("/rig", async (reply) => download("rig.toml", await reply.blob()));
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
      const { seams } = await (await ask("GET", "/seams")).json();
      showSeams(seams, (seam) => this.fly(seam.middle));
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

/** The row on a plane that is wide enough for it, with the same middle. */
function withRoom(plane: Plane): Plane {
  const needed = (plane.lamps - 1) * plane.pitch + plane.diameter, more = needed - length(plane.v);
  if (more <= 0) return plane;
  const across = unit(plane.v);
  return { ...plane, origin: sum(plane.origin, scaled(across, -more / 2)), v: scaled(across, needed) };
}

async function start(): Promise<void> {
  try {
    new Viewer(await fetchFacts());
    await followProgress((stage, fraction) => {
      byId("state").textContent = `${stage} ${Math.round(100 * fraction)} %`;
    });
  } catch (error) {
    byId("state").textContent = error instanceof Error ? error.message : String(error);
  }
}

void start();

import { Camera } from "./camera";
import { ExactPicture, exposureOf, Pictured } from "./exact_picture";
import { Facts, Plane } from "./facts";
import { StatedLook } from "./look_words";
import { byId } from "./panel";
import { Display, Picked, Picture } from "./picture";
import { Sight } from "./sight";
import { Tracing } from "./tracing";
import { Vector } from "./vector";

const slice = 12; // ms of work between two looks at the mouse

/** What is pictured, and what follows each drawing. */
export interface PicturedHost {
  /** Eye, lamps and hidden faces. */
  pictured(): Pictured;
  /** True while an earlier revision is shown, too: both exact pictures have one exposure. */
  isCompared(): boolean;
  /** The look that is stated. */
  look(): StatedLook;
  /** A picture has been drawn. */
  drawn(): void;
  /** A picture is complete. */
  settled(): void;
  tell(line: string): void;
  fail(error: unknown): void;
}

/** The picture that follows eye and lamps at once, and becomes complete and exact at rest. */
export class LivePicture {
  readonly canvas = byId("picture") as HTMLCanvasElement;
  private readonly picture: Picture;
  private readonly exact: ExactPicture;
  private readonly tracing: Tracing;
  private white = 0;
  private fullCurvature = 1e-3;
  private radii: [number, number] = [1, 1000];
  private frame = 0;
  private spent = 0; // ms of work since the last frame
  private turn = 0;  // of the changes: work for an earlier one is out of date
  private isEyeMoving = false;
  private surfaces = Promise.resolve(true); // of the last eye that came to rest; false: a later eye ended them

  constructor(facts: Facts, private readonly host: PicturedHost) {
    this.picture = new Picture(this.canvas, facts);
    this.exact = new ExactPicture(byId("still") as HTMLCanvasElement, "/still", (line) => host.tell(line), (error) => host.fail(error));
    this.tracing = new Tracing(facts.reflections, (camera, spent) => this.picture.bufferFor(camera, spent), (buffer) => {
      this.picture.show(buffer);
      this.paint();
    }, { hidden: () => host.pictured().hidden });
  }

  display(): Display {
    return { ...this.host.look(), planes: this.host.pictured().planes, white: this.white || 1, fullCurvature: this.fullCurvature, radii: this.radii };
  }

  /** The surface at a pixel, if there is one. */
  pick(x: number, y: number): Picked | null {
    return this.picture.pick(x, y);
  }

  /** What the picture in hand sees; null without one. */
  sight(): Sight | null {
    return this.picture.sight();
  }

  /** The nearest of some rows that a pixel mirrors; -1 without one. */
  rowAt(x: number, y: number, planes: Plane[]): number {
    return this.picture.rowAt(x, y, planes);
  }

  /** Where the reflection at a pixel meets the plane of a row; null if it does not. */
  mirroredOn(x: number, y: number, plane: Plane): Vector | null {
    return this.picture.mirroredOn(x, y, plane);
  }

  /** Something has moved: the exact picture is out of date, and follows at rest. */
  changed(isEye: boolean, isOver: boolean): void {
    this.exact.outdate();
    ++this.turn;
    this.isEyeMoving = isEye && !isOver;
    const began = performance.now();
    if (this.isEyeMoving) this.tracing.move(this.host.pictured().camera).catch((error) => this.host.fail(error));
    else this.paint();
    this.spent += performance.now() - began;
    if (isOver) void this.settle(isEye);
  }

  /** Completes the picture after a change: surfaces, bent pixels, white, and after a while the exact picture. */
  private async settle(isEye: boolean): Promise<void> {
    const own = ++this.turn, began = performance.now(), { host } = this;
    if (isEye) this.surfaces = this.tracing.rest(host.pictured().camera);
    try {
      // Lamps that change meanwhile are shown on all of them, too.
      if (!await this.surfaces || own !== this.turn) return;
      const taken = performance.now() - began;
      if (!await this.refine(own)) return;
      this.measure();
      this.draw();
      if (isEye) host.tell(`surfaces in ${taken.toFixed(0)} ms`);
      host.settled();
      const ev = host.isCompared() ? exposureOf(this.white) : null;
      if (host.look().look === "lamps") this.exact.follow({ ...host.pictured(), ev });
    } catch (error) {
      this.surfaces = Promise.resolve(true);
      host.fail(error);
    }
  }

  /** Divides bent pixels in slices of time; false if something changed meanwhile. */
  private async refine(own: number): Promise<boolean> {
    cancelAnimationFrame(this.frame);
    this.picture.renew();
    this.draw();
    while (own === this.turn) {
      if (this.picture.refine(this.display(), slice)) return true;
      await new Promise((resolve) => setTimeout(resolve));
    }
    return false;
  }

  /** Takes white or the scale of curvatures or radii from the picture as it is drawn. */
  measure(): void {
    const stated = this.host.look(), { look } = stated;
    if (look === "curvature") this.fullCurvature = this.picture.usualCurvature(stated);
    if (look === "radius") this.radii = this.picture.usualRadii();
    if (look === "lamps") this.white = this.picture.whiteOf();
  }

  private paint(): void {
    cancelAnimationFrame(this.frame);
    this.frame = requestAnimationFrame(() => this.drawFrame());
  }

  private drawFrame(): void {
    const began = performance.now();
    this.draw();
    const taken = performance.now() - began + this.spent;
    this.canvas.dataset.frame = taken.toFixed(1);
    this.spent = 0;
    if (this.isEyeMoving) this.tracing.pace(taken);
    if (this.white === 0) {
      this.measure();
      this.draw();
    }
  }

  private draw(): void {
    this.picture.draw(this.display());
    this.host.drawn();
  }

  /** Shows pictures as large as the window allows, in the shape of the camera's. */
  fit({ width, height }: Camera): void {
    const room = this.canvas.parentElement!, scale = Math.min(room.clientWidth / width, room.clientHeight / height);
    for (const shown of [this.canvas, this.exact.canvas])
      Object.assign(shown.style, { width: `${width * scale}px`, height: `${height * scale}px` });
  }

  /** The exact picture, or that of another look, as the bytes of a file. */
  async file(): Promise<Blob> {
    return this.host.look().look === "lamps" ? this.exact.file(this.host.pictured())
      : new Promise<Blob>((use) => this.canvas.toBlob((blob) => use(blob!)));
  }
}

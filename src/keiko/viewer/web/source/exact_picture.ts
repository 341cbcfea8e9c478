import { Camera } from "./camera";
import { Plane } from "./facts";
import { ask, hiddenText, requestText } from "./server";

/** What a picture is requested of. `ev`: its exposure value; null: by the picture. */
export interface Pictured { camera: Camera; planes: Plane[]; hidden: number[]; ev: number | null }

/** The exposure value that shows a luminance, cd/m2, as white; the inverse of film/tone_mapping. */
export const exposureOf = (white: number): number => Math.log2(white / 1.2);

const rest = 300; // ms without a change before the exact picture is requested


/** The picture that `keiko render` makes, over the page's own as long as nothing changes. */
export class ExactPicture {
  private running = new AbortController();
  private timer = 0;

  /** `path`: of the request; `tell` gets a line for the user, `fail` an error. */
  constructor(readonly canvas: HTMLCanvasElement, private readonly path: string, private readonly tell: (line: string) => void,
    private readonly fail: (error: unknown) => void) {}

  /** Something has changed: takes the picture off, and ends work on it. */
  outdate(): void {
    if (!this.canvas.hidden) this.tell("");
    this.canvas.hidden = true;
    this.running.abort();
    clearTimeout(this.timer);
  }

  /** Requests the picture after a while, unless something changes until then. */
  follow(pictured: Pictured): void {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.fetch(pictured), rest);
  }

  /** The bytes of the picture, PNG, for a file. They come even if the view goes on; the server has one such picture
   * at work for a page, so the one for the view ends, and this one serves it too. */
  async file(pictured: Pictured): Promise<Blob> {
    clearTimeout(this.timer);
    this.running.abort();
    const own = this.running = new AbortController();
    const bytes = await this.bytesOf(pictured);
    if (!own.signal.aborted) await this.show(bytes, own.signal);
    return bytes;
  }

  private async fetch(pictured: Pictured): Promise<void> {
    const own = this.running = new AbortController();
    try {
      await this.show(await this.bytesOf(pictured, own.signal), own.signal);
    } catch (error) {
      if (!own.signal.aborted) this.fail(error);
    }
  }

  private async bytesOf({ camera, planes, hidden, ev }: Pictured, signal?: AbortSignal): Promise<Blob> {
    const more = [hiddenText(hidden), ev === null ? "" : `ev = ${ev}`].join("\n");
    return (await ask("POST", this.path, requestText(camera, planes, more), signal)).blob();
  }

  private async show(bytes: Blob, signal: AbortSignal): Promise<void> {
    const image = await createImageBitmap(bytes), { canvas } = this;
    if (signal.aborted) return;
    Object.assign(canvas, { width: image.width, height: image.height, hidden: false });
    canvas.getContext("2d")!.drawImage(image, 0, 0);
    this.tell("exact picture");
  }
}

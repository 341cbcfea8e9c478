import { Camera } from "./camera";
import { Plane } from "./facts";
import { ask, hiddenText, requestText } from "./server";

/** What a picture is requested of. */
export interface Pictured { camera: Camera; planes: Plane[]; hidden: number[] }

const rest = 300; // ms without a change before the exact picture is requested

async function bytesOf({ camera, planes, hidden }: Pictured, signal?: AbortSignal): Promise<Blob> {
  return (await ask("POST", "/still", requestText(camera, planes, hiddenText(hidden)), signal)).blob();
}

/** The picture that `keiko render` makes, over the page's own as long as nothing changes. */
export class ExactPicture {
  private running = new AbortController();
  private timer = 0;

  /** `tell` gets a line for the user, `fail` an error. */
  constructor(readonly canvas: HTMLCanvasElement, private readonly tell: (line: string) => void,
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
    const bytes = await bytesOf(pictured);
    if (!own.signal.aborted) await this.show(bytes, own.signal);
    return bytes;
  }

  private async fetch(pictured: Pictured): Promise<void> {
    const own = this.running = new AbortController();
    try {
      await this.show(await bytesOf(pictured, own.signal), own.signal);
    } catch (error) {
      if (!own.signal.aborted) this.fail(error);
    }
  }

  private async show(bytes: Blob, signal: AbortSignal): Promise<void> {
    const image = await createImageBitmap(bytes), { canvas } = this;
    if (signal.aborted) return;
    Object.assign(canvas, { width: image.width, height: image.height, hidden: false });
    canvas.getContext("2d")!.drawImage(image, 0, 0);
    this.tell("exact picture");
  }
}

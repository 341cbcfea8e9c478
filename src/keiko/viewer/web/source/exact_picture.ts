import { Camera } from "./camera";
import { Plane } from "./facts";
import { ask, hiddenText, requestText } from "./server";

/** What a picture is requested of. */
export interface Pictured { camera: Camera; planes: Plane[]; hidden: number[] }

const rest = 300; // ms without a change before the exact picture is requested

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

  /** The bytes of the picture, PNG. */
  async file({ camera, planes, hidden }: Pictured, signal?: AbortSignal): Promise<Blob> {
    return (await ask("POST", "/still", requestText(camera, planes, hiddenText(hidden)), signal)).blob();
  }

  private async fetch(pictured: Pictured): Promise<void> {
    const own = this.running = new AbortController(), { canvas } = this;
    try {
      const image = await createImageBitmap(await this.file(pictured, own.signal));
      if (own.signal.aborted) return;
      Object.assign(canvas, { width: image.width, height: image.height, hidden: false });
      canvas.getContext("2d")!.drawImage(image, 0, 0);
      this.tell("exact picture");
    } catch (error) {
      if (!own.signal.aborted) this.fail(error);
    }
  }
}

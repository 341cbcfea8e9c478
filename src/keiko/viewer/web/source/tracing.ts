import { Camera, sized } from "./camera";
import { readPasses } from "./deep_buffer";
import { Reprojection } from "./reprojection";
import { ask, hiddenText, requestText } from "./server";
import { SurfaceBuffer } from "./surface_buffer";

/** Of which body surfaces are fetched. */
export interface Traced {
  path?: string;            // of the request
  hidden?: () => number[];  // faces that are left out
}

/** An empty buffer, in the memory of one that is not used any more. */
type BufferFor = (camera: Camera, spent?: SurfaceBuffer | null) => SurfaceBuffer;

const longest = 28, short = 20; // ms of a frame: coarser previews above, finer ones if they take less

/** Fetches the surfaces that an eye sees: small drafts while it moves, all of them at rest. */
export class Tracing {
  /** The last surfaces that came from the server. */
  private source: SurfaceBuffer | null = null;
  private own = new AbortController();
  private isDrafting = false;
  private wanted: Camera | null = null; // of a draft
  private eye: Camera | null = null;    // that moves
  private readonly reprojection = new Reprojection();
  private previewed: SurfaceBuffer | null = null;
  private coarseness = 2; // pixels of the window to one of a preview

  /** `reflections`: most of them that are followed; `show` gets surfaces, which may become more. */
  constructor(private readonly reflections: number, private readonly bufferFor: BufferFor,
    private readonly show: (buffer: SurfaceBuffer) => void, private readonly traced: Traced = {}) {}

  /** Fetches all surfaces, coarse rows first; false if a later call ended this one. */
  async rest(camera: Camera): Promise<boolean> {
    this.own.abort();
    this.wanted = null;
    const own = this.own = new AbortController(), buffer = this.bufferFor(camera), isFirst = !this.source, fineEnough = 2;
    await this.fetch(buffer, true, own.signal, () => {
      if (!isFirst && buffer.rowStep > fineEnough) return;
      this.source = buffer;
      this.show(buffer);
    });
    return !own.signal.aborted;
  }

  /** Shows the surfaces in hand from an eye that moves, and fetches a draft of what it sees. */
  async move(camera: Camera): Promise<void> {
    if (!this.isDrafting) this.own.abort();
    this.eye = camera;
    this.wanted = sized(camera, camera.width >> 1, camera.height >> 1);
    this.preview();
    if (this.isDrafting) return;
    this.isDrafting = true;
    try {
      while (this.wanted) await this.draft(this.wanted);
    } finally {
      this.isDrafting = false;
    }
  }

  private async draft(camera: Camera): Promise<void> {
    const own = this.own = new AbortController(), buffer = this.bufferFor(camera);
    await this.fetch(buffer, false, own.signal, () => { this.source = buffer; });
    if (own.signal.aborted) return;
    if (this.wanted === camera) this.wanted = null, this.show(buffer);
  }

  private preview(): void {
    if (!this.source || !this.eye) return;
    const { eye, coarseness } = this, camera = sized(eye, Math.ceil(eye.width / coarseness), Math.ceil(eye.height / coarseness));
    const buffer = this.previewed = this.bufferFor(camera, this.previewed);
    buffer.add(this.reprojection.pass(this.source, camera));
    this.show(buffer);
  }

  /** Takes the milliseconds of the last frame of a moving eye: the next previews are as fine as the time allows. */
  pace(milliseconds: number): void {
    const finer = this.coarseness - 1;
    if (milliseconds > longest) this.coarseness = Math.min(this.coarseness + 1, 4);
    else if (finer >= 2 && milliseconds * (this.coarseness / finer) ** 2 < short) this.coarseness = finer;
  }

  private async fetch(buffer: SurfaceBuffer, isInterlaced: boolean, signal: AbortSignal, use: () => void): Promise<void> {
    const more = `interlaced = ${isInterlaced}\nreflections = ${Math.min(8, Math.max(1, this.reflections))}\n${hiddenText(this.traced.hidden?.() ?? [])}`;
    try {
      const reply = await ask("POST", this.traced.path ?? "/deep", requestText(buffer.camera, undefined, more), signal);
      await readPasses(reply, (pass) => {
        if (signal.aborted) return;
        buffer.add(pass);
        use();
      });
    } catch (error) {
      if (!signal.aborted) throw error;
    }
  }
}

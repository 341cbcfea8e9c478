import { Camera } from "./camera";
import { element } from "./panel";

/** A canvas over all pictures, which is drawn anew for whichever eye is shown. */
export class EyeOverlay {
  private drawn: Camera | null = null;
  private isFollowing = false;
  private readonly canvas: HTMLCanvasElement;

  /** `draw` draws for an eye on a canvas of its picture's size. */
  constructor(id: string, private readonly picture: HTMLElement, private readonly camera: () => Camera,
    private readonly draw: (context: CanvasRenderingContext2D, camera: Camera) => void) {
    this.canvas = element("canvas", "", { id, className: "overlay" }) as HTMLCanvasElement;
    picture.parentElement!.append(this.canvas); // over the exact picture, too
  }

  /** Draws what has changed, and goes on with the eye as long as there is something. */
  show(isThere: boolean): void {
    this.drawn = null;
    const wasFollowing = this.isFollowing;
    this.isFollowing = isThere;
    if (isThere && !wasFollowing) this.follow();
    if (!isThere) this.canvas.width = 0;
  }

  private follow(): void {
    if (!this.isFollowing) return;
    const camera = this.camera(), { width, height } = this.picture.style;
    Object.assign(this.canvas.style, { width, height });
    if (camera !== this.drawn) {
      Object.assign(this.canvas, { width: camera.width, height: camera.height });
      this.draw(this.canvas.getContext("2d")!, camera);
      this.drawn = camera;
    }
    requestAnimationFrame(() => this.follow());
  }
}

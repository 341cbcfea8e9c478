import { Projection } from "./projection";
import { SurfaceBuffer } from "./surface_buffer";
import { difference, length, Vector } from "./vector";

const slack = 2e-3; // share of the distance to the eye

/** Which places the eye of a buffer sees past its surfaces; the rule of workflow/curve_painter. */
export class Sight extends Projection {
  constructor(private readonly buffer: SurfaceBuffer) {
    super(buffer.camera);
  }

  /** True if a place is as near as the surface at its pixel or one beside it: curves on silhouettes are seen. */
  sees(place: Vector): boolean {
    if (!this.set(place)) return false;
    const away = this.isParallel ? this.depth : length(difference(place, this.camera.eye));
    return away <= this.farthest(Math.floor(this.x), Math.floor(this.y)) * (1 + slack);
  }

  /** The farthest surface at a pixel and around it, mm along the ray; 0 without any. */
  private farthest(x: number, y: number): number {
    const { buffer: { rowStep, pathOf, samples }, camera: { width, height } } = this, row = y - y % rowStep;
    let farthest = 0;
    for (let j = Math.max(row - rowStep, 0); j <= row + rowStep && j < height; j += rowStep)
      for (let i = Math.max(x - 1, 0); i <= x + 1 && i < width; ++i)
        if (pathOf[j * width + i] >= 0) farthest = Math.max(farthest, samples[8 * (j * width + i)]);
    return farthest;
  }
}

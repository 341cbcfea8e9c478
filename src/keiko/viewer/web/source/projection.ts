import { CameraFrame } from "./camera";

/** Where places are in a camera's picture. */
export class Projection extends CameraFrame {
  x = 0;     // px
  y = 0;     // px
  depth = 0; // mm from the eye, or from its plane

  /** Takes the place that three numbers state; false for one beside or behind an eye. */
  set(numbers: ArrayLike<number>, at = 0): boolean {
    const { camera: { eye, width, height }, axes: { right, up, forward } } = this;
    const a = numbers[at] - eye[0], b = numbers[at + 1] - eye[1], c = numbers[at + 2] - eye[2];
    this.depth = a * forward[0] + b * forward[1] + c * forward[2];
    const scale = 1 / (this.size * (this.isParallel ? 1 : this.depth));
    this.x = 0.5 * width + (a * right[0] + b * right[1] + c * right[2]) * scale;
    this.y = 0.5 * height - (a * up[0] + b * up[1] + c * up[2]) * scale;
    return scale > 0;
  }
}

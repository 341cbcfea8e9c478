import { CameraFrame } from "./camera";
import { Surface } from "./surface";

// A ray and its change by a pixel to the right and down is 18 numbers: six vectors, from these places on.
export const rayNumbers = 18;
const originX = 6, originY = 9, directionX = 12, directionY = 15;
const direction = 3;

/** The camera rays of a picture. */
export class CameraRays extends CameraFrame {
  /** Sets a ray to that through a pixel's centre. */
  set(ray: Float64Array, x: number, y: number): void {
    const { right, up, forward } = this.axes, { eye, width, height } = this.camera, { size } = this;
    const across = (x + 0.5 - 0.5 * width) * size, down = (y + 0.5 - 0.5 * height) * size;
    let square = 0, byX = 0, byY = 0;
    for (let k = 0; k < 3; ++k) {
      const aside = right[k] * across - up[k] * down, dx = right[k] * size, dy = -up[k] * size;
      ray[k] = eye[k] + (this.isParallel ? aside : 0);
      ray[originX + k] = this.isParallel ? dx : 0, ray[originY + k] = this.isParallel ? dy : 0;
      const d = ray[direction + k] = forward[k] + (this.isParallel ? 0 : aside);
      ray[directionX + k] = this.isParallel ? 0 : dx, ray[directionY + k] = this.isParallel ? 0 : dy;
      square += d * d, byX += d * dx, byY += d * dy;
    }
    if (!this.isParallel) normalize(ray, square, byX, byY);
  }
}

/** Makes a direction a unit vector, and its derivatives those of one. */
function normalize(ray: Float64Array, square: number, byX: number, byY: number): void {
  const perLength = 1 / Math.sqrt(square);
  for (let k = 0; k < 3; ++k) {
    const d = ray[direction + k];
    ray[direction + k] = d * perLength;
    ray[directionX + k] = (ray[directionX + k] - d * byX / square) * perLength;
    ray[directionY + k] = (ray[directionY + k] - d * byY / square) * perLength;
  }
}

/** The cosine of the angle between a ray and the normal of the surface that it meets; negative on the side it comes from. */
export function cosineAt(ray: Float64Array, s: Surface): number {
  return ray[3] * s.normal[0] + ray[4] * s.normal[1] + ray[5] * s.normal[2];
}

/** Reflects a ray at the surface that it meets, with its differentials [Igehy1999]. */
export function reflect(ray: Float64Array, s: Surface): void {
  const { normal: n, t } = s, along = cosineAt(ray, s);
  let towardsX = 0, towardsY = 0, turnedX = 0, turnedY = 0;
  for (let k = 0; k < 3; ++k) {
    const d = ray[direction + k];
    ray[k] += d * t;
    ray[originX + k] += ray[directionX + k] * t, ray[originY + k] += ray[directionY + k] * t;
    towardsX += ray[originX + k] * n[k], towardsY += ray[originY + k] * n[k];
    turnedX += ray[directionX + k] * n[k], turnedY += ray[directionY + k] * n[k];
  }
  for (let k = 0; k < 3; ++k) {
    const d = ray[direction + k];
    ray[originX + k] -= d * (towardsX / along), ray[originY + k] -= d * (towardsY / along);
  }
  reflectDirection(ray, s, along, turnedX, turnedY);
}

function reflectDirection(ray: Float64Array, s: Surface, along: number, turnedX: number, turnedY: number): void {
  s.turn(ray, originX, turnX);
  s.turn(ray, originY, turnY);
  let byX = turnedX, byY = turnedY;
  for (let k = 0; k < 3; ++k) byX += ray[direction + k] * turnX[k], byY += ray[direction + k] * turnY[k];
  for (let k = 0; k < 3; ++k) {
    const n = s.normal[k];
    ray[directionX + k] -= 2 * (turnX[k] * along + n * byX);
    ray[directionY + k] -= 2 * (turnY[k] * along + n * byY);
    ray[direction + k] -= 2 * along * n;
  }
}

const turnX = new Float64Array(3), turnY = new Float64Array(3);

/** Takes the differentials off a ray: its image is a point. */
export function narrow(ray: Float64Array): void {
  ray.fill(0, originX);
}

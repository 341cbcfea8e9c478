import { ClippedPixel, isAllWhere, PixelLinear, where, wholePixel } from "./clipped_pixel";
import { RowFrame } from "./row_frame";

/** A vector in a plane or in a picture. */
export type Vector2 = [number, number];

/**
 * Where a ray meets a row's plane, and its pixel's image there: a place (x, y) from the pixel's centre is mapped to the
 * offset (x dx + y dy) / (1 + x descent[0] + y descent[1]) from the image's centre. Lengths in mm.
 */
export interface Footprint {
  t: number;
  centre: Vector2;                     // u and v
  direction: [number, number, number]; // of the ray along u, v and the normal
  dx: Vector2;
  dy: Vector2;
  descent: Vector2;
}

/** The footprint of a ray, which is read from a place on. */
export function footprintOf(row: RowFrame, rays: Float32Array, at: number): Footprint {
  const along = (axis: readonly number[], k: number): number =>
    axis[0] * rays[at + k] + axis[1] * rays[at + k + 1] + axis[2] * rays[at + k + 2];
  const { u, v, normal, origin } = row;
  const from = (axis: readonly number[]): number => along(axis, 0) - axis[0] * origin[0] - axis[1] * origin[1] - axis[2] * origin[2];
  const du = along(u, 3), dv = along(v, 3), dz = along(normal, 3), t = -from(normal) / dz;
  const step = (k: number): Vector2 => {
    const down = along(normal, k) + t * along(normal, k + 6);
    return [along(u, k) + t * along(u, k + 6) - du / dz * down, along(v, k) + t * along(v, k + 6) - dv / dz * down];
  };
  return {
    t, centre: [from(u) + t * du, from(v) + t * dv], direction: [du, dv, dz], dx: step(6), dy: step(9),
    descent: [along(normal, 12) / dz, along(normal, 15) / dz],
  };
}

const dot = (a: Vector2, b: Vector2): number => a[0] * b[0] + a[1] * b[1];
export const cross = (a: Vector2, b: Vector2): number => a[0] * b[1] - a[1] * b[0];

/** The part of a pixel whose rays meet the plane. */
export function beforeHorizon({ descent }: Footprint): ClippedPixel {
  const denominator = { amid: 1, byX: descent[0], byY: descent[1] };
  return isAllWhere(wholePixel, denominator) ? wholePixel : where(wholePixel, denominator);
}

/** `slope` times the vector from a point of the plane, less `least`, times the image's denominator. */
export function past({ centre, dx, dy, descent }: Footprint, slope: Vector2, from: Vector2, least: number): PixelLinear {
  const off = dot(slope, [centre[0] - from[0], centre[1] - from[1]]) - least;
  return { amid: off, byX: dot(slope, dx) + off * descent[0], byY: dot(slope, dy) + off * descent[1] };
}

/** The piece of a part between two values of v. */
export function between(image: Footprint, part: ClippedPixel, low: number, high: number): ClippedPixel {
  return where(where(part, past(image, [0, 1], [0, low], 0)), past(image, [0, -1], [0, high], 0));
}

/** v of the corners of a part; NaN on the horizon, to within rounding. */
export function acrossCorners({ centre, dx, dy, descent }: Footprint, part: ClippedPixel): number[] {
  const rounding = 1e-12 * (1 + Math.abs(descent[0]) + Math.abs(descent[1])), values: number[] = [];
  for (let i = 0; i < part.length; i += 2) {
    const before = 1 + descent[0] * part[i] + descent[1] * part[i + 1];
    values.push(before > rounding ? centre[1] + (dx[1] * part[i] + dy[1] * part[i + 1]) / before : NaN);
  }
  return values;
}

/** The smallest area of the image, mm2 per pixel. */
export function leastArea({ dx, dy, descent }: Footprint): number {
  const most = 1 + (Math.abs(descent[0]) + Math.abs(descent[1])) / 2;
  return Math.abs(cross(dx, dy)) / most ** 3;
}

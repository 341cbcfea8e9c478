import { rayNumbers } from "./ray";
import { RowFrame } from "./row_frame";
import { Footprint } from "./footprint";
import { Vector } from "./vector";

/** Places of the numbers of a pixel's ray and its neighbours': centre, left, right, above, below. */
export type Around = [number, number, number, number, number];

// Coefficients of a cubic in the place in the picture: value, x, y, xx, xy, yy, xxx, xxy, xyy, yyy.
const coefficients = 10;

/** Writes the cubic through a value with its slopes, bent by the neighbours' slopes; render/reflection/reflected_footprint. */
function setCubic(to: Float64Array, at: number, value: number, slope: (ray: number, axis: 0 | 1) => number): void {
  const x = slope(0, 0), y = slope(0, 1), leftX = slope(1, 0), rightX = slope(2, 0), aboveY = slope(3, 1), belowY = slope(4, 1);
  const leftY = slope(1, 1), rightY = slope(2, 1), aboveX = slope(3, 0), belowX = slope(4, 0);
  to[at] = value, to[at + 1] = x, to[at + 2] = y;
  to[at + 3] = 0.5 * (rightX - leftX), to[at + 5] = 0.5 * (belowY - aboveY);
  to[at + 4] = 0.25 * (belowX - aboveX + rightY - leftY);
  to[at + 6] = rightX - 2 * x + leftX, to[at + 7] = rightY - 2 * y + leftY;
  to[at + 8] = belowX - 2 * x + aboveX, to[at + 9] = belowY - 2 * y + aboveY;
}

function cubicAt(c: Float64Array, at: number, x: number, y: number): number {
  const xx = 0.5 * x * x, yy = 0.5 * y * y;
  return c[at] + c[at + 1] * x + c[at + 2] * y + c[at + 3] * xx + c[at + 4] * x * y + c[at + 5] * yy
    + c[at + 6] * xx * x / 3 + c[at + 7] * xx * y + c[at + 8] * x * yy + c[at + 9] * yy * y / 3;
}
function cubicByX(c: Float64Array, at: number, x: number, y: number): number {
  return c[at + 1] + c[at + 3] * x + c[at + 4] * y + 0.5 * c[at + 6] * x * x + c[at + 7] * x * y + 0.5 * c[at + 8] * y * y;
}
function cubicByY(c: Float64Array, at: number, x: number, y: number): number {
  return c[at + 2] + c[at + 4] * x + c[at + 5] * y + 0.5 * c[at + 7] * x * x + c[at + 8] * x * y + 0.5 * c[at + 9] * y * y;
}

const corners: readonly [number, number][] = [[-0.5, -0.5], [0.5, -0.5], [-0.5, 0.5], [0.5, 0.5]];
const slices = new Float64Array(4 * coefficients); // origin, its height, direction, its height

/** Sets the cubics of what decides where rays meet a plane along one of its axes. */
function setSlices(row: RowFrame, axis: Vector, rays: Float32Array, around: Around): void {
  const along = (a: Vector, at: number): number => a[0] * rays[at] + a[1] * rays[at + 1] + a[2] * rays[at + 2];
  const { origin, normal } = row, base = along;
  [axis, normal].forEach((a, i) => {
    const offset = a[0] * origin[0] + a[1] * origin[1] + a[2] * origin[2];
    setCubic(slices, i * coefficients, base(a, around[0]) - offset, (ray, by) => along(a, around[ray] + 6 + 3 * by));
    setCubic(slices, (2 + i) * coefficients, base(a, around[0] + 3), (ray, by) => along(a, around[ray] + 12 + 3 * by));
  });
}

/** Place along the axis, mm, where the ray of a corner meets the plane; NaN if it does not. */
function cornerPlace(x: number, y: number): number {
  const t = -cubicAt(slices, coefficients, x, y) / cubicAt(slices, 3 * coefficients, x, y);
  return t > 0 && Number.isFinite(t) ? cubicAt(slices, 0, x, y) + t * cubicAt(slices, 2 * coefficients, x, y) : NaN;
}

/** Deviation of the corners of a pixel's image across the lamps from a linear one, mm; NaN if a corner misses the plane. */
export function bendAcross(row: RowFrame, rays: Float32Array, around: Around, image: Footprint): number {
  setSlices(row, row.v, rays, around);
  let bend = 0;
  for (const [x, y] of corners) {
    const off = Math.abs(cornerPlace(x, y) - image.centre[1] - x * image.dx[1] - y * image.dy[1]);
    if (!(off <= bend)) bend = off;
    if (Number.isNaN(off)) return NaN;
  }
  return bend;
}

/** The same along the lamps, from a projective image, as a share of its span; at most 1. */
export function bendAlong(row: RowFrame, rays: Float32Array, around: Around, image: Footprint): number {
  const { dx, dy, descent, centre } = image, span = Math.abs(dx[0]) + Math.abs(dy[0]);
  if (!(1 - 0.5 * (Math.abs(descent[0]) + Math.abs(descent[1])) > 0)) return 1;
  setSlices(row, row.u, rays, around);
  let off = 0;
  for (const [x, y] of corners)
    off = Math.max(off, Math.abs(cornerPlace(x, y) - centre[0] - (x * dx[0] + y * dy[0]) / (1 + x * descent[0] + y * descent[1])));
  return Math.min(off / span, 1);
}

/** Parts on a side of a pixel, 1 to 8, by the bend of its image in pitches. */
export function partsOfBend(bend: number): number {
  const straight = 0.01, most = 8;
  return bend > straight ? Math.min(Math.ceil(Math.sqrt(bend / straight)), most) : 1;
}

/** A pixel's reflected rays as a cubic in the place in the picture. */
export class CubicPixel {
  private readonly cubics = new Float64Array(6 * coefficients);
  readonly ray = new Float32Array(rayNumbers);

  set(rays: Float32Array, around: Around): void {
    for (let k = 0; k < 6; ++k) {
      const slopes = k < 3 ? 6 + k : 9 + k; // origin by x from 6 on, by y from 9; direction from 12 and 15
      setCubic(this.cubics, k * coefficients, rays[around[0] + k], (ray, by) => rays[around[ray] + slopes + 3 * by]);
    }
  }

  /** Sets `ray` to that of a part around a place, whose sides are a share of the pixel's. */
  setPart(x: number, y: number, share: number): void {
    const { cubics, ray } = this;
    for (let k = 0; k < 6; ++k) {
      const slopes = k < 3 ? 6 + k : 9 + k, at = k * coefficients;
      ray[k] = cubicAt(cubics, at, x, y);
      ray[slopes] = cubicByX(cubics, at, x, y) * share, ray[slopes + 3] = cubicByY(cubics, at, x, y) * share;
    }
  }
}

/** A function linear in the place in the picture, from the pixel's centre: its value there, and its rates per pixel. */
export interface PixelLinear { amid: number; byX: number; byY: number }

/** A convex part of a pixel as its corners, x and y in turn, px from the centre. */
export type ClippedPixel = number[];

export const wholePixel: ClippedPixel = [-0.5, -0.5, 0.5, -0.5, 0.5, 0.5, -0.5, 0.5];

const valueAt = (f: PixelLinear, part: ClippedPixel, i: number): number => f.amid + f.byX * part[i] + f.byY * part[i + 1];

/** The part where a function is not negative [SutherlandHodgman1974]. */
export function where(part: ClippedPixel, side: PixelLinear): ClippedPixel {
  const cut: ClippedPixel = [], count = part.length;
  for (let i = 0; i < count; i += 2) {
    const j = (i + 2) % count, from = valueAt(side, part, i), to = valueAt(side, part, j);
    if (from >= 0) cut.push(part[i], part[i + 1]);
    if (from >= 0 === to >= 0) continue;
    const along = from / (from - to);
    cut.push(part[i] + (part[j] - part[i]) * along, part[i + 1] + (part[j + 1] - part[i + 1]) * along);
  }
  return cut;
}

/** True if a function is not negative in all of a part. */
export function isAllWhere(part: ClippedPixel, side: PixelLinear): boolean {
  for (let i = 0; i < part.length; i += 2) if (!(valueAt(side, part, i) >= 0)) return false;
  return true;
}

/** True if a function is not negative at a corner of a part. */
export function isAnyWhere(part: ClippedPixel, side: PixelLinear): boolean {
  for (let i = 0; i < part.length; i += 2) if (valueAt(side, part, i) >= 0) return true;
  return false;
}

/** Area, in pixels. */
export function area(part: ClippedPixel): number {
  let twice = 0;
  for (let i = 4; i < part.length; i += 2)
    twice += (part[i - 2] - part[0]) * (part[i + 1] - part[1]) - (part[i - 1] - part[1]) * (part[i] - part[0]);
  return Math.abs(twice) / 2;
}

import { area, ClippedPixel, isAllWhere, isAnyWhere, where } from "./clipped_pixel";
import { acrossCorners, Footprint, leastArea, past, Vector2 } from "./footprint";
import { RowFrame } from "./row_frame";

/** The image of one end of a lamp: at q across its strip, -1 to 1, the curve u = at + shear q + bulge sqrt(1 - q²), mm. */
export interface TubeEnd { at: number; shear: number; bulge: number }

/** The images of both ends of a row's lamps. */
export interface TubeEnds { begin: TubeEnd; end: TubeEnd }

/** Side of an end's curve: of lesser u or of greater. */
export type Side = "before" | "past";

/** Ends straight across the lamps. */
export const straightEnds = (row: RowFrame): TubeEnds =>
  ({ begin: { at: 0, shear: 0, bulge: 0 }, end: { at: row.length, shear: 0, bulge: 0 } });

/** Ends of round tubes, for rays of a direction along u, v and the normal; light/tubes/end_coverage has the derivation. */
export function tubeEnds(row: RowFrame, [du, dv, dz]: readonly number[]): TubeEnds {
  const bulge = 0.5 * row.diameter * du / Math.hypot(dv, dz), shear = bulge * dv / Math.abs(dz);
  const [first, last] = row.hasLuminousCaps ? [-Math.abs(bulge), Math.abs(bulge)] : [bulge, bulge];
  return { begin: { at: 0, shear, bulge: first }, end: { at: row.length, shear, bulge: last } };
}

/** Cuts strips of a half width, mm, in a pixel's image at the ends of lamps, by chords that bound as much as the curves. */
export class TubeEndClipper {
  constructor(private readonly half: number, private readonly image: Footprint) {}

  /** Area of a part on the strip around an axis, on one side of an end. */
  area(part: ClippedPixel, axis: number, end: TubeEnd, side: Side): number {
    const isConvex = side === "before" ? end.bulge >= 0 : end.bulge <= 0;
    if (isConvex) return area(this.cut(part, axis, end, side));
    const other = side === "before" ? "past" : "before";
    return Math.max(area(part) - area(this.cut(part, axis, end, other)), 0);
  }

  /** The part on one side of an end, that from which the curve bulges away. */
  cut(part: ClippedPixel, axis: number, end: TubeEnd, side: Side): ClippedPixel {
    const { image, half } = this, sign = side === "before" ? 1 : -1, bulge = Math.abs(end.bulge);
    const from: Vector2 = [end.at, axis], inwards: Vector2 = [-sign, sign * end.shear / half];
    const chord = past(image, inwards, from, 0);
    if (isAllWhere(part, chord)) return part;
    if (bulge === 0) return where(part, chord);
    const tangent = past(image, inwards, from, -bulge);
    if (!isAnyWhere(part, tangent)) return where(part, tangent);
    const [begin, last] = this.arcOn(part, axis);
    const { halvings, halfChord } = this.halvingsOf(Math.hypot(last[0] - begin[0], last[1] - begin[1]) / 2, bulge);
    const level = meanLevel(halfChord);
    return cutAlong(part, begin, last, halvings, (piece, n) =>
      where(piece, past(image, [inwards[0] * n[0], inwards[1] * n[0] - n[1] * bulge / half], from, -level * bulge)));
  }

  /** Begin and end of the arc on which a part lies, of the unit circle that a rim is across a strip. */
  private arcOn(part: ClippedPixel, axis: number): [Vector2, Vector2] {
    const steep = 0.99; // beyond, the strip's side is used
    let low = 1, high = -1;
    for (const v of acrossCorners(this.image, part)) {
      const q = (v - axis) / this.half;
      low = Number.isFinite(q) ? Math.min(low, q) : -1;
      high = Number.isFinite(q) ? Math.max(high, q) : 1;
    }
    low = low < -steep ? -1 : Math.min(low, steep);
    high = high > steep ? 1 : Math.max(high, low, -steep);
    return [[Math.sqrt(1 - low * low), low], [Math.sqrt(1 - high * high), high]];
  }

  /** Halvings of an arc until its chords are near enough, and half the length of these. */
  private halvingsOf(halfChord: number, bulge: number): { halvings: number; halfChord: number } {
    const most = 4, scale = 8 * 0.02 * this.half * bulge, enough = 1e-3 * leastArea(this.image);
    let halvings = 0;
    for (; halvings < most && scale * halfChord ** 3 > enough; ++halvings)
      halfChord = Math.sqrt((1 - Math.sqrt(1 - halfChord * halfChord)) / 2);
    return { halvings, halfChord };
  }
}

/** Distance from a unit circle's centre of the chord that bounds the same area as its arc. */
function meanLevel(halfChord: number): number {
  return halfChord > 1e-6 ? (Math.sqrt(1 - halfChord * halfChord) + Math.asin(halfChord) / halfChord) / 2 : 1;
}

/** Cuts by the chords of an arc; `clip` cuts by that of a normal. */
function cutAlong(part: ClippedPixel, from: Vector2, to: Vector2, halvings: number,
  clip: (part: ClippedPixel, normal: Vector2) => ClippedPixel): ClippedPixel {
  const chord: Vector2 = [to[0] - from[0], to[1] - from[1]], length = Math.hypot(...chord);
  const normal: Vector2 = length > 1e-6 ? [chord[1] / length, -chord[0] / length] : from;
  if (halvings === 0) return clip(part, normal);
  return cutAlong(cutAlong(part, from, normal, halvings - 1, clip), normal, to, halvings - 1, clip);
}

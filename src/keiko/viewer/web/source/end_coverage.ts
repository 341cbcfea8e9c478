import { ClippedPixel } from "./clipped_pixel";
import { acrossCorners, beforeHorizon, between, cross, Footprint, footprintOf, Vector2 } from "./footprint";
import { RowFrame } from "./row_frame";
import { straightEnds, TubeEnd, TubeEndClipper, TubeEnds, tubeEnds } from "./tube_end";

const clamp = (x: number, low: number, high: number): number => Math.min(Math.max(x, low), high);

/** Coverage of a pixel by a row at the ends of its lamps, 0 to 1; the formulas of light/tubes/c_plane_lookup. */
export function endCoverage(row: RowFrame, rays: Float32Array, at: number): number {
  if (row.lamps === 0) return 0;
  const image = footprintOf(row, rays, at);
  const isPoint = image.dx.concat(image.dy).every((x) => x === 0);
  if (isPoint) image.dx = [1e-6, 0], image.dy = [0, 1e-6];
  const direction = row.isRound ? directionTo(image, wayToRow(row, image)) : image.direction;
  const ends = row.isRound ? endsOfTubes(row, image, direction) : straightEnds(row);
  const strips = new RowInPixel(row, row.isRound ? apparentDiameter(row, direction) : row.diameter, ends, image);
  const isResolved = Math.max(Math.abs(image.dx[1]), Math.abs(image.dy[1])) <= 4 * row.pitch;
  return strips.coverage(isResolved);
}

const apparentDiameter = (row: RowFrame, [, dv, dz]: readonly number[]): number => row.diameter * Math.hypot(dv, dz) / Math.abs(dz);

/** Offset from the hit to the nearest point of the row. */
function wayToRow(row: RowFrame, { centre: [u, v] }: Footprint): Vector2 {
  return [clamp(u, 0, row.length) - u, clamp(v, row.first, row.last) - v];
}

/** The direction of the pixel's ray that meets the plane at an offset from the centre's hit, or nearest to that. */
function directionTo({ direction, dx, dy, descent }: Footprint, way: Vector2): Footprint["direction"] {
  if (way[0] === 0 && way[1] === 0) return direction;
  const x: Vector2 = [dx[0] - way[0] * descent[0], dx[1] - way[1] * descent[0]];
  const y: Vector2 = [dy[0] - way[0] * descent[1], dy[1] - way[1] * descent[1]];
  const down = cross(dx, dy) / cross(x, y), off = (Math.abs(descent[0]) + Math.abs(descent[1])) / 2;
  return [direction[0], direction[1], direction[2] * (down > 0 ? clamp(down, 1 - off, 1 + off) : 1 + off)];
}

/** The ends of all lamps, each from the direction to that end of the lamp whose axis is nearest to the hit. */
function endsOfTubes(row: RowFrame, image: Footprint, direction: readonly number[]): TubeEnds {
  const guess = tubeEnds(row, direction), [u, v] = image.centre;
  const axis = row.first + clamp(Math.round((v - row.first) / row.pitch), 0, row.lamps - 1) * row.pitch;
  const q = clamp((v - axis) / (apparentDiameter(row, direction) / 2), -1, 1), across = wayToRow(row, image)[1];
  const seen = (end: TubeEnd): TubeEnds =>
    tubeEnds(row, directionTo(image, [end.at + end.shear * q + end.bulge * Math.sqrt(1 - q * q) - u, across]));
  return { begin: seen(guess.begin).begin, end: seen(guess.end).end };
}

/** The strips of a row in a pixel. */
class RowInPixel {
  private readonly half: number;
  private readonly clipper: TubeEndClipper;
  private readonly pixel: ClippedPixel;
  private readonly beginsWithCap: boolean;

  constructor(private readonly row: RowFrame, width: number, private readonly ends: TubeEnds, private readonly image: Footprint) {
    this.half = width / 2;
    this.clipper = new TubeEndClipper(this.half, image);
    this.pixel = beforeHorizon(image);
    this.beginsWithCap = ends.begin.bulge > 0;
  }

  coverage(isResolved: boolean): number {
    const isApart = 2 * this.half < this.row.pitch;
    if (isApart && !isResolved) return this.greyBand();
    const [low, high] = this.lamps();
    let sum = 0;
    for (let lamp = low; lamp <= high; ++lamp) {
      const axis = this.row.first + lamp * this.row.pitch;
      const part = this.cutConvex(between(this.image, this.pixel, axis - this.half, axis + this.half), axis);
      sum += this.seenOf(part, axis) - (isApart ? 0 : this.hiddenOf(part, axis));
    }
    return clamp(sum, 0, 1);
  }

  /** Numbers of the first and the last lamp in the pixel. */
  private lamps(): [number, number] {
    const { row, half } = this;
    let low = row.last, high = row.first;
    for (const v of acrossCorners(this.image, this.pixel)) {
      low = Number.isFinite(v) ? Math.min(low, v) : row.first;
      high = Number.isFinite(v) ? Math.max(high, v) : row.last;
    }
    return [Math.max(Math.ceil((low - half - row.first) / row.pitch), 0),
      Math.min(Math.floor((high + half - row.first) / row.pitch), row.lamps - 1)];
  }

  /** Coverage of strips too fine to be distinguished, as the mean over their possible positions. */
  private greyBand(): number {
    const { row, image, ends } = this, count = ends.begin.shear === 0 ? 1 : 8, beyond = row.pitch / 2;
    let sum = 0;
    for (let i = 0; i < count; ++i) {
      const q = (i + 0.5) * 2 / count - 1, at = (end: TubeEnd): number => end.at + end.shear * q + Math.PI / 4 * end.bulge;
      const band = between(image, this.pixel, row.first - beyond, row.last + beyond);
      const straight = (edge: number): TubeEnd => ({ at: edge, shear: 0, bulge: 0 });
      sum += this.clipper.area(this.clipper.cut(band, 0, straight(at(ends.begin)), "past"), 0, straight(at(ends.end)), "before");
    }
    return 2 * this.half / row.pitch * sum / count;
  }

  /** The part of a strip on the lamp's side of its end without a dark cap, or of its begin: it is convex. */
  private cutConvex(strip: ClippedPixel, axis: number): ClippedPixel {
    return this.beginsWithCap ? this.clipper.cut(strip, axis, this.ends.end, "before")
      : this.clipper.cut(strip, axis, this.ends.begin, "past");
  }

  /** The area of such a part that is on the lamp's side of its other end too. */
  private seenOf(part: ClippedPixel, axis: number): number {
    return this.beginsWithCap ? this.clipper.area(part, axis, this.ends.begin, "past")
      : this.clipper.area(part, axis, this.ends.end, "before");
  }

  /** The area of such a part behind the neighbour that rays meet before the lamp. */
  private hiddenOf(part: ClippedPixel, axis: number): number {
    const { row, half, ends, clipper } = this, fromBegin = this.beginsWithCap;
    const before = fromBegin === ends.begin.shear > 0 ? axis - row.pitch : axis + row.pitch;
    if (before < row.first - row.pitch / 2 || before > row.last + row.pitch / 2) return 0;
    const both = between(this.image, part, before - half, before + half);
    const hidden = fromBegin ? clipper.cut(both, before, { ...ends.begin, bulge: -Math.abs(ends.begin.bulge) }, "past")
      : clipper.cut(both, before, { ...ends.end, bulge: Math.abs(ends.end.bulge) }, "before");
    return this.seenOf(hidden, axis);
  }
}

import { Plane } from "./facts";
import { cross, difference, dot, length, scaled, sum, unit, Vector } from "./vector";

/** A row of lamps in the axes of its plane: u along the lamps, v across them, from the plane's corner. Lengths in mm. */
export class RowFrame {
  readonly u: Vector;
  readonly v: Vector;
  readonly normal: Vector;
  readonly origin: Vector;
  readonly length: number;
  readonly first: number; // v of the first axis
  readonly last: number;
  readonly pitch: number;
  readonly lamps: number;
  readonly diameter: number;
  readonly isRound: boolean;
  readonly hasLuminousCaps: boolean;
  readonly luminance: Vector;

  constructor(plane: Plane) {
    this.u = unit(plane.u);
    const across = difference(plane.v, scaled(this.u, dot(this.u, plane.v)));
    this.v = unit(across);
    this.normal = cross(this.u, this.v);
    this.origin = plane.origin;
    this.length = length(plane.u);
    this.first = (length(across) - (plane.lamps - 1) * plane.pitch) / 2;
    this.last = this.first + (plane.lamps - 1) * plane.pitch;
    this.pitch = plane.pitch, this.lamps = plane.lamps, this.diameter = plane.diameter;
    this.isRound = plane.mirror !== "flat";
    this.hasLuminousCaps = plane.caps === "luminous";
    this.luminance = plane.luminance;
  }

  /** The way of a ray to the row's plane, mm; negative or not a number if it does not come there. */
  distanceToPlane(origin: Vector, direction: Vector): number {
    return dot(this.normal, difference(this.origin, origin)) / dot(this.normal, direction);
  }

  /** The way of a ray to the rectangle between the plane's corners, mm; Infinity if it misses it. */
  distanceTo(origin: Vector, direction: Vector): number {
    const away = this.distanceToPlane(origin, direction);
    if (!(away > 0)) return Infinity;
    const at = difference(sum(origin, scaled(direction, away)), this.origin), along = dot(at, this.u), across = dot(at, this.v);
    const room = this.diameter / 2;
    return along >= 0 && along <= this.length && across >= this.first - room && across <= this.last + room ? away : Infinity;
  }

  /** True if the other row has as many lamps, as thick and as far apart, of the same length. */
  hasLampsOf(other: RowFrame): boolean {
    return this.lamps === other.lamps && this.pitch === other.pitch && this.diameter === other.diameter
      && this.length === other.length && this.first === other.first && this.isRound === other.isRound;
  }

  /** True if images of rays on the other's plane are those on this one but for an offset. */
  hasPlaneOf(other: RowFrame): boolean {
    const rounding = 1e-12, height = dot(this.normal, difference(this.origin, other.origin));
    return length(difference(this.u, other.u)) < rounding && length(difference(this.v, other.v)) < rounding
      && Math.abs(height) < rounding * (1 + length(this.origin));
  }
}

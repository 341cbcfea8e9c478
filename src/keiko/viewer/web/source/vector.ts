/** A vector in space: x, y, z. */
export type Vector = [number, number, number];

export const sum = (a: Vector, b: Vector): Vector => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const difference = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scaled = (a: Vector, s: number): Vector => [a[0] * s, a[1] * s, a[2] * s];
export const dot = (a: Vector, b: Vector): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const length = (a: Vector): number => Math.hypot(...a);
export const unit = (a: Vector): Vector => scaled(a, 1 / length(a));
export const cross = (a: Vector, b: Vector): Vector =>
  [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

/** The vector turned about a unit axis by an angle in radians. */
export function turned(a: Vector, axis: Vector, angle: number): Vector {
  const along = scaled(axis, dot(axis, a) * (1 - Math.cos(angle)));
  return sum(sum(scaled(a, Math.cos(angle)), scaled(cross(axis, a), Math.sin(angle))), along);
}

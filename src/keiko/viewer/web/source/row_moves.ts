import { Camera, axesOf, pixelSize } from "./camera";
import { Plane } from "./facts";
import { cross, difference, dot, length, scaled, sum, turned, unit, Vector } from "./vector";

/** Ways in which a row of lamps moves as a whole. */
export type RowMove = "along" | "across" | "normal" | "turn" | "tilt";

/** Unit axes of a row: along its lamps, across them, and along its normal. */
export function rowAxes(plane: Plane): Record<"along" | "across" | "normal", Vector> {
  const along = unit(plane.u), normal = unit(cross(plane.u, plane.v));
  return { along, across: cross(normal, along), normal };
}

export const moved = (plane: Plane, step: Vector): Plane => ({ ...plane, origin: sum(plane.origin, step) });

/** The row turned about an axis through its middle, by an angle in radians. */
export function turnedRow(plane: Plane, axis: Vector, angle: number): Plane {
  const middle = sum(plane.origin, scaled(sum(plane.u, plane.v), 0.5)), turn = (a: Vector): Vector => turned(a, axis, angle);
  return { ...plane, origin: sum(middle, turn(difference(plane.origin, middle))), u: turn(plane.u), v: turn(plane.v) };
}

/** mm at the target that a pixel of the picture shows. */
export function mmOfPixel(camera: Camera): number {
  return pixelSize(camera) * (camera.projection === "orthographic" ? 1 : length(difference(camera.target, camera.eye)));
}

/** The row moved by what a step has within its plane. */
export function movedWithin(plane: Plane, step: Vector): Plane {
  const { along, across } = rowAxes(plane);
  return moved(plane, sum(scaled(along, dot(step, along)), scaled(across, dot(step, across))));
}

/** The row after a drag of the picture by pixels, within its plane. */
export function dragged(plane: Plane, camera: Camera, x: number, y: number): Plane {
  const { right, up } = axesOf(camera);
  return movedWithin(plane, scaled(sum(scaled(right, x), scaled(up, -y)), mmOfPixel(camera)));
}

/** The row after a move by mm, or for turns by degrees. */
export function afterMove(plane: Plane, move: RowMove, amount: number): Plane {
  const axes = rowAxes(plane), angle = amount * Math.PI / 180;
  if (move === "turn") return turnedRow(plane, axes.normal, angle);
  if (move === "tilt") return turnedRow(plane, axes.along, angle);
  return moved(plane, scaled(axes[move], amount));
}

/** The row on a plane that is wide enough for it, with the same middle. */
export function withRoom(plane: Plane): Plane {
  const needed = (plane.lamps - 1) * plane.pitch + plane.diameter, more = needed - length(plane.v);
  if (more <= 0) return plane;
  const across = unit(plane.v);
  return { ...plane, origin: sum(plane.origin, scaled(across, -more / 2)), v: scaled(across, needed) };
}

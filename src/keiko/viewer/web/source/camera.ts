import { cross, difference, dot, length, scaled, sum, turned, unit, Vector } from "./vector";

/** The eye of a picture, as the server has it. Lengths in mm, angles in degrees. */
export interface Camera {
  projection: "perspective" | "orthographic";
  eye: Vector;
  target: Vector;
  up: Vector;
  vertical_fov: number;
  orthographic_height: number;
  width: number;
  height: number;
}

/** Unit axes of a picture in space. */
export interface Axes { right: Vector; up: Vector; forward: Vector }

export function axesOf(camera: Camera): Axes {
  const forward = unit(difference(camera.target, camera.eye));
  const right = unit(cross(forward, camera.up));
  return { right, up: cross(right, forward), forward };
}

/** Edge of a pixel: mm, or for a perspective camera at distance 1 from the eye. */
export function pixelSize(camera: Camera): number {
  const height = camera.projection === "orthographic"
    ? camera.orthographic_height : 2 * Math.tan(camera.vertical_fov * Math.PI / 360);
  return height / camera.height;
}

/** A camera, and what its rays and projections have in common. */
export class CameraFrame {
  protected readonly axes: Axes;
  protected readonly size: number; // of a pixel, see pixelSize
  protected readonly isParallel: boolean;

  constructor(protected readonly camera: Camera) {
    this.axes = axesOf(camera);
    this.size = pixelSize(camera);
    this.isParallel = camera.projection === "orthographic";
  }
}

/** The ray through a point of the picture, px. */
export function rayOf(camera: Camera, x: number, y: number): { origin: Vector; direction: Vector } {
  const { right, up, forward } = axesOf(camera);
  const size = pixelSize(camera);
  const aside = sum(scaled(right, (x - camera.width / 2) * size), scaled(up, (camera.height / 2 - y) * size));
  return camera.projection === "orthographic"
    ? { origin: sum(camera.eye, aside), direction: forward }
    : { origin: camera.eye, direction: unit(sum(forward, aside)) };
}

/** Turns the eye about a point: about the vertical, and up or down short of it. */
export function orbited(camera: Camera, about: Vector, right: number, up: number): Camera {
  const vertical = unit(camera.up), axes = axesOf(camera);
  const steepest = 0.999;
  const level = dot(turned(axes.forward, axes.right, up), vertical);
  const raised = Math.abs(level) < steepest ? up : 0;
  const turn = (v: Vector): Vector => turned(turned(v, axes.right, raised), vertical, right);
  return {
    ...camera,
    eye: sum(about, turn(difference(camera.eye, about))),
    target: sum(about, turn(difference(camera.target, about))),
  };
}

/** Moves eye and target by pixels at the target's distance. */
export function panned(camera: Camera, x: number, y: number): Camera {
  const { right, up } = axesOf(camera);
  const far = camera.projection === "orthographic" ? 1 : length(difference(camera.target, camera.eye));
  const step = sum(scaled(right, -x * pixelSize(camera) * far), scaled(up, y * pixelSize(camera) * far));
  return { ...camera, eye: sum(camera.eye, step), target: sum(camera.target, step) };
}

/** Moves the eye towards the target, or away: `factor` of the distance is left. */
export function dollied(camera: Camera, factor: number): Camera {
  const away = scaled(difference(camera.eye, camera.target), factor);
  return {
    ...camera, eye: sum(camera.target, away),
    orthographic_height: camera.orthographic_height * factor,
  };
}

/** The camera looks at a place from where it looked before, `distance` mm away. */
export function lookingAt(camera: Camera, place: Vector, distance: number): Camera {
  const away = scaled(unit(difference(camera.eye, camera.target)), distance);
  return { ...camera, target: place, eye: sum(place, away) };
}

/** The camera with a picture of another size. */
export function sized(camera: Camera, width: number, height: number): Camera {
  return { ...camera, width, height };
}

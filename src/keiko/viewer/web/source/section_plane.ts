import { axesOf, Camera } from "./camera";
import { directionOf } from "./look_words";
import { cross, difference, dot, scaled, sum, turned, unit, Vector } from "./vector";

/** The points p with normal · p = height: a unit vector and mm. `facing`: the normal in words, "y" or "3,4,0". */
export interface SectionPlane { facing: string; normal: Vector; height: number }

export interface Bounds { lower: Vector; upper: Vector }

/** The names of the axes, and their directions. */
export const axes: Readonly<Record<string, Vector>> = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1] };

/** The words of a plane, which `keiko check --section` takes: "y=120.00" or "3,4,0=120.00". */
export const planeWords = ({ facing, height }: SectionPlane): string => `${facing}=${height.toFixed(2)}`;

/** The plane of some words; null for others. */
export function planeOf(words: string): SectionPlane | null {
  const [facing, at, ...more] = words.split("="), normal = axes[facing] ?? directionOf(facing), height = at?.trim() ? Number(at) : NaN;
  return normal && Number.isFinite(height) && more.length === 0 ? { facing, normal: unit(normal), height } : null;
}

/** The plane across an axis through the middle of a box. */
export function middlePlane(axis: string, bounds: Bounds): SectionPlane {
  const normal = axes[axis], [low, high] = heightsOf(bounds, normal);
  return { facing: axis, normal, height: (low + high) / 2 };
}

/** The least and the largest height of a box along a direction. */
export function heightsOf({ lower, upper }: Bounds, normal: Vector): [number, number] {
  const far = [0, 1, 2].map((k) => [lower[k] * normal[k], upper[k] * normal[k]]);
  return [far.reduce((all, ends) => all + Math.min(...ends), 0), far.reduce((all, ends) => all + Math.max(...ends), 0)];
}

/** The place of a plane that is nearest to the middle of a box. */
function pivotOf({ normal, height }: SectionPlane, { lower, upper }: Bounds): Vector {
  const middle = scaled(sum(lower, upper), 0.5);
  return sum(middle, scaled(normal, height - dot(normal, middle)));
}

/** The plane turned to a normal in words, about its place nearest to the middle of a box; null for no direction. */
export function facingPlane(plane: SectionPlane, facing: string, bounds: Bounds): SectionPlane | null {
  const faced = planeOf(`${facing}=0`);
  return faced && { ...faced, height: dot(faced.normal, pivotOf(plane, bounds)) };
}

/** The plane turned about the same place: to the right and down as an eye sees it, in radians. */
export function turnedPlane(plane: SectionPlane, camera: Camera, right: number, down: number, bounds: Bounds): SectionPlane {
  const seen = axesOf(camera), normal = turned(turned(plane.normal, seen.up, right), seen.right, down);
  return facingPlane(plane, normal.map((x) => String(Number(x.toFixed(4)))).join(","), bounds)!;
}

/** Where a plane cuts a box: the corners of a polygon in order; none if it misses it. */
export function outlineOf({ normal, height }: SectionPlane, { lower, upper }: Bounds): Vector[] {
  const corner = (i: number): Vector => [0, 1, 2].map((k) => (i >> k & 1 ? upper : lower)[k]) as Vector;
  const cuts: Vector[] = [];
  for (let i = 0; i < 8; ++i)
    for (const step of [1, 2, 4]) {
      if (i & step) continue;
      const from = corner(i), to = corner(i | step), a = dot(normal, from) - height, b = dot(normal, to) - height;
      if (a * b < 0) cuts.push(sum(scaled(from, b / (b - a)), scaled(to, a / (a - b))));
    }
  return inOrder(cuts, normal);
}

/** Corners of a convex polygon by their angle about its middle. */
function inOrder(corners: Vector[], normal: Vector): Vector[] {
  const middle = scaled(corners.reduce((a, b) => sum(a, b), [0, 0, 0]), 1 / corners.length);
  const aside = unit(Math.abs(normal[2]) < 0.9 ? [normal[1], -normal[0], 0] : [0, normal[2], -normal[1]]), across = cross(normal, aside);
  const angle = (corner: Vector): number => {
    const out = difference(corner, middle);
    return Math.atan2(dot(out, across), dot(out, aside));
  };
  return [...corners].sort((a, b) => angle(a) - angle(b));
}

import { Plane } from "./facts";
import { CurvatureKind } from "./look_words";
import { RowFrame } from "./row_frame";
import { Surface } from "./surface";
import { SurfaceBuffer } from "./surface_buffer";
import { difference, dot, scaled, sum, unit, Vector } from "./vector";
import { axesOf } from "./camera";

/** What is shown of a surface besides the lamps that it mirrors. */
export const surfaceLooks = ["zebra", "isophotes", "highlight lines", "curvature", "radius", "draft", "faces"] as const;
export type SurfaceLook = typeof surfaceLooks[number];

/** Scales of the looks. */
export interface LookScale {
  kind: CurvatureKind;   // that the look of curvature shows
  across: Vector;        // normal of the planes of its sections
  fullCurvature: number; // at which its colours are full
  radii: [number, number]; // mm, between which those of the radius change
  planes: Plane[];       // whose highlight lines are shown
}

type Rgb = readonly [number, number, number];
type Color = (path: number) => Rgb;

const degrees = 180 / Math.PI, draftLimit = 3, draftRange = 15; // degrees
const unknown: Rgb = [0.07, 0.07, 0.07], ground: Rgb = [0.5, 0.5, 0.5];

/** Colours of a look by path, 0 to 1, shaded by how far the surface faces the eye; those of `keiko render --look`. */
export function lookColors(look: SurfaceLook, buffer: SurfaceBuffer, scale: LookScale): Float32Array {
  const color = colorOf(look, buffer, scale), colors = new Float32Array(3 * buffer.paths);
  const facing = facingOf(buffer);
  for (let path = 0; path < buffer.paths; ++path) {
    const own = color(path), shade = 0.55 + 0.45 * facing(path);
    for (let k = 0; k < 3; ++k) colors[3 * path + k] = own[k] * shade;
  }
  return colors;
}

function colorOf(look: SurfaceLook, buffer: SurfaceBuffer, scale: LookScale): Color {
  switch (look) {
    case "zebra": return bands(buffer, zebraPhase(buffer));
    case "isophotes": return bands(buffer, (path) => 2 * angleToVertical(normalOf(buffer, path)) / 5);
    case "highlight lines": return bands(buffer, highlightPhase(buffer, scale.planes.map((plane) => new RowFrame(plane))));
    case "curvature": return curvatureColor(buffer, scale);
    case "radius": return radiusColor(buffer, scale);
    case "draft": return draftColor(buffer);
    case "faces": return (path) => faceColor(faceOf(buffer, path));
  }
}

const normalOf = ({ normals }: SurfaceBuffer, path: number): Vector => [normals[3 * path], normals[3 * path + 1], normals[3 * path + 2]];
const faceOf = ({ samples, pixels }: SurfaceBuffer, path: number): number => samples[8 * pixels[path] + 7];
const angleToVertical = (d: Vector): number => degrees * Math.atan2(Math.hypot(d[0], d[1]), d[2]);

function placeOf({ first: { numbers } }: SurfaceBuffer, path: number): Vector {
  return [numbers[18 * path], numbers[18 * path + 1], numbers[18 * path + 2]];
}

/** The unit direction from the eye to a path's surface. */
function viewOf(buffer: SurfaceBuffer): (path: number) => Vector {
  const { camera } = buffer, { forward } = axesOf(camera);
  return camera.projection === "orthographic" ? () => forward : (path) => unit(difference(placeOf(buffer, path), camera.eye));
}

function facingOf(buffer: SurfaceBuffer): (path: number) => number {
  const view = viewOf(buffer);
  return (path) => -dot(view(path), normalOf(buffer, path));
}

function zebraPhase({ first: { numbers } }: SurfaceBuffer): (path: number) => number {
  return (path) => 2 * angleToVertical([numbers[18 * path + 3], numbers[18 * path + 4], numbers[18 * path + 5]]) / 10;
}

/** Phase by where the normal meets the first plane that it faces, in pitches; NaN: none. */
function highlightPhase(buffer: SurfaceBuffer, rows: RowFrame[]): (path: number) => number {
  return (path) => {
    const place = placeOf(buffer, path), normal = normalOf(buffer, path);
    for (const row of rows) {
      const reach = dot(row.normal, difference(row.origin, place)) / dot(row.normal, normal);
      if (!(reach > 0 && Number.isFinite(reach) && row.pitch > 0)) continue;
      const at = sum(place, scaled(normal, reach));
      return 2 * (dot(row.v, difference(at, row.origin)) - row.first) / row.pitch + 0.5;
    }
    return NaN;
  };
}

/** Half of the range of values over a pixel, by the smaller change to the next pixel of the same face. */
function reachOf(buffer: SurfaceBuffer, values: Float64Array): (path: number) => number {
  const { pathOf, pixels, camera: { width }, rowStep } = buffer;
  const slope = (path: number, step: number): number => {
    let least = Infinity;
    for (const other of [pathOf[pixels[path] - step], pathOf[pixels[path] + step]])
      if (other >= 0 && faceOf(buffer, other) === faceOf(buffer, path)) {
        const change = Math.abs(values[other] - values[path]);
        if (change < least) least = change;
      }
    return least < Infinity ? least : 0;
  };
  return (path) => 0.5 * (slope(path, 1) + slope(path, width * rowStep) / rowStep);
}

/** Dark and light bands of a phase, each one unit wide, as the share of light in each pixel. */
function bands(buffer: SurfaceBuffer, phase: (path: number) => number): Color {
  const dark = 0.06, light = 0.94, values = Float64Array.from({ length: buffer.paths }, (_, path) => phase(path));
  const reach = reachOf(buffer, values);
  const lightUpTo = (x: number): number => {
    const whole = Math.floor(x / 2);
    return whole + Math.min(Math.max(x - 2 * whole - 1, 0), 1);
  };
  return (path) => {
    const x = values[path], r = Math.max(1e-6, 1e-12 * Math.abs(x), reach(path));
    const share = Number.isNaN(x) ? 0.5 : (lightUpTo(x + r) - lightUpTo(x - r)) / (2 * r), grey = dark + (light - dark) * share;
    return [grey, grey, grey];
  };
}

const mixed = (a: Rgb, b: Rgb, share: number): Rgb => {
  const t = Math.min(Math.max(share, 0), 1);
  return [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t, a[2] + (b[2] - a[2]) * t];
};

const signedStops: Rgb[] = [[0.02, 0.12, 0.55], [0.25, 0.55, 0.9], [0.87, 0.87, 0.87], [0.95, 0.5, 0.25], [0.6, 0.02, 0.05]];

/** A curvature as the eye sees it, positive in hollows: 1/mm, a Gaussian one 1/mm2; NaN where it is not known. */
export function curvatureOf({ kind, across }: Pick<LookScale, "kind" | "across">, surface: Surface): number {
  const [larger, smaller] = surface.principal;
  switch (kind) {
    case "mean": return surface.mean;
    case "gauss": return larger * smaller;
    case "k1": return larger;
    case "k2": return smaller;
    case "absolute": return Math.abs(larger) + Math.abs(smaller);
    case "section": return surface.along(unit(across));
  }
}

/** The larger principal curvature by size, 1/mm: the inverse of the smallest radius. */
export function sharpestOf({ principal: [larger, smaller] }: Surface): number {
  return Math.max(Math.abs(larger), Math.abs(smaller));
}

/** The colour of a share of the smallest radius' logarithmic scale, red where it is small. */
export const radiusColorAt = (share: number): Rgb => rainbow(1 - share);

/** The colour of a curvature as a share of that of full colour: between two signs, or of what has none those of a rainbow. */
export const curvatureColorAt = (kind: CurvatureKind): (share: number) => Rgb => kind === "absolute" ? rainbow : signedColor;

/** The smallest radius by colour; workflow/radius_picture. */
function radiusColor(buffer: SurfaceBuffer, { radii: [low, high] }: LookScale): Color {
  return (path) => {
    const surface = buffer.surfaceOf(path), k = sharpestOf(surface);
    if (surface.face < 0) return ground;
    if (Number.isNaN(k)) return unknown;
    return radiusColorAt(k > 0 ? Math.log(1 / k / low) / Math.log(high / low) : 1);
  };
}

function curvatureColor(buffer: SurfaceBuffer, { kind, across, fullCurvature }: LookScale): Color {
  const colorAt = curvatureColorAt(kind);
  return (path) => {
    const surface = buffer.surfaceOf(path);
    if (surface.face < 0 && kind === "absolute") return ground;
    const share = curvatureOf({ kind, across }, surface) / fullCurvature;
    return Number.isNaN(share) ? unknown : colorAt(share);
  };
}

function signedColor(share: number): Rgb {
  const at = 2 * (Math.min(Math.max(share, -1), 1) + 1), first = Math.min(3, Math.floor(at));
  return mixed(signedStops[first], signedStops[first + 1], at - first);
}

/** From blue by green to red; film/false_color. */
function rainbow(share: number): Rgb {
  const x = 4 * Math.min(Math.max(share, 0), 1), inside = (value: number): number => Math.min(Math.max(value, 0), 1);
  return [inside(x - 2), inside(Math.min(x, 4 - x)), inside(2 - x)];
}

/** Draft along z: blue from 3 degrees, yellow below, red undercut. */
function draftColor(buffer: SurfaceBuffer): Color {
  const steps = 8, floatAngle = 1e-4;
  const angles = Float64Array.from({ length: buffer.paths }, (_, path) => 90 - angleToVertical(normalOf(buffer, path)));
  const reach = reachOf(buffer, angles);
  const at = (angle: number): Rgb => {
    if (angle < -floatAngle) return mixed([0.98, 0.45, 0.32], [0.68, 0.02, 0.05], -angle / draftRange);
    if (angle < draftLimit - floatAngle) return [0.99, 0.84, 0.2];
    return mixed([0.6, 0.8, 0.95], [0.08, 0.27, 0.75], (angle - draftLimit) / (draftRange - draftLimit));
  };
  return (path) => {
    if (faceOf(buffer, path) < 0) return ground;
    const mean: [number, number, number] = [0, 0, 0], r = reach(path);
    for (let i = 0; i < steps; ++i) {
      const own = at(angles[path] + r * ((2 * i + 1) / steps - 1));
      for (let k = 0; k < 3; ++k) mean[k] += own[k] / steps;
    }
    return mean;
  };
}

/** Colours of faces: hues of consecutive numbers are far from each other. */
function faceColor(face: number): Rgb {
  if (face < 0) return ground;
  const golden = 0.61803398875, hue = face * golden % 1, value = 0.75 + 0.25 * (face * 7 % 4) / 3;
  const channel = (shift: number): number => value * (0.45 + 0.55 * Math.min(Math.max(Math.abs((hue + shift) % 1 * 6 - 3) - 1, 0), 1));
  return [channel(0), channel(2 / 3), channel(1 / 3)];
}

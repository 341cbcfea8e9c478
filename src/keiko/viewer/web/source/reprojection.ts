import { Camera, pixelSize } from "./camera";
import { Pass } from "./deep_buffer";
import { Projection } from "./projection";
import { SurfaceBuffer } from "./surface_buffer";
import { difference, length, unit, Vector } from "./vector";

const numbersOfSample = 8, sameSurface = 1e-3; // of the distance

/**
 * The surfaces in hand as another eye has them, for the time until its own are there. Places, normals and curvature are
 * those of the surface; each is drawn as a square large enough to close the gaps between. What the first eye did not
 * see is missing.
 */
export function reprojected(from: SurfaceBuffer, camera: Camera): Pass {
  const { width, height } = camera, samples = new Float32Array(numbersOfSample * width * height);
  for (let at = 0; at < samples.length; at += numbersOfSample) samples[at] = Infinity;
  const projection = new SurfaceProjection(camera), side = squareOf(from, camera);
  const { first: { numbers } } = from;
  for (let path = 0; path < from.paths; ++path) {
    projection.set(numbers, 18 * path);
    const { x, y, depth } = projection;
    if (!(depth > 0)) continue;
    const left = Math.floor(x - 0.5 * (side - 1)), top = Math.floor(y - 0.5 * (side - 1));
    for (let row = Math.max(top, 0); row < Math.min(top + side, height); ++row)
      for (let column = Math.max(left, 0); column < Math.min(left + side, width); ++column)
        put(samples, numbersOfSample * (row * width + column), projection, from, path, column, row);
  }
  return { width, height, first: 0, step: 1, samples, bounces: new DataView(new ArrayBuffer(0)) };
}

/** Pixels of a side of the squares, so that neighbours' squares meet. */
function squareOf(from: SurfaceBuffer, camera: Camera): number {
  const far = (c: Camera): number => c.projection === "orthographic" ? 1 : length(difference(c.eye, c.target));
  const scale = pixelSize(from.camera) * far(from.camera) / (pixelSize(camera) * far(camera)) * Math.min(from.rowStep, 2);
  return scale < 0.75 ? 1 : Math.min(8, Math.ceil(1.3 * scale));
}

/** Writes a sample where nothing nearer is: its surface met by that pixel's own ray, in its tangent plane. */
function put(samples: Float32Array, at: number, projection: SurfaceProjection, from: SurfaceBuffer, path: number, x: number, y: number): void {
  const { normals, samples: own, pixels } = from, n = 3 * path, source = numbersOfSample * pixels[path];
  const t = projection.along(x + 0.5, y + 0.5, normals[n], normals[n + 1], normals[n + 2]);
  if (!(t > 0 && t < (1 - sameSurface) * samples[at])) return;
  for (let k = 1; k < numbersOfSample; ++k) samples[at + k] = own[source + k];
  samples[at] = t;
  projection.turnNormal(from, path, x + 0.5, y + 0.5, t, samples, at);
}

/** Where a place of a surface is in a camera's picture, and what rays beside it meet there. */
class SurfaceProjection extends Projection {
  private readonly place: Vector = [0, 0, 0];
  private readonly origin: Vector = [0, 0, 0];
  private readonly ray: Vector = [0, 0, 0];

  override set(numbers: ArrayLike<number>, at = 0): boolean {
    for (let k = 0; k < 3; ++k) this.place[k] = numbers[at + k];
    return super.set(numbers, at);
  }

  /** t at which the ray through a point of the picture meets the plane through the place with a normal. */
  along(x: number, y: number, nx: number, ny: number, nz: number): number {
    this.setRay(x, y);
    const { origin: o, ray: d, place: p } = this, towards = nx * d[0] + ny * d[1] + nz * d[2];
    return towards < -0.02 ? (nx * (p[0] - o[0]) + ny * (p[1] - o[1]) + nz * (p[2] - o[2])) / towards : -1;
  }

  private setRay(x: number, y: number): void {
    const { camera: { eye, width, height }, axes: { right, up, forward }, origin, ray, size, isParallel } = this;
    const across = (x - 0.5 * width) * size, rise = (0.5 * height - y) * size;
    let square = 0;
    for (let k = 0; k < 3; ++k) {
      const aside = right[k] * across + up[k] * rise;
      origin[k] = eye[k] + (isParallel ? aside : 0);
      ray[k] = forward[k] + (isParallel ? 0 : aside);
      square += ray[k] * ray[k];
    }
    for (let k = 0, perLength = 1 / Math.sqrt(square); k < 3; ++k) ray[k] *= perLength;
  }

  /** Turns the normal of a sample by the surface's curvature over the way from the place to the ray's end. */
  turnNormal(from: SurfaceBuffer, path: number, x: number, y: number, t: number, samples: Float32Array, at: number): void {
    this.setRay(x, y);
    const surface = from.surfaceOf(path), { origin: o, ray: d, place: p } = this;
    if (surface.isPoint) return;
    for (let k = 0; k < 3; ++k) step[k] = o[k] + t * d[k] - p[k];
    surface.turn(step, 0, change);
    const n = unit([surface.normal[0] + change[0], surface.normal[1] + change[1], surface.normal[2] + change[2]]);
    const sum = Math.abs(n[0]) + Math.abs(n[1]) + Math.abs(n[2]), q = n[0] / sum, r = n[1] / sum;
    const isLower = n[2] < 0, wasLower = surface.normal[2] < 0;
    // The axes of the curvature turn with the octahedron's halves: across the equator the normal stays.
    if (isLower !== wasLower) return;
    samples[at + 1] = isLower ? (1 - Math.abs(r)) * Math.sign(q || 1) : q;
    samples[at + 2] = isLower ? (1 - Math.abs(q)) * Math.sign(r || 1) : r;
  }
}

const step = new Float64Array(3), change = new Float64Array(3);

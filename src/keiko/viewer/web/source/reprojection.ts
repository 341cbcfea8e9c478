import { Camera, CameraFrame, pixelSize } from "./camera";
import { Pass } from "./deep_buffer";
import { Projection } from "./projection";
import { SurfaceBuffer } from "./surface_buffer";
import { difference, length } from "./vector";

const numbersOfSample = 8, numbersOfRay = 18;

/**
 * The surfaces in hand as another eye has them, for the time until its own are there. Places, normals and curvature are
 * those of the surface; each is drawn as a square large enough to close the gaps between. What the first eye did not
 * see is missing. The next call uses the memory of the pass again.
 */
export class Reprojection {
  private paths = new Int32Array(0);
  private depths = new Float32Array(0);
  private samples = new Float32Array(0);

  pass(from: SurfaceBuffer, camera: Camera): Pass {
    const { width, height } = camera, moved = new MovedSurface(from, camera);
    if (this.paths.length !== width * height) this.reserve(width * height);
    const { paths, depths, samples } = this;
    paths.fill(-1), depths.fill(Infinity);
    new NearestPaths(from, camera, paths, depths).addAll();
    for (let y = 0, pixel = 0; y < height; ++y)
      for (let x = 0; x < width; ++x, ++pixel) {
        if (paths[pixel] < 0) samples[numbersOfSample * pixel] = Infinity;
        else moved.write(paths[pixel], x, y, samples, numbersOfSample * pixel);
      }
    return { width, height, first: 0, step: 1, samples, bounces: new DataView(new ArrayBuffer(0)) };
  }

  private reserve(pixels: number): void {
    this.paths = new Int32Array(pixels), this.depths = new Float32Array(pixels);
    this.samples = new Float32Array(numbersOfSample * pixels);
  }
}

/** Size of the first eye's pixels in those of another eye's picture, at the target. */
function scaleOf(from: SurfaceBuffer, camera: Camera): number {
  const far = (c: Camera): number => c.projection === "orthographic" ? 1 : length(difference(c.eye, c.target));
  return pixelSize(from.camera) * far(from.camera) / (pixelSize(camera) * far(camera)) * Math.min(from.rowStep, 2);
}

/** Which path's square is nearest in each pixel of an eye's picture. */
class NearestPaths extends Projection {
  private readonly side: number; // px of the squares, so that neighbours' squares meet
  private readonly step: number; // from one path to the next that is drawn: pixels hold many small ones

  /** `paths`: by pixel, -1: none; `depths`: of the surface on the pixel's ray, mm along the eye's direction. */
  constructor(private readonly from: SurfaceBuffer, camera: Camera, private readonly paths: Int32Array,
    private readonly depths: Float32Array) {
    super(camera);
    const scale = scaleOf(from, camera);
    this.side = scale < 0.75 ? 1 : Math.min(8, Math.ceil(1.3 * scale));
    this.step = Math.max(1, Math.floor(0.5 / scale));
  }

  addAll(): void {
    for (let path = 0; path < this.from.paths; path += this.step) this.add(path);
  }

  private add(path: number): void {
    if (!this.set(this.from.first.numbers, numbersOfRay * path)) return;
    const { camera: { width, height }, side } = this;
    const left = Math.floor(this.x - 0.5 * (side - 1)), top = Math.floor(this.y - 0.5 * (side - 1));
    const right = Math.min(left + side, width), bottom = Math.min(top + side, height);
    if (left < right && top < bottom) this.fill(path, Math.max(left, 0), Math.max(top, 0), right, bottom);
  }

  /** Puts a path into pixels where it is nearest: its tangent plane is met by each pixel's own ray. */
  private fill(path: number, left: number, top: number, right: number, bottom: number): void {
    const { camera: { eye, width, height }, axes: { right: r, up: u, forward: f }, size, isParallel, paths, depths } = this;
    const { normals, first: { numbers } } = this.from, n = 3 * path, p = numbersOfRay * path;
    const nx = normals[n], ny = normals[n + 1], nz = normals[n + 2];
    const ahead = nx * f[0] + ny * f[1] + nz * f[2];
    const aside = nx * r[0] + ny * r[1] + nz * r[2], upward = nx * u[0] + ny * u[1] + nz * u[2];
    const away = nx * (numbers[p] - eye[0]) + ny * (numbers[p + 1] - eye[1]) + nz * (numbers[p + 2] - eye[2]);
    const sameSurface = 1 - 1e-3; // of the distance
    for (let y = top; y < bottom; ++y)
      for (let x = left; x < right; ++x) {
        const across = (x + 0.5 - 0.5 * width) * size, rise = (0.5 * height - y - 0.5) * size, sideways = aside * across + upward * rise;
        const towards = isParallel ? ahead : ahead + sideways, depth = (isParallel ? away - sideways : away) / towards;
        const lowest = -0.02 * (isParallel ? 1 : Math.sqrt(1 + across * across + rise * rise)), pixel = y * width + x;
        if (towards < lowest && depth > 0 && depth < sameSurface * depths[pixel]) depths[pixel] = depth, paths[pixel] = path;
      }
  }
}

/** Samples of surfaces as the pixels of another eye's picture have them. */
class MovedSurface extends CameraFrame {
  private readonly origin = new Float64Array(3);
  private readonly ray = new Float64Array(3);

  constructor(private readonly from: SurfaceBuffer, camera: Camera) {
    super(camera);
  }

  /** Writes the sample where a pixel's ray meets the tangent plane of a path's surface. */
  write(path: number, x: number, y: number, samples: Float32Array, at: number): void {
    const { from: { normals, samples: own, pixels, first: { numbers } }, origin: o, ray: d } = this;
    const n = 3 * path, p = numbersOfRay * path, source = numbersOfSample * pixels[path];
    this.setRay(x + 0.5, y + 0.5);
    let towards = 0, away = 0;
    for (let k = 0; k < 3; ++k) towards += normals[n + k] * d[k], away += normals[n + k] * (numbers[p + k] - o[k]);
    const t = samples[at] = away / towards;
    for (let k = 1; k < numbersOfSample; ++k) samples[at + k] = own[source + k];
    for (let k = 0; k < 3; ++k) step[k] = o[k] + t * d[k] - numbers[p + k];
    this.turnNormal(path, samples, at);
  }

  private setRay(x: number, y: number): void {
    const { camera: { eye, width, height }, axes: { right, up, forward }, origin, ray, size, isParallel } = this;
    const across = (x - 0.5 * width) * size, rise = (0.5 * height - y) * size;
    const perLength = isParallel ? 1 : 1 / Math.sqrt(1 + across * across + rise * rise);
    for (let k = 0; k < 3; ++k) {
      const aside = right[k] * across + up[k] * rise;
      origin[k] = eye[k] + (isParallel ? aside : 0);
      ray[k] = (forward[k] + (isParallel ? 0 : aside)) * perLength;
    }
  }

  /** Turns the normal of a sample by the surface's curvature over `step`. */
  private turnNormal(path: number, samples: Float32Array, at: number): void {
    const surface = this.from.surfaceOf(path), { normal } = surface;
    if (surface.isPoint) return;
    surface.turn(step, 0, change);
    const a = normal[0] + change[0], b = normal[1] + change[1], c = normal[2] + change[2];
    const isLower = c < 0, sum = Math.abs(a) + Math.abs(b) + Math.abs(c), q = a / sum, r = b / sum;
    // The axes of the curvature turn with the octahedron's halves: across the equator the normal stays.
    if (isLower !== normal[2] < 0) return;
    samples[at + 1] = isLower ? (1 - Math.abs(r)) * (q < 0 ? -1 : 1) : q;
    samples[at + 2] = isLower ? (1 - Math.abs(q)) * (r < 0 ? -1 : 1) : r;
  }
}

const step = new Float64Array(3), change = new Float64Array(3);

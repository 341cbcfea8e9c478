import { Camera } from "./camera";
import { Pass } from "./deep_buffer";
import { Mirrors } from "./fresnel";
import { CameraRays, cosineAt, narrow, rayNumbers, reflect } from "./ray";
import { grown, RayList } from "./ray_list";
import { Surface } from "./surface";

const numbersOfSample = 8, wordsOfBounce = 9;

/**
 * The surfaces of a picture as far as they have come, and the rays that they reflect. A path is what one pixel's camera
 * ray does; paths are numbered as they come. Lamps are looked up on `first`, the rays after the first reflection, by
 * path, and on `later`.
 */
export class SurfaceBuffer {
  readonly samples: Float32Array;
  readonly pathOf: Int32Array; // by pixel; -1: no surface
  readonly first = new RayList();
  readonly later = new RayList();
  pixels = new Uint32Array(1);     // by path
  normals = new Float32Array(3);   // by path
  laterCounts = new Uint32Array(1); // by path: reflections in `later`
  laterFirst = new Uint32Array(1);  // by path: the first of them
  pathOfLater = new Uint32Array(1); // by ray of `later`
  rowStep: number;
  private readonly rays: CameraRays;
  private readonly ray = new Float64Array(rayNumbers);
  private readonly weight = new Float64Array(3);
  private readonly surface = new Surface();
  private joins: Uint8Array | null = null; // by pixel: 1 right, 2 down

  /** `spent`: a buffer whose memory it may take over, since nobody uses that one any more. */
  constructor(readonly camera: Camera, private readonly mirrors: Mirrors, spent: SurfaceBuffer | null = null) {
    const size = camera.width * camera.height, isSame = spent?.pathOf.length === size;
    this.samples = isSame ? spent!.samples : new Float32Array(numbersOfSample * size);
    this.pathOf = (isSame ? spent!.pathOf : new Int32Array(size)).fill(-1);
    if (spent) this.takeOver(spent);
    this.rays = new CameraRays(camera);
    this.rowStep = camera.height;
  }

  private takeOver(spent: SurfaceBuffer): void {
    this.first.takeOver(spent.first), this.later.takeOver(spent.later);
    this.pixels = spent.pixels, this.normals = spent.normals, this.pathOfLater = spent.pathOfLater;
    this.laterCounts = spent.laterCounts, this.laterFirst = spent.laterFirst;
  }

  get paths(): number {
    return this.first.count;
  }

  /** Takes rows of the picture, which were not there before. */
  add(pass: Pass): void {
    const { width } = this.camera, bounces = new Float32Array(pass.bounces.buffer, pass.bounces.byteOffset, pass.bounces.byteLength / 4);
    const owners = new Uint32Array(bounces.buffer, bounces.byteOffset, bounces.length);
    let next = 0;
    this.reserve(pass.samples);
    for (let row = 0; row * width * numbersOfSample < pass.samples.length; ++row) {
      const y = pass.first + row * pass.step, at = row * width * numbersOfSample;
      this.samples.set(pass.samples.subarray(at, at + width * numbersOfSample), y * width * numbersOfSample);
      for (let x = 0; x < width; ++x) {
        const pixel = y * width + x;
        if (!Number.isFinite(this.samples[numbersOfSample * pixel])) continue;
        this.begin(x, y, pixel);
        for (; owners[next] === pixel && next < owners.length; next += wordsOfBounce) this.bounce(bounces, next + 1);
      }
    }
    this.rowStep = pass.first === 0 ? pass.step : Math.min(this.rowStep, pass.first);
    this.joins = null;
  }

  /** Makes room for the paths of samples. */
  private reserve(samples: Float32Array): void {
    let paths = this.paths;
    for (let at = 0; at < samples.length; at += numbersOfSample) if (Number.isFinite(samples[at])) ++paths;
    this.first.reserve(paths);
    this.pixels = grown(this.pixels, paths);
    this.normals = grown(this.normals, 3 * paths);
    this.laterCounts = grown(this.laterCounts, paths);
    this.laterFirst = grown(this.laterFirst, paths);
  }

  /** Begins the path of a pixel by its first reflection. */
  private begin(x: number, y: number, pixel: number): void {
    const { ray, weight, surface, mirrors } = this, path = this.paths;
    surface.read(this.samples, numbersOfSample * pixel);
    this.rays.set(ray, x, y);
    weight.fill(1);
    mirrors.weigh(weight, surface.face, cosineAt(ray, surface));
    reflect(ray, surface);
    if (surface.isPoint) narrow(ray);
    this.first.add(ray, surface.way, weight);
    this.pixels[path] = pixel, this.laterCounts[path] = 0, this.laterFirst[path] = this.later.count;
    for (let k = 0; k < 3; ++k) this.normals[3 * path + k] = surface.normal[k];
    this.pathOf[pixel] = path;
  }

  /** Goes on along the last path, to the surface of a bounce. */
  private bounce(numbers: Float32Array, at: number): void {
    const { ray, weight, surface, mirrors } = this;
    surface.read(numbers, at);
    mirrors.weigh(weight, surface.face, cosineAt(ray, surface));
    reflect(ray, surface);
    if (surface.isPoint) narrow(ray);
    this.pathOfLater = grown(this.pathOfLater, this.later.count + 1);
    this.pathOfLater[this.later.count] = this.paths - 1;
    this.later.add(ray, surface.way, weight);
    ++this.laterCounts[this.paths - 1];
  }

  /** The surface of a path, which the next call changes. */
  surfaceOf(path: number): Surface {
    this.surface.read(this.samples, numbersOfSample * this.pixels[path]);
    return this.surface;
  }

  /** True if all four neighbours of a path's pixel show the same smooth surface. */
  isAmid(path: number): boolean {
    this.joins ??= this.joined();
    const { width, height } = this.camera, pixel = this.pixels[path], x = pixel % width;
    if (x === 0 || x === width - 1 || pixel < width || pixel >= width * (height - 1)) return false;
    return (this.joins[pixel] & this.joins[pixel - 1] & 1) === 1 && (this.joins[pixel] & this.joins[pixel - width] & 2) === 2;
  }

  private joined(): Uint8Array {
    const { width } = this.camera, joins = new Uint8Array(this.pathOf.length);
    for (let path = 0; path < this.paths; ++path) {
      const pixel = this.pixels[path];
      if (this.continues(path, this.pathOf[pixel + 1])) joins[pixel] |= 1;
      if (pixel + width < joins.length && this.continues(path, this.pathOf[pixel + width])) joins[pixel] |= 2;
    }
    return joins;
  }

  /** True if two paths begin on one smooth surface; the rule of render/reflection/shading_point. */
  private continues(a: number, b: number | undefined): boolean {
    if (b === undefined || b < 0) return false;
    const face = (path: number): number => this.samples[numbersOfSample * this.pixels[path] + 7];
    const isPoint = (path: number): boolean => Number.isNaN(this.samples[numbersOfSample * this.pixels[path] + 3]);
    if (isPoint(a) || isPoint(b) || this.mirrors.material(face(a)) !== this.mirrors.material(face(b))) return false;
    const { normals: n, first: { numbers: r } } = this, i = 3 * a, j = 3 * b, p = rayNumbers * a, q = rayNumbers * b;
    const along = n[i] * n[j] + n[i + 1] * n[j + 1] + n[i + 2] * n[j + 2];
    const cx = n[i + 1] * n[j + 2] - n[i + 2] * n[j + 1], cy = n[i + 2] * n[j] - n[i] * n[j + 2];
    const cz = n[i] * n[j + 1] - n[i + 1] * n[j], widest = 0.031091204;
    if (!(cx * cx + cy * cy + cz * cz <= widest * along * along)) return false;
    const sx = r[q] - r[p], sy = r[q + 1] - r[p + 1], sz = r[q + 2] - r[p + 2];
    const off = Math.min(Math.abs(sx * n[i] + sy * n[i + 1] + sz * n[i + 2]), Math.abs(sx * n[j] + sy * n[j + 1] + sz * n[j + 2]));
    return off * off <= 0.04 * (sx * sx + sy * sy + sz * sz);
  }
}

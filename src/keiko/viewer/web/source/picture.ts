import { Camera, rayOf } from "./camera";
import { Facts, Plane } from "./facts";
import { Mirrors } from "./fresnel";
import { LampLight } from "./lamp_light";
import { curvatureOf, lookColors, sharpestOf, SurfaceLook, surfaceLooks } from "./look_colors";
import { CurvatureKind, StatedLook } from "./look_words";
import { rayNumbers } from "./ray";
import { RowFrame } from "./row_frame";
import { SurfaceBuffer } from "./surface_buffer";
import { Sight } from "./sight";
import { Surface } from "./surface";
import { scaled, sum, Vector } from "./vector";

export const looks = ["lamps", ...surfaceLooks] as const;
export type Look = "lamps" | SurfaceLook;

/** How a picture is shown. */
export interface Display {
  look: Look;
  kind: CurvatureKind;   // that the look of curvature shows
  across: Vector;        // normal of the planes of its sections
  planes: Plane[];
  white: number;         // cd/m2 that is shown as white
  fullCurvature: number; // 1/mm, of a Gaussian one 1/mm2, at which colours are full
  radii: [number, number]; // mm, between which colours of the radius change
}

/** A surface at a pixel's centre. */
export interface Picked {
  camera: Camera;
  pixel: [number, number]; // of the camera's picture: the centre of one
  place: Vector;
  normal: Vector;
  radii: [number, number];
  face: number;
}

const srgb = (c: number): number => c <= 0.0031308 ? 12.92 * c : 1.055 * c ** (1 / 2.4) - 0.055;

// Bytes by luminance in steps fine enough for the steepest part of the curve.
const byteSteps = 1 << 16;
const bytes = Uint8Array.from({ length: byteSteps + 1 }, (_, i) => Math.round(255 * srgb(i / byteSteps)));
const byteOf = (share: number): number => bytes[share >= 1 ? byteSteps : share > 0 ? Math.round(byteSteps * share) : 0];

const word = (r: number, g: number, b: number): number => (0xff000000 | b << 16 | g << 8 | r) >>> 0;

/** Draws a deep buffer on a canvas, by the processor. */
export class Picture {
  private readonly context: CanvasRenderingContext2D;
  private readonly mirrors: Mirrors;
  private readonly lamps: LampLight;
  private buffer: SurfaceBuffer | null = null;
  private shown = "";
  private shownBuffer: SurfaceBuffer | null = null;
  private image = new ImageData(1, 1);
  private words = new Uint32Array(this.image.data.buffer); // of the image, one a pixel

  constructor(private readonly canvas: HTMLCanvasElement, private readonly facts: Facts) {
    this.context = canvas.getContext("2d", { alpha: false, willReadFrequently: true })!;
    this.mirrors = new Mirrors(facts);
    this.lamps = new LampLight(facts);
  }

  /** An empty buffer for a camera's picture, in the memory of one that is not used any more. */
  bufferFor(camera: Camera, spent: SurfaceBuffer | null = null): SurfaceBuffer {
    return new SurfaceBuffer(camera, this.mirrors, spent);
  }

  /** Takes the buffer that is shown from now on. */
  show(buffer: SurfaceBuffer): void {
    this.buffer = buffer;
  }

  /** Draws the buffer in hand; false without one. */
  draw(display: Display): boolean {
    const { buffer } = this;
    if (!buffer) return false;
    this.size(buffer.camera);
    if (display.look === "lamps") this.drawLamps(display, buffer);
    else this.drawLook(display.look, display, buffer);
    this.repeatRows(buffer);
    this.context.putImageData(this.image, 0, 0);
    return true;
  }

  /** Forgets how rows of lamps were dragged: the next drawing is that of a new picture. */
  renew(): void {
    this.lamps.renew();
  }

  /** Divides pixels whose image of the lamps is bent, for some milliseconds; false if there are more. */
  refine(display: Display, milliseconds: number): boolean {
    if (!this.buffer || display.look !== "lamps" || this.buffer.rowStep > 1) return true;
    const isDone = this.lamps.refine(milliseconds);
    this.writeChanged(display.white);
    this.context.putImageData(this.image, 0, 0);
    return isDone;
  }

  /** Luminance, cd/m2, that 1 % of the body's picture exceeds as it was drawn: white in a still. */
  whiteOf(): number {
    const { buffer } = this;
    if (!buffer) return 1;
    const light = this.lamps.luminance, values = new Float64Array(buffer.paths);
    for (let path = 0; path < buffer.paths; ++path)
      values[path] = 0.2126 * light[3 * path] + 0.7152 * light[3 * path + 1] + 0.0722 * light[3 * path + 2];
    return quantile(values, 0.99) || 1;
  }

  /** The round curvature of a look that 2 % of the body's picture exceed. */
  usualCurvature(look: StatedLook): number {
    const sizes = this.bodyValues((surface) => Math.abs(curvatureOf(look, surface)));
    return roundUp(quantile(Float64Array.from(sizes), 0.98) || 1e-3);
  }

  /** Round radii, mm, between which lie all but 2 % of the body's picture on either side; workflow/radius_picture. */
  usualRadii(): [number, number] {
    const flat = 1e6; // mm: larger ones have no part
    const radii = Float64Array.from(this.bodyValues(sharpestOf).filter((k) => k * flat > 1), (k) => 1 / k);
    if (radii.length === 0) return [1, 1000];
    const low = 1 / roundUp(1 / quantile(radii, 0.02));
    return [low, Math.max(roundUp(quantile(radii, 0.98)), 10 * low)];
  }

  /** A value of each path that sees the body, where it is known. */
  private bodyValues(value: (surface: Surface) => number): number[] {
    const { buffer } = this, values: number[] = [];
    for (let path = 0; buffer && path < buffer.paths; ++path) {
      const surface = buffer.surfaceOf(path), known = surface.face > 0 ? value(surface) : NaN;
      if (!Number.isNaN(known)) values.push(known);
    }
    return values;
  }

  /** The path of a pixel, or of the nearest above that is there; -1 without one. */
  private pathAt(x: number, y: number): number {
    const { buffer } = this;
    return buffer?.pathOf[Math.floor(y / buffer.rowStep) * buffer.rowStep * buffer.camera.width + x] ?? -1;
  }

  /** What the buffer in hand sees; null without one. */
  sight(): Sight | null {
    return this.buffer && new Sight(this.buffer);
  }

  /** The nearest row of lamps whose plane the first reflection at a pixel meets; -1 without one. */
  rowAt(x: number, y: number, planes: Plane[]): number {
    const ray = this.reflectionAt(x, y);
    if (!ray) return -1;
    const distances = planes.map((plane) => new RowFrame(plane).distanceTo(ray.origin, ray.direction));
    const nearest = Math.min(...distances);
    return nearest < Infinity ? distances.indexOf(nearest) : -1;
  }

  /** Where the first reflection at a pixel meets the plane of a row, even beyond its lamps; null if it does not. */
  mirroredOn(x: number, y: number, plane: Plane): Vector | null {
    const ray = this.reflectionAt(x, y), away = ray ? new RowFrame(plane).distanceToPlane(ray.origin, ray.direction) : -1;
    return ray && away > 0 ? sum(ray.origin, scaled(ray.direction, away)) : null;
  }

  /** The first reflected ray at a pixel. */
  private reflectionAt(x: number, y: number): { origin: Vector; direction: Vector } | null {
    const path = this.pathAt(x, y), ray = this.buffer?.first.numbers, at = rayNumbers * path;
    if (!ray || path < 0) return null;
    return { origin: [ray[at], ray[at + 1], ray[at + 2]], direction: [ray[at + 3], ray[at + 4], ray[at + 5]] };
  }

  /** The surface at a pixel, if there is one. */
  pick(x: number, y: number): Picked | null {
    const { buffer } = this, path = this.pathAt(x, y);
    if (!buffer || path < 0) return null;
    const { t, normal, face, principal: [k1, k2] } = buffer.surfaceOf(path);
    const pixel: [number, number] = [x + 0.5, y + 0.5], { origin, direction } = rayOf(buffer.camera, ...pixel);
    return {
      camera: buffer.camera, pixel, place: sum(origin, scaled(direction, t)), normal: [...normal] as Vector, radii: [1 / k1, 1 / k2], face,
    };
  }

  private size({ width, height }: Camera): void {
    if (this.canvas.width !== width || this.canvas.height !== height) this.canvas.width = width, this.canvas.height = height;
    if (this.image.width === width && this.image.height === height) return;
    this.image = new ImageData(width, height);
    this.words = new Uint32Array(this.image.data.buffer);
  }

  private drawLamps({ planes, white }: Display, buffer: SurfaceBuffer): void {
    this.lamps.set(buffer, planes);
    this.lamps.update();
    const shown = `lamps ${white} ${buffer.rowStep}`; // rows that come later were shown by those above
    if (this.shown === shown && this.shownBuffer === buffer) return this.writeChanged(white);
    this.shown = shown, this.shownBuffer = buffer;
    const { words } = this, [r, g, b] = this.facts.background.map((light) => byteOf(light / white));
    words.fill(word(r, g, b));
    for (let path = 0; path < buffer.paths; ++path) this.write(path, 1 / white);
  }

  /** Writes the light of the paths that the last update of the lamps changed. */
  private writeChanged(white: number): void {
    const { list, count } = this.lamps.changed;
    for (let i = 0; i < count; ++i) this.write(list[i], 1 / white);
  }

  private write(path: number, perWhite: number): void {
    const light = this.lamps.luminance, at = 3 * path;
    this.words[this.buffer!.pixels[path]] = word(byteOf(light[at] * perWhite), byteOf(light[at + 1] * perWhite), byteOf(light[at + 2] * perWhite));
  }

  private drawLook(look: SurfaceLook, display: Display, buffer: SurfaceBuffer): void {
    const colors = lookColors(look, buffer, display), byte = (share: number): number => Math.round(255 * Math.min(share, 1)), none = byte(0.07);
    this.shown = look;
    this.words.fill(word(none, none, none));
    for (let path = 0, at = 0; path < buffer.paths; ++path, at += 3)
      this.words[buffer.pixels[path]] = word(byte(colors[at]), byte(colors[at + 1]), byte(colors[at + 2]));
  }

  /** Shows rows that are not there yet by the nearest above. */
  private repeatRows({ rowStep, camera: { width, height } }: SurfaceBuffer): void {
    for (let y = 0; y < height; ++y)
      if (y % rowStep !== 0) this.words.copyWithin(y * width, (y - y % rowStep) * width, (y - y % rowStep + 1) * width);
  }
}

/** The round number, 1, 2 or 5 times a power of ten, at or above a positive value. */
function roundUp(value: number): number {
  const power = 10 ** Math.floor(Math.log10(value));
  return Number((power * ([1, 2, 5].find((step) => value <= step * power * (1 + 1e-9)) ?? 10)).toPrecision(1));
}

/** The value that a share of the values does not exceed; 0 without any. */
function quantile(values: Float64Array, share: number): number {
  return values.sort()[Math.round(share * (values.length - 1))] ?? 0;
}

import { axesOf, Camera, pixelSize } from "./camera";
import { bounceBytes, Pass } from "./deep_buffer";
import { Facts, Material, Plane } from "./facts";
import { bouncesARow, facesARow, fragmentShader, mostPlanes, vertexShader } from "./shader";
import { cross, difference, dot, length, scaled, unit, Vector } from "./vector";

export const looks = ["lamps", "zebra", "curvature"] as const;
export type Look = typeof looks[number];

/** How a picture is shown. */
export interface Display {
  look: Look;
  planes: Plane[];
  white: number;         // cd/m2 that is shown as white; 0: luminance is written as it is
  fullCurvature: number; // 1/mm at which colours are full
  isHurried: boolean;    // something moves: pixels whose image is bent are not divided
}

/** A surface at a pixel's centre. */
export interface Picked { t: number; normal: Vector; radii: [number, number]; face: number }

/** A shader program, and the places of its uniforms. */
interface Program { linked: WebGLProgram; places: Map<string, WebGLUniformLocation | null> }

const textureNames = ["samples", "bounces", "materials", "first_bounce", "material_of_face"];

/** Draws a deep buffer by one triangle over the canvas. */
export class Picture {
  private readonly gl: WebGL2RenderingContext;
  private readonly programs = new Map<string, Program>();
  private program: Program;
  private readonly textures: Record<string, WebGLTexture> = {};
  private samples = new Float32Array(0);
  private chains = new Uint32Array(0);
  private bounces = new Float32Array(8 * bouncesARow);
  private bounceCount = 0;
  private rowStep = 1;
  private camera: Camera | null = null;

  constructor(private readonly canvas: HTMLCanvasElement, private readonly facts: Facts) {
    const gl = canvas.getContext("webgl2", { antialias: false, preserveDrawingBuffer: true });
    if (!gl) throw new Error("this browser has no WebGL 2");
    this.gl = gl;
    gl.getExtension("EXT_color_buffer_float");
    textureNames.forEach((name, unit) => {
      this.textures[name] = gl.createTexture()!;
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, this.textures[name]);
      for (const side of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, side, gl.NEAREST);
    });
    this.setMaterials(facts);
    this.program = this.use("lamps", false, 0);
  }

  /** Takes the first pass of a camera's picture, or one that refines it. */
  add(pass: Pass, camera: Camera, isFirst: boolean): void {
    if (isFirst) this.begin(camera);
    const { gl } = this, numbers = 8 * pass.width;
    this.bind("samples");
    for (let row = 0; row * numbers < pass.samples.length; ++row) {
      const y = pass.first + row * pass.step, part = pass.samples.subarray(row * numbers, (row + 1) * numbers);
      this.samples.set(part, y * numbers);
      gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, y, 2 * pass.width, 1, gl.RGBA, gl.FLOAT, part);
    }
    this.addBounces(pass);
    this.rowStep = pass.first === 0 ? pass.step : Math.min(this.rowStep, pass.first);
  }

  /** Draws the buffer in hand, or every stride-th pixel of it; false without one. */
  draw(display: Display, stride = 1): boolean {
    const { gl, camera } = this;
    if (!camera) return false;
    gl.viewport(0, 0, Math.ceil(camera.width / stride), Math.ceil(camera.height / stride));
    this.program = this.use(display.look, display.isHurried, display.planes.length);
    gl.uniform1i(this.place("stride"), stride);
    this.setCamera(camera);
    this.setDisplay(display);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    return true;
  }

  /** Draws every stride-th pixel of the buffer, each as a square: for machines that are slow. */
  drawCoarsely(display: Display, stride: number): void {
    const { gl, camera } = this;
    if (!camera) return;
    const width = Math.ceil(camera.width / stride), height = Math.ceil(camera.height / stride);
    this.onTexture(gl.RGBA8, width, height, () => {
      this.draw(display, stride);
      gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, null);
      gl.blitFramebuffer(0, 0, width, height, 0, 0, width * stride, height * stride, gl.COLOR_BUFFER_BIT, gl.NEAREST);
    });
  }

  /** Compiles what a display needs before it is in a hurry. */
  prepare(display: Display): void {
    this.onTexture(this.gl.RGBA8, 1, 1, () => this.draw(display, this.camera?.width ?? 1));
  }

  /** Waits until the canvas is drawn. */
  finish(): void {
    const { gl } = this;
    gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
  }

  /** Luminance, cd/m2, that 1 % of the body's picture exceeds, by every stride-th pixel: white in a still. */
  whiteOf(display: Display, stride: number): number {
    const { gl, camera } = this;
    if (!camera) return 1;
    const width = Math.ceil(camera.width / stride), height = Math.ceil(camera.height / stride);
    const pixels = new Float32Array(4 * width * height);
    this.onTexture(gl.RGBA32F, width, height, () => {
      this.draw({ ...display, look: "lamps", white: 0 }, stride);
      gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, pixels);
    });
    const seen: number[] = [];
    for (let i = 0; i < pixels.length; i += 4)
      if (pixels[i + 3] > 0) seen.push(0.2126 * pixels[i] + 0.7152 * pixels[i + 1] + 0.0722 * pixels[i + 2]);
    return quantile(seen, 0.99) || 1;
  }

  /** The round curvature, 1/mm, that 2 % of the body's picture exceed. */
  usualCurvature(): number {
    const sizes: number[] = [];
    for (let i = 0; i < this.samples.length; i += 8) {
      const mean = (this.samples[i + 3] + this.samples[i + 5]) / 2;
      if (this.samples[i + 7] > 0 && !Number.isNaN(mean)) sizes.push(Math.abs(mean));
    }
    const value = quantile(sizes, 0.98) || 1e-3, power = 10 ** Math.floor(Math.log10(value));
    return power * ([1, 2, 5].find((step) => value <= step * power * (1 + 1e-9)) ?? 10);
  }

  /** The surface at a pixel, if there is one. */
  pick(x: number, y: number): Picked | null {
    if (!this.camera) return null;
    const at = 8 * (Math.floor(y / this.rowStep) * this.rowStep * this.camera.width + x);
    const [t, p, q, xx, xy, yy, , face] = this.samples.subarray(at, at + 8);
    if (!Number.isFinite(t)) return null;
    const isLower = Math.fround(Math.abs(p) + Math.abs(q)) > 1;
    const fold = (a: number, b: number): number => (1 - Math.abs(b)) * (a < 0 ? -1 : 1);
    const normal = unit([isLower ? fold(p, q) : p, isLower ? fold(q, p) : q, 1 - Math.abs(p) - Math.abs(q)]);
    const mean = (xx + yy) / 2, spread = Math.hypot((xx - yy) / 2, xy);
    return { t, normal, radii: [1 / (mean + spread), 1 / (mean - spread)], face };
  }

  /** Lets work be done on a texture in place of the canvas. */
  private onTexture(format: number, width: number, height: number, work: () => void): void {
    const { gl } = this, target = gl.createFramebuffer(), texture = gl.createTexture();
    gl.activeTexture(gl.TEXTURE8);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, target);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    work();
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.deleteFramebuffer(target);
    gl.deleteTexture(texture);
  }

  private begin(camera: Camera): void {
    const { gl } = this, { width, height } = camera;
    const isNew = this.camera?.width !== width || this.camera.height !== height;
    this.camera = camera;
    this.bounceCount = 0;
    if (isNew) {
      this.samples = new Float32Array(8 * width * height);
      this.chains = new Uint32Array(width * height);
      this.canvas.width = width, this.canvas.height = height;
      this.bind("samples");
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, 2 * width, height, 0, gl.RGBA, gl.FLOAT, null);
    }
    this.samples.fill(0);
    this.chains.fill(0);
  }

  private addBounces(pass: Pass): void {
    const { gl } = this, count = pass.bounces.byteLength / bounceBytes;
    this.reserve(this.bounceCount + count);
    for (let i = 0; i < count; ++i) {
      const at = i * bounceBytes, pixel = pass.bounces.getUint32(at, true), number = this.bounceCount++;
      const chain = this.chains[pixel];
      this.chains[pixel] = chain === 0 ? (1 << 28 | number) >>> 0 : chain + (1 << 28);
      for (let k = 0; k < 8; ++k) this.bounces[8 * number + k] = pass.bounces.getFloat32(at + 4 + 4 * k, true);
    }
    this.bind("bounces");
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, 2 * bouncesARow, this.bounces.length / (8 * bouncesARow), 0, gl.RGBA,
      gl.FLOAT, this.bounces);
    this.bind("first_bounce");
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.R32UI, pass.width, pass.height, 0, gl.RED_INTEGER, gl.UNSIGNED_INT, this.chains);
  }

  private reserve(count: number): void {
    const rows = Math.ceil(count / bouncesARow);
    if (rows * 8 * bouncesARow <= this.bounces.length) return;
    const larger = new Float32Array(rows * 8 * bouncesARow);
    larger.set(this.bounces);
    this.bounces = larger;
  }

  private setMaterials(facts: Facts): void {
    const { gl } = this;
    const kind = (m: Material): number => !m.mirror ? 0 : m.metal ? 2 : 1;
    const table = new Float32Array(facts.materials.flatMap((m) => [...m.n, kind(m), ...m.k, 0]));
    this.bind("materials");
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, 2, facts.materials.length, 0, gl.RGBA, gl.FLOAT, table);
    const rows = Math.ceil(Math.max(1, facts.faces.length) / facesARow);
    const numbers = new Uint32Array(rows * facesARow);
    facts.faces.forEach((face, i) => { numbers[i] = face.material; });
    this.bind("material_of_face");
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.R32UI, facesARow, rows, 0, gl.RED_INTEGER, gl.UNSIGNED_INT, numbers);
  }

  /** Numbers of the scene, which a program needs once. */
  private setScene(facts: Facts): void {
    const { gl } = this;
    textureNames.forEach((name, unit) => gl.uniform1i(this.place(name), unit));
    gl.uniform1i(this.place("ground_material"), facts.ground?.material ?? 0);
    gl.uniform1f(this.place("min_weight"), facts.min_weight);
    gl.uniform3fv(this.place("background"), facts.background);
    gl.uniform3fv(this.place("ambient"), scaled(facts.rig.ambient, 1 / Math.PI));
  }

  private setCamera(camera: Camera): void {
    const { gl } = this, axes = axesOf(camera);
    gl.uniform3fv(this.place("eye"), camera.eye);
    for (const axis of ["right", "up", "forward"] as const) gl.uniform3fv(this.place(axis), axes[axis]);
    gl.uniform1i(this.place("is_parallel"), Number(camera.projection === "orthographic"));
    gl.uniform1f(this.place("pixel_size"), pixelSize(camera));
    gl.uniform2i(this.place("size"), camera.width, camera.height);
    gl.uniform1i(this.place("row_step"), this.rowStep);
  }

  private setDisplay(display: Display): void {
    const { gl } = this, planes = display.planes.slice(0, mostPlanes);
    gl.uniform1f(this.place("white"), display.white);
    gl.uniform1f(this.place("full_curvature"), display.fullCurvature);
    planes.forEach((plane, i) => this.setPlane(`planes[${i}]`, plane));
  }

  private setPlane(name: string, plane: Plane): void {
    const { gl } = this, u = unit(plane.u);
    const across = difference(plane.v, scaled(u, dot(u, plane.v))), v = unit(across);
    const vectors = { origin: plane.origin, u, v, normal: cross(u, v), luminance: plane.luminance };
    for (const [field, value] of Object.entries(vectors)) gl.uniform3fv(this.place(`${name}.${field}`), value);
    const numbers = {
      length: length(plane.u), first: (length(across) - (plane.lamps - 1) * plane.pitch) / 2,
      pitch: plane.pitch, diameter: plane.diameter,
    };
    for (const [field, value] of Object.entries(numbers)) gl.uniform1f(this.place(`${name}.${field}`), value);
    gl.uniform1i(this.place(`${name}.lamps`), plane.lamps);
    gl.uniform1i(this.place(`${name}.round`), Number(plane.mirror !== "flat"));
  }

  private bind(texture: string): void {
    const { gl } = this;
    gl.activeTexture(gl.TEXTURE0 + textureNames.indexOf(texture));
    gl.bindTexture(gl.TEXTURE_2D, this.textures[texture]);
  }

  private place(uniform: string): WebGLUniformLocation | null {
    const { linked, places } = this.program;
    if (!places.has(uniform)) places.set(uniform, this.gl.getUniformLocation(linked, uniform));
    return places.get(uniform)!;
  }

  /** The program of a look, ready to be set; only lamps know of a hurry. */
  private use(look: Look, isHurried: boolean, planes: number): Program {
    const number = looks.indexOf(look), lamps = number === 0 ? Math.min(planes, mostPlanes) : 0;
    const hurries = number === 0 && isHurried, key = `${look} ${hurries} ${lamps}`;
    const known = this.programs.get(key);
    const program = known ?? { linked: linked(this.gl, fragmentShader(number, hurries, lamps)), places: new Map() };
    this.programs.set(key, program);
    this.program = program;
    this.gl.useProgram(program.linked);
    if (!known) this.setScene(this.facts);
    return program;
  }
}

function linked(gl: WebGL2RenderingContext, fragment: string): WebGLProgram {
  const program = gl.createProgram()!;
  for (const [kind, text] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragment]] as const) {
    const shader = gl.createShader(kind)!;
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader) ?? "");
    gl.attachShader(program, shader);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(program) ?? "");
  return program;
}

/** The value that a share of the values does not exceed; 0 without any. */
function quantile(values: number[], share: number): number {
  const sorted = Float64Array.from(values).sort();
  return sorted[Math.round(share * (sorted.length - 1))] ?? 0;
}

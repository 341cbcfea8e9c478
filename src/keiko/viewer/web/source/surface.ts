/** The surface of one sample of a deep buffer, keiko-deep/1. */
export class Surface {
  t = 0;
  way = 0;
  face = 0;
  xx = 0;
  xy = 0;
  yy = 0;
  readonly normal = new Float64Array(3);
  private readonly x = new Float64Array(3); // tangents [Duff2017]
  private readonly y = new Float64Array(3);

  /** Reads the eight numbers from a place on. */
  read(samples: Float32Array, at: number): void {
    this.t = samples[at], this.way = samples[at + 6], this.face = samples[at + 7];
    this.xx = samples[at + 3], this.xy = samples[at + 4], this.yy = samples[at + 5];
    const p = samples[at + 1], q = samples[at + 2], away = Math.abs(p) + Math.abs(q);
    const isLower = Math.fround(away) > 1;
    const a = isLower ? (1 - Math.abs(q)) * (p < 0 ? -1 : 1) : p, b = isLower ? (1 - Math.abs(p)) * (q < 0 ? -1 : 1) : q;
    const c = 1 - away, perLength = 1 / Math.sqrt(a * a + b * b + c * c);
    this.setNormal(a * perLength, b * perLength, c * perLength, isLower ? -1 : 1);
  }

  private setNormal(nx: number, ny: number, nz: number, side: number): void {
    const { normal, x, y } = this, c = -1 / (side + nz), d = nx * ny * c;
    normal[0] = nx, normal[1] = ny, normal[2] = nz;
    x[0] = 1 + side * nx * nx * c, x[1] = side * d, x[2] = -side * nx;
    y[0] = d, y[1] = side + ny * ny * c, y[2] = -ny;
  }

  /** True beside poles, where the shape is not known. */
  get isPoint(): boolean {
    return Number.isNaN(this.xx);
  }

  /** Mean curvature, 1/mm, positive where the surface bends towards the normal. */
  get mean(): number {
    return 0.5 * (this.xx + this.yy);
  }

  /** Both principal curvatures, 1/mm, the greater first. */
  get principal(): [number, number] {
    const spread = Math.hypot(0.5 * (this.xx - this.yy), this.xy);
    return [this.mean + spread, this.mean - spread];
  }

  /** Curvature, 1/mm, of the normal section along a plane with a unit normal; NaN where the plane touches the surface. */
  along(plane: ArrayLike<number>): number {
    const { normal: n, x, y } = this, touching = 1e-6; // sine of the angle between the normals
    const a = plane[1] * n[2] - plane[2] * n[1], b = plane[2] * n[0] - plane[0] * n[2], c = plane[0] * n[1] - plane[1] * n[0];
    const p = a * x[0] + b * x[1] + c * x[2], q = a * y[0] + b * y[1] + c * y[2], squared = p * p + q * q;
    return squared > touching * touching ? (this.xx * p * p + 2 * this.xy * p * q + this.yy * q * q) / squared : NaN;
  }

  /** Writes the change of the normal along a step, which is three numbers of a ray from a place on. */
  turn(ray: Float64Array, at: number, change: Float64Array): void {
    const { x, y } = this;
    const a = ray[at] * x[0] + ray[at + 1] * x[1] + ray[at + 2] * x[2];
    const b = ray[at] * y[0] + ray[at + 1] * y[1] + ray[at + 2] * y[2];
    const byX = -(this.xx * a + this.xy * b), byY = -(this.xy * a + this.yy * b);
    for (let k = 0; k < 3; ++k) change[k] = x[k] * byX + y[k] * byY;
  }
}

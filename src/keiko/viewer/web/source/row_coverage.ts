import { endCoverage } from "./end_coverage";
import { PathSet } from "./path_set";
import { rayNumbers } from "./ray";
import { grown, RayList } from "./ray_list";
import { RowFrame } from "./row_frame";
import { coverage, imageNumbers, isAtEnd, project, steadiness } from "./row_image";
import { difference, dot, length } from "./vector";

/** What a row covers of the pixels of a list of rays, kept until row or rays change. */
export class RowCoverage {
  images = new Float32Array(imageNumbers);
  covered = new Float32Array(1); // 0 to 1, by ray
  private met = new Uint32Array(1); // the rays that meet the plane before another surface
  private metCount = 0;
  private projected = 0;
  private isCurrent = false;
  private travel = 0; // mm that the row has moved in its plane
  private until = new Float64Array(1); // by ray: the travel up to which `covered` is right
  private base: RowFrame; // on whose plane the images are
  private du = 0;
  private dv = 0;

  /** `pathOf`: paths by ray; null: a ray's number is that of its path. */
  constructor(private rays: RayList, private readonly pathOf: (() => Uint32Array) | null, private row: RowFrame) {
    this.base = row;
  }

  /** Takes other rays, of which nothing is known. */
  restart(rays: RayList): void {
    this.rays = rays, this.base = this.row;
    this.projected = this.metCount = this.du = this.dv = 0;
    this.covered.fill(0);
  }

  /** Makes all images anew from where the row is: rounding no longer tells that it was dragged. False if it was not. */
  renew(): boolean {
    if (this.du === 0 && this.dv === 0) return false;
    this.base = this.row, this.projected = this.metCount = this.du = this.dv = 0;
    this.until.fill(0);
    this.isCurrent = false;
    return true;
  }

  /** Takes the row as it is now. One that moved in its plane, or has other lamps, needs no new images. */
  set(row: RowFrame): void {
    if (!row.hasPlaneOf(this.base) || row.isRound !== this.base.isRound) this.base = row, this.projected = this.metCount = 0;
    if (row.hasLampsOf(this.row)) this.travel += length(difference(row.origin, this.row.origin));
    else this.until.fill(0);
    this.row = row;
    this.isCurrent = false;
    const step = difference(row.origin, this.base.origin);
    this.du = dot(row.u, step), this.dv = dot(row.v, step);
  }

  /** Offset of the row along its lamps and across them since the images were made, mm. */
  get moved(): [number, number] {
    return [this.du, this.dv];
  }

  /** Brings `images` and `covered` up to date; adds the paths that the row covers otherwise than before. */
  update(changed: PathSet): void {
    if (this.isCurrent && this.projected === this.rays.count) return;
    this.images = grown(this.images, imageNumbers * this.rays.count);
    this.covered = grown(this.covered, this.rays.count);
    this.met = grown(this.met, this.rays.count);
    this.until = grown(this.until, this.rays.count);
    const pathOf = this.pathOf?.() ?? null;
    this.projectAll(changed, pathOf);
    this.coverAll(changed, pathOf);
    this.isCurrent = true;
  }

  private projectAll(changed: PathSet, pathOf: Uint32Array | null): void {
    const { rays: { numbers, ways, count }, row, images, covered, met, until } = this;
    for (let i = this.projected; i < count; ++i) {
      project(row, numbers, rayNumbers * i, images, imageNumbers * i);
      until[i] = 0;
      const t = images[imageNumbers * i];
      if (t > 0 && t <= ways[i]) met[this.metCount++] = i;
      else if (covered[i] > 0) covered[i] = 0, changed.add(pathOf ? pathOf[i] : i);
    }
    this.projected = count;
  }

  private coverAll(changed: PathSet, pathOf: Uint32Array | null): void {
    const { row, images, covered, met, metCount, du, dv, until, travel } = this;
    for (let k = 0; k < metCount; ++k) {
      const i = met[k];
      if (travel < until[i]) continue;
      until[i] = travel + steadiness(row, images, imageNumbers * i, du, dv);
      const c = Math.fround(coverage(row, images, imageNumbers * i, du, dv));
      if (c !== covered[i]) covered[i] = c, changed.add(pathOf ? pathOf[i] : i);
    }
  }

  /** Makes `covered` exact at the ends of lamps. */
  finish(changed: PathSet): void {
    const { rays: { numbers }, row, images, covered, met, metCount, du, dv, until } = this, pathOf = this.pathOf?.() ?? null;
    for (let k = 0; k < metCount; ++k) {
      const i = met[k];
      if (!isAtEnd(row, images, imageNumbers * i, du, dv)) continue;
      const c = Math.fround(endCoverage(row, numbers, rayNumbers * i));
      until[i] = 0;
      if (c !== covered[i]) covered[i] = c, changed.add(pathOf ? pathOf[i] : i);
    }
  }
}

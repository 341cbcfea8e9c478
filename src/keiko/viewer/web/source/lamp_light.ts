import { Around, bendAcross, bendAlong, CubicPixel, partsOfBend } from "./bent_pixel";
import { endCoverage } from "./end_coverage";
import { Facts, Plane } from "./facts";
import { footprintOf } from "./footprint";
import { PathSet } from "./path_set";
import { rayNumbers } from "./ray";
import { grown } from "./ray_list";
import { RowCoverage } from "./row_coverage";
import { RowFrame } from "./row_frame";
import { coverage, imageNumbers, isAtEnd, mayHoldEdge, mayHoldEnd, project } from "./row_image";
import { SurfaceBuffer } from "./surface_buffer";

/** A row with what it covers of the first reflections and of the later ones. */
interface LitRow {
  frame: RowFrame;
  first: RowCoverage;
  later: RowCoverage;
  bends: Float32Array; // mm by path, of pixels whose nearest plane is this row's; -1: not known
  level: number;       // the first row in the same plane
}

/** The light of rows of lamps in the reflections of a buffer. */
export class LampLight {
  luminance = new Float32Array(3); // cd/m2 by path: red, green, blue
  readonly changed = new PathSet(); // whose light the last update changed
  private readonly divided = new PathSet(); // whose light is a mean over parts
  private done = 0;     // paths that have light
  private refined = 0;  // paths that have been looked at by refine()
  private hasEnds = false; // of lamps, exactly
  private buffer: SurfaceBuffer | null = null;
  private planes: Plane[] = [];
  private rows: LitRow[] = [];
  private readonly ambient: number[];
  private readonly seen = new Float64Array(4); // light, and the opacity of what it comes from
  private readonly cubic = new CubicPixel();
  private readonly image = new Float32Array(imageNumbers);
  private readonly partCoverage = new Float64Array(64);
  private readonly distances = new Float64Array(64);
  private readonly order = new Int32Array(64);

  constructor(private readonly facts: Facts) {
    this.ambient = facts.rig.ambient.map((e) => e / Math.PI);
  }

  /** Takes a buffer and the rows that are lit in it. */
  set(buffer: SurfaceBuffer, planes: Plane[]): void {
    const isNew = buffer !== this.buffer;
    if (!isNew && planes === this.planes) return;
    if (isNew || planes.length !== this.rows.length) this.done = 0;
    if (isNew) this.changed.clear(), this.divided.clear();
    this.buffer = buffer;
    this.refined = 0, this.hasEnds = false;
    this.rows = planes.slice(0, this.order.length).map((plane, i) => {
      const frame = new RowFrame(plane), known = this.rows[i];
      if (!known) return this.litRow(frame);
      if (isNew) known.first.restart(buffer.first), known.later.restart(buffer.later), known.bends = new Float32Array(0);
      if (plane === this.planes[i]) return known;
      if (!frame.hasPlaneOf(known.frame)) known.bends.fill(-1);
      known.first.set(frame), known.later.set(frame);
      return { ...known, frame };
    });
    this.planes = planes;
    this.rows.forEach((row) => { row.level = this.rows.findIndex((other) => isInOnePlane(other.frame, row.frame)); });
  }

  private litRow(frame: RowFrame): LitRow {
    const buffer = this.buffer!;
    return {
      frame, first: new RowCoverage(buffer.first, null, frame),
      later: new RowCoverage(buffer.later, () => this.buffer!.pathOfLater, frame), bends: new Float32Array(0), level: 0,
    };
  }

  /** Makes the images of rows that were dragged anew: the light is that of a new buffer, bit for bit. */
  renew(): void {
    for (const { first, later, bends } of this.rows) {
      const isFirst = first.renew(), isLater = later.renew();
      if (isFirst || isLater) bends.fill(-1), this.refined = 0, this.hasEnds = false;
    }
  }

  /** Brings the light of all paths up to date, without dividing pixels; `changed` has those whose light is another. */
  update(): void {
    const buffer = this.buffer!, { changed, divided } = this;
    changed.clear();
    changed.reserve(buffer.paths), divided.reserve(buffer.paths);
    this.luminance = grown(this.luminance, 3 * buffer.paths);
    for (const row of this.rows) row.first.update(changed), row.later.update(changed);
    for (let i = 0; this.refined === 0 && i < divided.count; ++i) changed.add(divided.list[i]);
    if (this.refined === 0) divided.clear();
    for (let path = this.done; path < buffer.paths; ++path) changed.add(path);
    this.done = buffer.paths;
    for (let i = 0; i < changed.count; ++i) this.light(changed.list[i], false);
  }

  /** Makes the ends of lamps exact and divides pixels whose image is bent, for some milliseconds; false if there are more. */
  refine(milliseconds: number): boolean {
    const buffer = this.buffer!, { changed } = this, end = performance.now() + milliseconds, often = 256;
    changed.clear();
    if (!this.hasEnds) {
      this.hasEnds = true;
      for (const row of this.rows) row.first.finish(changed), row.later.finish(changed);
      for (let i = 0; i < changed.count; ++i) this.light(changed.list[i], false);
    }
    for (; this.refined < buffer.paths; ++this.refined) {
      if (this.refined % often === 0 && performance.now() > end) return false;
      this.light(this.refined, true);
    }
    return true;
  }

  private light(path: number, isFine: boolean): void {
    const { first, later, laterCounts, laterFirst } = this.buffer!, { luminance, seen } = this, at = 3 * path;
    if (isFine) {
      if (!this.lookDivided(path)) return;
      this.divided.add(path), this.changed.add(path);
    } else this.look(false, path);
    let passed = 1 - seen[3], weights = first.weights, from = at, way = first.ways[path];
    for (let k = 0; k < 3; ++k) luminance[at + k] = weights[from + k] * seen[k];
    const end = laterFirst[path] + laterCounts[path];
    for (let i = laterFirst[path]; i < end; ++i) {
      weights = later.weights, from = 3 * i, way = later.ways[i];
      this.look(true, i);
      for (let k = 0; k < 3; ++k) luminance[at + k] += passed * weights[from + k] * seen[k];
      passed *= 1 - seen[3];
      if (passed * Math.max(weights[from], weights[from + 1], weights[from + 2]) < this.facts.min_weight) break;
    }
    if (way === Infinity) for (let k = 0; k < 3; ++k) luminance[at + k] += passed * weights[from + k] * this.ambient[k];
  }

  /** Sets `seen` to the light along a ray, from what its rows cover of it. */
  private look(isLater: boolean, ray: number): void {
    const { rows, seen, order, partCoverage, distances } = this;
    let count = 0;
    seen[0] = seen[1] = seen[2] = seen[3] = 0;
    for (let i = 0; i < rows.length; ++i) {
      const covered = (isLater ? rows[i].later : rows[i].first).covered[ray];
      if (covered > 0) order[count++] = i, partCoverage[i] = covered;
    }
    if (count === 0) return;
    if (count > 1)
      for (let h = 0; h < count; ++h) {
        const level = rows[rows[order[h]].level];
        distances[order[h]] = (isLater ? level.later : level.first).images[imageNumbers * ray];
      }
    this.addUp(count, 1);
  }

  /** Adds to `seen` the light of `order`'s rows, the nearest first, of which each dims those behind it. */
  private addUp(count: number, share: number): void {
    const { rows, seen, order, partCoverage, distances } = this;
    for (let h = 1; h < count; ++h)
      for (let g = h; g > 0 && distances[order[g]] < distances[order[g - 1]]; --g) {
        const nearer = order[g];
        order[g] = order[g - 1], order[g - 1] = nearer;
      }
    let passed = share;
    for (let h = 0; h < count; ++h) {
      const covered = passed * partCoverage[order[h]], { luminance } = rows[order[h]].frame;
      for (let k = 0; k < 3; ++k) seen[k] += luminance[k] * covered;
      seen[3] += covered, passed -= covered;
    }
  }

  /** The same for a first reflection, as the mean over the parts of a pixel; false if it needs none. */
  private lookDivided(path: number): boolean {
    const buffer = this.buffer!;
    if (!buffer.isAmid(path)) return false;
    const nearest = this.nearestRow(path);
    if (nearest < 0) return false;
    const around = this.around(path), parts = partsOfBend(this.bendOf(this.rows[nearest], path, around));
    if (parts === 1 || !this.isAtEdge(path, this.rows[nearest])) return false;
    this.cubic.set(buffer.first.numbers, around);
    this.seen.fill(0);
    for (let y = 0.5; y < parts; ++y)
      for (let x = 0.5; x < parts; ++x) {
        this.cubic.setPart(x / parts - 0.5, y / parts - 0.5, 1 / parts);
        this.addPart(buffer.first.ways[path], 1 / (parts * parts));
      }
    return true;
  }

  private addPart(way: number, share: number): void {
    const { rows, image, order, partCoverage, distances, cubic } = this;
    let count = 0;
    for (let i = 0; i < rows.length; ++i) {
      const { frame } = rows[i];
      project(frame, cubic.ray, 0, image, 0);
      const t = distances[i] = image[0];
      if (rows[i].level < i) distances[i] = distances[rows[i].level];
      const covered = !(t > 0 && t <= way) ? 0
        : isAtEnd(frame, image, 0, 0, 0) ? endCoverage(frame, cubic.ray, 0) : coverage(frame, image, 0, 0, 0);
      if (covered > 0) order[count++] = i, partCoverage[i] = covered;
    }
    this.addUp(count, share);
  }

  /** True if a part of a bent pixel may be covered otherwise than its linear image on the nearest plane. */
  private isAtEdge(path: number, nearest: LitRow): boolean {
    const off = 2 * nearest.bends[path];
    return this.rows.some(({ frame, first }) => mayHoldEdge(frame, first.images, imageNumbers * path, first.moved, off));
  }

  /** The row whose plane a path's first reflection meets first; -1: none. */
  private nearestRow(path: number): number {
    let nearest = -1, least = Infinity;
    for (let i = 0; i < this.rows.length; ++i) {
      const t = this.rows[i].first.images[imageNumbers * path];
      if (t > 0 && t < least) least = t, nearest = i;
    }
    return nearest;
  }

  private around(path: number): Around {
    const { pathOf, pixels, camera: { width } } = this.buffer!, pixel = pixels[path];
    return [path, pathOf[pixel - 1], pathOf[pixel + 1], pathOf[pixel - width], pathOf[pixel + width]]
      .map((p) => p * rayNumbers) as Around;
  }

  /** Bend of a pixel's image on a row's plane: in pitches across the lamps, at their ends also as a share of its span. */
  private bendOf(row: LitRow, path: number, around: Around): number {
    const buffer = this.buffer!, { numbers } = buffer.first, { frame } = row;
    if (row.bends.length < buffer.paths) row.bends = new Float32Array(buffer.paths).fill(-1);
    if (row.bends[path] === -1)
      row.bends[path] = bendAcross(frame, numbers, around, footprintOf(frame, numbers, rayNumbers * path));
    const across = row.bends[path] / frame.pitch;
    if (!mayHoldEnd(frame, row.first.images, imageNumbers * path, row.first.moved[0])) return across;
    return Math.max(across, bendAlong(frame, numbers, around, footprintOf(frame, numbers, rayNumbers * path)));
  }
}

function isInOnePlane(a: RowFrame, b: RowFrame): boolean {
  const off = a.normal[0] * (b.origin[0] - a.origin[0]) + a.normal[1] * (b.origin[1] - a.origin[1]) + a.normal[2] * (b.origin[2] - a.origin[2]);
  const turn = Math.hypot(a.normal[1] * b.normal[2] - a.normal[2] * b.normal[1], a.normal[2] * b.normal[0] - a.normal[0] * b.normal[2],
    a.normal[0] * b.normal[1] - a.normal[1] * b.normal[0]);
  return turn <= 1e-13 && Math.abs(off) <= 1e-14 * (Math.hypot(...a.origin) + Math.hypot(...b.origin) + a.length + b.length);
}

import { RowFrame } from "./row_frame";
import { offAxis, stripeCoverage } from "./stripe_coverage";

// The image of a ray's pixel on the plane of a row is nine numbers, lengths in mm. The first three are t where the ray
// meets the plane, 0 if it does not, and u and v there. Then come the apparent over the true width of the tubes, and
// the pixel's reach along the lamps. Both widths of its filter across them follow, and the shift of a tube's end in its
// radii. The last is the least component of the pixel's rays across the plane, over that of its centre's.
export const imageNumbers = 9;

/** Writes the image of a ray, read from a place on. The formulas are those of light/tubes/plane_image. */
export function project(row: RowFrame, rays: Float32Array, at: number, image: Float32Array, to: number): void {
  const { u, v, normal: n, origin } = row;
  const dz = n[0] * rays[at + 3] + n[1] * rays[at + 4] + n[2] * rays[at + 5];
  const ox = rays[at] - origin[0], oy = rays[at + 1] - origin[1], oz = rays[at + 2] - origin[2];
  const t = -(n[0] * ox + n[1] * oy + n[2] * oz) / dz;
  if (!(Math.abs(dz) > 1e-12 && t > 0)) {
    image[to] = 0;
    return;
  }
  const du = u[0] * rays[at + 3] + u[1] * rays[at + 4] + u[2] * rays[at + 5];
  const dv = v[0] * rays[at + 3] + v[1] * rays[at + 4] + v[2] * rays[at + 5];
  const ou = u[0] * ox + u[1] * oy + u[2] * oz, ov = v[0] * ox + v[1] * oy + v[2] * oz;
  const slopeU = du / dz, slopeV = dv / dz;
  const xx = rays[at + 6] + rays[at + 12] * t, xy = rays[at + 7] + rays[at + 13] * t, xz = rays[at + 8] + rays[at + 14] * t;
  const yx = rays[at + 9] + rays[at + 15] * t, yy = rays[at + 10] + rays[at + 16] * t, yz = rays[at + 11] + rays[at + 17] * t;
  const xn = n[0] * xx + n[1] * xy + n[2] * xz, yn = n[0] * yx + n[1] * yy + n[2] * yz;
  const xAlong = Math.abs(u[0] * xx + u[1] * xy + u[2] * xz - slopeU * xn);
  const yAlong = Math.abs(u[0] * yx + u[1] * yy + u[2] * yz - slopeU * yn);
  const xAcross = Math.abs(v[0] * xx + v[1] * xy + v[2] * xz - slopeV * xn);
  const yAcross = Math.abs(v[0] * yx + v[1] * yy + v[2] * yz - slopeV * yn);
  const descentX = (n[0] * rays[at + 12] + n[1] * rays[at + 13] + n[2] * rays[at + 14]) / dz;
  const descentY = (n[0] * rays[at + 15] + n[1] * rays[at + 16] + n[2] * rays[at + 17]) / dz;
  const least = 1 - 0.5 * (Math.abs(descentX) + Math.abs(descentY));
  image[to] = t, image[to + 1] = ou + t * du, image[to + 2] = ov + t * dv;
  image[to + 3] = row.isRound ? Math.sqrt(dv * dv + dz * dz) / Math.abs(dz) : 1;
  image[to + 4] = 0.5 * (xAlong + yAlong);
  image[to + 5] = Math.max(xAcross, yAcross), image[to + 6] = Math.min(xAcross, yAcross);
  image[to + 7] = row.isRound ? Math.abs(slopeU) : 0, image[to + 8] = least;
}

/**
 * Coverage of a pixel by a row, 0 to 1, from the image at a place. The row may have moved in its plane since the image
 * was made, by `du` and `dv`. At the ends of lamps they are taken for straight; `isAtEnd` tells where.
 */
export function coverage(row: RowFrame, image: Float32Array, from: number, du: number, dv: number): number {
  const u = image[from + 1] - du, v = image[from + 2] - dv, width = row.diameter * image[from + 3];
  const reach = widened(image, from, image[from + 4]), room = widened(image, from, image[from + 7] * 0.5 * row.diameter);
  if (u + reach <= -room || u - reach >= row.length + room) return 0;
  const strips = stripeCoverage(row, width, v, image[from + 5], image[from + 6]);
  if (u - reach >= 0 && u + reach <= row.length || !(reach > 0 && reach < Infinity)) return strips;
  return strips * Math.max(Math.min(u + reach, row.length) - Math.max(u - reach, 0), 0) / (2 * reach);
}

/**
 * How far, mm, the row may move in its plane until `coverage` of a pixel may be another: 0 where it is neither all nor
 * nothing, else at most the distance to the nearest edge of a lamp.
 */
export function steadiness(row: RowFrame, image: Float32Array, from: number, du: number, dv: number): number {
  const u = image[from + 1] - du, half = 0.5 * row.diameter * image[from + 3];
  const reach = widened(image, from, image[from + 4]), room = widened(image, from, image[from + 7] * 0.5 * row.diameter);
  const beyond = Math.max(-room - u - reach, u - reach - row.length - room);
  if (beyond >= 0) return beyond;
  const wide = image[from + 5], { pitch, lamps } = row;
  if (wide > 4 * pitch || 2 * half >= pitch || lamps === 0) return 0;
  const spread = 0.5 * (wide + image[from + 6]), off = Math.abs(offAxis(row, image[from + 2] - dv));
  if (off - half >= spread) return off - half - spread;
  return Math.max(Math.min(half - off - spread, u - reach, row.length - u - reach), 0);
}

/** True if an end of lamps may change what a pixel shows: `endCoverage` is exact there. */
export function isAtEnd(row: RowFrame, image: Float32Array, from: number, du: number, dv: number): boolean {
  const u = image[from + 1] - du, v = image[from + 2] - dv;
  const reach = widened(image, from, image[from + 4]), room = widened(image, from, image[from + 7] * 0.5 * row.diameter);
  if (u + reach <= -room || u - reach >= row.length + room) return false;
  if (u - reach >= room && u + reach <= row.length - room) return false;
  return !isInGap(row, image, from, v, row.diameter * image[from + 3]);
}

/** The largest image of a length at the centre's hit; infinite if the plane's horizon runs through the pixel. */
function widened(image: Float32Array, from: number, length: number): number {
  return image[from + 8] > 0 ? length / image[from + 8] : length > 0 ? Infinity : 0;
}

/** True for images between lamps or beside the row, regardless of the lamps' ends. */
function isInGap(row: RowFrame, image: Float32Array, from: number, v: number, width: number): boolean {
  const least = image[from + 8], reach = 0.5 * (image[from + 5] + image[from + 6]);
  const isAway = least > 0 && least * Math.abs(offAxis(row, v)) > 0.5 * width + reach;
  return isAway && (v < row.first || v > row.last || reach < 0.5 * least * row.pitch);
}

/** True if an end of lamps may be in the image at a place. */
export function mayHoldEnd(row: RowFrame, image: Float32Array, from: number, du: number): boolean {
  const u = image[from + 1] - du, reach = widened(image, from, image[from + 4] + image[from + 7] * 0.5 * row.diameter);
  return Math.abs(u) < reach || Math.abs(row.length - u) < reach;
}

/** True unless a pixel lies in one lamp or between lamps, as far as places `off` mm beyond its image. */
export function mayHoldEdge(row: RowFrame, image: Float32Array, from: number, [du, dv]: [number, number], off: number): boolean {
  if (!(image[from] > 0)) return false;
  const u = image[from + 1] - du, along = widened(image, from, image[from + 4] + image[from + 7] * 0.5 * row.diameter) + off;
  if (u + along <= 0 || u - along >= row.length) return false;
  const away = image[from + 2] - dv - row.first, half = 0.5 * row.diameter * image[from + 3];
  const axis = Math.abs(offAxis(row, image[from + 2] - dv));
  const spread = widened(image, from, 0.5 * (image[from + 5] + image[from + 6])) + off;
  const isBeside = axis - spread >= half && (away < 0 || away > row.last - row.first || axis + spread <= row.pitch - half);
  if (isBeside) return false;
  return u < along || row.length - u < along || axis + spread > half;
}

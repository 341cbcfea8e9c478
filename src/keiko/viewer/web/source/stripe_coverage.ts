import { RowFrame } from "./row_frame";

const leastWidth = 1e-6; // mm: nearly a point

/** Integral of a pixel's image along one axis, from its centre to x: of the convolution of two boxes. */
function below(wide: number, narrow: number, x: number): number {
  const away = Math.abs(x), reach = 0.5 * (wide + narrow);
  if (away >= reach) return x < 0 ? -0.5 : 0.5;
  const rest = reach - away;
  const inside = away <= reach - narrow ? away / wide : 0.5 - 0.5 * rest * rest / (wide * narrow);
  return x < 0 ? -inside : inside;
}

/** Share of an image, the widths of its two boxes given, between two places relative to its centre. */
export function share(wide: number, narrow: number, begin: number, end: number): number {
  const w = Math.max(wide, leastWidth), n = Math.max(narrow, leastWidth);
  return Math.max(below(w, n, end) - below(w, n, begin), 0);
}

/** mm from the axis of the nearest lamp to a place across the row. */
export function offAxis({ first, pitch, lamps }: RowFrame, v: number): number {
  const away = v - first;
  return away - pitch * Math.min(Math.max(Math.round(away / pitch), 0), lamps - 1);
}

/** Share of a pixel's image around v on the row's strips of a width; the formulas of light/tubes/stripe_coverage. */
export function stripeCoverage(row: RowFrame, width: number, v: number, wide: number, narrow: number): number {
  const { pitch, lamps, first, last } = row;
  if (lamps === 0) return 0;
  if (wide > 4 * pitch) { // too fine to be distinguished: a grey band
    const beyond = 0.5 * Math.max(pitch, width);
    return Math.min(width / pitch, 1) * share(wide, narrow, first - beyond - v, last + beyond - v);
  }
  const half = 0.5 * width;
  if (!(width < pitch)) return share(wide, narrow, first - half - v, last + half - v);
  const spread = 0.5 * (wide + narrow), reach = spread + half, away = v - first;
  const off = Math.abs(offAxis(row, v));
  if (off >= reach) return 0;
  if (off + spread <= half) return 1;
  const end = Math.min(Math.floor((away + reach) / pitch), lamps - 1);
  let sum = 0;
  for (let lamp = Math.max(Math.ceil((away - reach) / pitch), 0); lamp <= end; ++lamp) {
    const at = lamp * pitch - away;
    sum += share(wide, narrow, at - half, at + half);
  }
  return sum;
}

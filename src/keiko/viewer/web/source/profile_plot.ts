import { Vector } from "./vector";

/** A quantity of a profile of keiko-profiles/1. */
interface Quantity { unit: string; largest: number; limit: number | null; formula?: "alias" | "catia" | string }
interface Sample { along: number; piece: number; place: Vector; gap: number; angle: number | null; alias?: number; catia?: number }

/** A profile of keiko-profiles/1, as far as the page plots it. */
export interface Profile {
  length: number;
  gap: Quantity | null;
  angle: Quantity | null;
  curvature: Quantity | null;
  samples: Sample[];
}

type Value = (sample: Sample) => number | null | undefined;

/** The quantity that a kind of mending is about: its name, itself, and its value at a sample. */
function plotted(profile: Profile, mending: string): [string, Quantity | null, Value] {
  if (mending === "position") return ["gap", profile.gap, (s) => s.gap];
  const { curvature } = profile;
  if (mending === "curvature" && curvature)
    return ["curvature mismatch", curvature, (s) => curvature.formula === "catia" ? s.catia : s.alias];
  return ["angle", profile.angle, (s) => s.angle];
}

const wide = 320, high = 90, top = 14;

function svg(tag: string, attributes: Record<string, string | number>, text = ""): SVGElement {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
  made.textContent = text;
  return made;
}

/** The points of each stretch of samples that have a value. */
function lines(profile: Profile, value: Value, scale: (v: number) => number): string[] {
  const found: string[][] = [];
  let piece = -1;
  for (const sample of profile.samples) {
    const v = value(sample);
    if (v === null || v === undefined) piece = -1;
    else {
      if (sample.piece !== piece) found.push([]);
      piece = sample.piece;
      found[found.length - 1].push(`${(sample.along / profile.length * wide).toFixed(1)},${scale(v).toFixed(1)}`);
    }
  }
  return found.map((points) => points.join(" "));
}

/** The quantity of a fault all along its stretch, with its limit dashed. */
export function profilePlot(profile: Profile, mending: string): SVGElement {
  const [name, quantity, value] = plotted(profile, mending);
  const unit = quantity?.unit === "1" ? "" : ` ${quantity?.unit ?? ""}`, limit = quantity?.limit ?? null;
  const largest = Math.max(quantity?.largest ?? 0, limit ?? 0, 1e-12) * 1.05;
  const scale = (v: number): number => top + (high - top) * (1 - v / largest);
  const title = `${name} up to ${quantity?.largest.toPrecision(3) ?? "?"}${unit} on ${profile.length.toFixed(1)} mm` +
    (limit === null ? "" : `, limit ${limit}${unit}`);
  const plot = svg("svg", { viewBox: `0 0 ${wide} ${high + 1}`, class: "plot", role: "img", "aria-label": title });
  plot.append(svg("text", { x: 0, y: 10 }, title));
  if (limit !== null) plot.append(svg("line", { class: "limit", x1: 0, x2: wide, y1: scale(limit), y2: scale(limit) }));
  for (const points of lines(profile, value, scale)) plot.append(svg("polyline", { points }));
  return plot;
}

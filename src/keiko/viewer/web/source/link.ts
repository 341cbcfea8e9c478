import { Camera } from "./camera";
import { Plane } from "./facts";
import { Look, looks } from "./picture";
import { token } from "./server";
import { Vector } from "./vector";

/** What a link restores. */
export interface ViewState {
  camera: Pick<Camera, "eye" | "target" | "up">;
  look: Look;
  planes: Plane[] | null; // null: those of the rig
}

const text = (v: readonly number[]): string => v.map((x) => String(Number(x.toPrecision(9)))).join(",");

function vectorOf(given: string | null): Vector | null {
  const numbers = (given ?? "").split(",").map(Number);
  return numbers.length === 3 && numbers.every(Number.isFinite) ? numbers as Vector : null;
}

/** A row as numbers: origin, u, v, lamps, pitch, diameter, luminance; and its two words. */
const rowText = (p: Plane): string => `${text([...p.origin, ...p.u, ...p.v, p.lamps, p.pitch, p.diameter, ...p.luminance])},${p.caps},${p.mirror}`;

function rowOf(given: string): Plane | null {
  const parts = given.split(","), n = parts.slice(0, 15).map(Number), [caps, mirror] = parts.slice(15);
  const isRow = parts.length === 17 && n.every(Number.isFinite) && n[9] >= 0 && n[10] > 0 && n[11] > 0
    && ["dark", "luminous"].includes(caps) && ["tube", "flat", "exact"].includes(mirror);
  if (!isRow) return null;
  const vector = (at: number): Vector => [n[at], n[at + 1], n[at + 2]];
  return {
    origin: vector(0), u: vector(3), v: vector(6), lamps: Math.round(n[9]), pitch: n[10], diameter: n[11], luminance: vector(12),
    caps: caps as Plane["caps"], mirror: mirror as Plane["mirror"],
  };
}

/** Writes a state into the page's address; the token is not in it. */
export function keepInAddress(state: ViewState): void {
  history.replaceState(null, "", `#${fragmentOf(state)}`);
}

function fragmentOf({ camera, look, planes }: ViewState): URLSearchParams {
  const fragment = new URLSearchParams({ eye: text(camera.eye), target: text(camera.target), up: text(camera.up), look });
  for (const plane of planes ?? []) fragment.append("row", rowText(plane));
  if (planes?.length === 0) fragment.append("rows", "none");
  return fragment;
}

/** The state that the page's address has; null without one, or with one that makes no sense. */
export function stateOfAddress(): ViewState | null {
  const given = new URLSearchParams(location.hash.slice(1)), rows = given.getAll("row").map(rowOf);
  const [eye, target, up] = ["eye", "target", "up"].map((name) => vectorOf(given.get(name)));
  const look = looks.find((name) => name === given.get("look"));
  if (!eye || !target || !up || !look || rows.some((row) => row === null)) return null;
  const isOwn = rows.length > 0 || given.get("rows") === "none";
  return { camera: { eye, target, up }, look, planes: isOwn ? rows as Plane[] : null };
}

/** The address that opens a state in another tab, with the token of this server. */
export function linkOf(state: ViewState): string {
  const fragment = fragmentOf(state);
  fragment.set("token", token);
  return `${location.origin}${location.pathname}#${fragment}`;
}

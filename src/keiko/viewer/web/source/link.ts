import { Note } from "./analysis";
import { Camera } from "./camera";
import { Plane } from "./facts";
import { directionOf, directionWord, hasSections, lookOf, StatedLook, wordOf } from "./look_words";
import { token } from "./server";
import { Vector } from "./vector";

/** The eye that a link restores: a camera without the size of its picture. */
export type Eye = Omit<Camera, "width" | "height">;

/** What a link restores. */
export interface ViewState {
  camera: Eye;
  look: StatedLook;
  planes: Plane[] | null; // null: those of the rig
  hidden: number[];       // faces that are not shown
  section: string;        // "y=120", or "" for none
  seams: boolean;         // drawn over the picture
  lines: boolean;         // those of the lamps, drawn over the picture
  notes: Note[];
}

const text = (v: readonly number[]): string => v.map((x) => String(Number(x.toPrecision(9)))).join(",");

function numbersOf(given: string | null): number[] | null {
  const numbers = given ? given.split(",").map(Number) : [];
  return numbers.every(Number.isFinite) ? numbers : null;
}

function vectorOf(given: string | null): Vector | null {
  const numbers = numbersOf(given);
  return numbers?.length === 3 ? numbers as Vector : null;
}

const eyeTexts = (eye: Eye): Record<string, string> => ({
  eye: text(eye.eye), target: text(eye.target), up: text(eye.up),
  lens: eye.projection === "orthographic" ? `height,${eye.orthographic_height}` : `fov,${eye.vertical_fov}`,
});

function eyeOf(given: URLSearchParams): Eye | null {
  const [eye, target, up] = ["eye", "target", "up"].map((name) => vectorOf(given.get(name)));
  const [lens, size] = (given.get("lens") ?? "").split(","), wide = Number(size), isParallel = lens === "height";
  if (!eye || !target || !up || !["height", "fov"].includes(lens) || !(wide > 0 && (isParallel || wide < 180))) return null;
  return {
    projection: isParallel ? "orthographic" : "perspective", eye, target, up,
    vertical_fov: isParallel ? 28 : wide, orthographic_height: isParallel ? wide : 0,
  };
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

/** A note as place, face and text. */
const noteText = ({ place, face, text: words }: Note): string => `${text([...place, face])},${words}`;

function noteOf(given: string): Note | null {
  const parts = given.split(","), n = parts.slice(0, 4).map(Number), words = parts.slice(4).join(",");
  return n.every(Number.isFinite) && words ? { place: [n[0], n[1], n[2]], face: n[3], text: words } : null;
}

/** Writes a state into the page's address; the token is not in it. */
export function keepInAddress(state: ViewState): void {
  history.replaceState(null, "", `#${fragmentOf(state)}`);
}

function fragmentOf({ camera, look, planes, hidden, section, seams, lines, notes }: ViewState): URLSearchParams {
  const fragment = new URLSearchParams({ ...eyeTexts(camera), look: wordOf(look) });
  if (hasSections(look)) fragment.set("across", directionWord(look.across));
  for (const plane of planes ?? []) fragment.append("row", rowText(plane));
  if (planes?.length === 0) fragment.append("rows", "none");
  if (hidden.length > 0) fragment.append("hidden", hidden.join(","));
  if (section) fragment.append("section", section);
  if (seams) fragment.set("seams", "shown");
  if (lines) fragment.set("lines", "shown");
  for (const note of notes) fragment.append("note", noteText(note));
  return fragment;
}

/** The state that the page's address has; null without one, or with one that makes no sense. */
export function stateOfAddress(): ViewState | null {
  const given = new URLSearchParams(location.hash.slice(1)), rows = given.getAll("row").map(rowOf);
  const camera = eyeOf(given), look = lookOf(given.get("look") ?? "", directionOf(given.get("across") ?? "") ?? undefined), hidden = numbersOf(given.get("hidden"));
  const notes = given.getAll("note").map(noteOf);
  if (!camera || !look || !hidden || rows.includes(null) || notes.includes(null)) return null;
  const isOwn = rows.length > 0 || given.get("rows") === "none";
  return {
    camera, look, planes: isOwn ? rows as Plane[] : null, hidden, section: given.get("section") ?? "",
    seams: given.get("seams") === "shown", lines: given.get("lines") === "shown", notes: notes as Note[],
  };
}

/** The address that opens a state in another tab, with the token of this server. */
export function linkOf(state: ViewState): string {
  const fragment = fragmentOf(state);
  fragment.set("token", token);
  return `${location.origin}${location.pathname}#${fragment}`;
}

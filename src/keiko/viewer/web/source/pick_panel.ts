import { Note } from "./analysis";
import { Facts } from "./facts";
import { button, byId, element, showPairs } from "./panel";
import { Picked } from "./picture";
import { cross, difference, dot, length, Vector } from "./vector";

const numbers = (v: readonly number[], digits: number): string => v.map((n) => n.toFixed(digits)).join(", ");

/** A line for a note on a place, which Enter or a button keeps. */
function noteField(place: Vector, face: number, add: (note: Note) => void): HTMLElement {
  const input = element("input", "", { ariaLabel: "note", placeholder: "a note on this place", maxLength: 300 }) as HTMLInputElement;
  const keep = (): void => {
    if (input.value.trim()) add({ text: input.value.trim(), place, face });
    input.value = "";
  };
  input.onkeydown = (event) => { if (event.key === "Enter") keep(); };
  return element("p", [input, button("note", keep)]);
}

/** A radius of curvature in words; positive ones are those of hollows as the eye sees them. */
function radiusText(radius: number): string {
  const size = Math.abs(radius), flat = 1e6; // mm
  if (!(size < flat)) return "flat";
  const digits = Math.max(0, 3 - Math.floor(Math.log10(size)));
  return `${size.toFixed(digits)} mm ${radius > 0 ? "hollow" : "crowned"}`;
}

/** Distance and angle between two places in words. */
function apartText(a: Picked, b: Picked): string {
  const angle = Math.atan2(length(cross(a.normal, b.normal)), dot(a.normal, b.normal)) * 180 / Math.PI;
  return `${length(difference(b.place, a.place)).toFixed(3)} mm, normals ${angle.toFixed(3)}° apart`;
}

/** Shows what is known of a picked surface, and how far it is from the one before; `add` gets a note that is written on it. */
export function showPlace(at: Picked | null, before: Picked | null, facts: Facts, add: (note: Note) => void): void {
  byId("note").replaceChildren();
  if (!at) return showPairs(byId("pick"), [["nothing", ""]]);
  const face = at.face > 0 ? facts.faces[at.face - 1] : null;
  showPairs(byId("pick"), [
    ["face", face ? `${face.id} ${face.name}` : "ground"],
    ["place", `${numbers(at.place, 2)} mm`],
    ["rounding", `${at.rounding.toPrecision(1)} mm`],
    ["normal", numbers(at.normal, 4)],
    ["radii", at.radii.map(radiusText).join(", ")],
    ...before ? [["from the last", apartText(before, at)] as [string, string]] : [],
  ]);
  if (face) byId("note").replaceChildren(noteField(at.place, face.id, add));
}

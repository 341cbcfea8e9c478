import { Note } from "./analysis";
import { rayOf } from "./camera";
import { Facts } from "./facts";
import { button, byId, element, showPairs } from "./panel";
import { Picture } from "./picture";
import { scaled, sum, Vector } from "./vector";

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

/** Shows what is known of the surface at a pixel of the picture, and returns the place. `add` gets a note that is written on it. */
export function showPlace(picture: Picture, facts: Facts, x: number, y: number, add: (note: Note) => void): Vector | null {
  const at = picture.pick(x, y);
  byId("note").replaceChildren();
  if (!at) {
    showPairs(byId("pick"), [["nothing", ""]]);
    return null;
  }
  const { origin, direction } = rayOf(picture.surfaces!.camera, x + 0.5, y + 0.5), place = sum(origin, scaled(direction, at.t));
  const face = at.face > 0 ? facts.faces[at.face - 1] : null;
  showPairs(byId("pick"), [
    ["face", face ? `${face.id} ${face.name}` : "ground"],
    ["place", `${numbers(place, 2)} mm`],
    ["normal", numbers(at.normal, 4)],
    ["radii", at.radii.map(radiusText).join(", ")],
  ]);
  if (face) byId("note").replaceChildren(noteField(place, face.id, add));
  return place;
}

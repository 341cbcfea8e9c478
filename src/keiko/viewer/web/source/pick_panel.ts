import { Note } from "./analysis";
import { Facts } from "./facts";
import { button, byId, element, showPairs } from "./panel";
import { Picked } from "./picture";
import { ask, hiddenText, requestText } from "./server";
import { cross, difference, dot, length, Vector } from "./vector";

/** What is proved of a picked place, of keiko-pick/1. */
interface Proof { place: Vector; bound: number; unique: boolean; curvatures: [Range, Range] }
type Range = [number, number] | null; // 1/mm

/** What the panel asks of the page. */
export interface PickHost {
  readonly facts: Facts;
  /** The faces that are not shown, by their numbers in the file. */
  hidden(): number[];
  /** Keeps a note on a place. */
  addNote(note: Note): void;
  fail(error: unknown): void;
}

/** What is known of the last place that was picked, and how far it is from the one before. */
export class PickPanel {
  private last: Picked | null = null;
  private running = new AbortController();

  constructor(private readonly host: PickHost) {}

  /** Shows a place at once, and what is proved of it as soon as the server has traced it. */
  show(at: Picked | null): void {
    const before = this.last, face = at && at.face > 0 ? this.host.facts.faces[at.face - 1] : null;
    this.running.abort();
    byId("note").replaceChildren();
    if (!at) return showPairs(byId("pick"), [["nothing", ""]]);
    this.last = at;
    const name = face ? `${face.id} ${face.name}` : "ground", show = (proof: Proof | null, proving: string): void => showPairs(byId("pick"), [
      ["face", name], ["place", `${numbers(proof ? proof.place : at.place, 3)} mm`], ["proved to", proof ? boundText(proof) : proving],
      ["normal", numbers(at.normal, 4)],
      ["radii", at.radii.map((radius, i) => proof ? rangeText(proof.curvatures[i], radius) : radiusText(radius)).join(", ")],
      ...before ? [["from the last", apartText(before, at)] as [string, string]] : [],
    ]);
    show(null, "…");
    if (face) byId("note").replaceChildren(noteField(at.place, face.id, (note) => this.host.addNote(note)));
    this.running = new AbortController();
    void this.prove(at, show, this.running.signal);
  }

  private async prove({ camera, pixel }: Picked, show: (proof: Proof | null, proving: string) => void, signal: AbortSignal): Promise<void> {
    const more = `pixel = [${pixel.join(", ")}]\n${hiddenText(this.host.hidden())}`;
    try {
      const { picked }: { picked: Proof | null } = await (await ask("POST", "/pick", requestText(camera, undefined, more), signal)).json();
      if (!signal.aborted) show(picked, "nothing");
    } catch (error) {
      if (signal.aborted) return;
      show(null, "nothing");
      this.host.fail(error);
    }
  }
}

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

const flat = 1e6; // mm: larger radii are shown as flat
const sideOf = (radius: number): string => radius > 0 ? "hollow" : "crowned"; // as the eye sees it

function radiusText(radius: number): string {
  const size = Math.abs(radius);
  if (!(size < flat)) return "flat";
  return `${size.toFixed(Math.max(0, 3 - Math.floor(Math.log10(size))))} mm ${sideOf(radius)}`;
}

/** A radius with the proved bound of its error; `radius` is that of the deep buffer. */
function rangeText(range: Range, radius: number): string {
  if (!range) return `${radiusText(radius)}, not proved`;
  const [low, high] = range, least = 1 / Math.max(Math.abs(low), Math.abs(high));
  if (low <= 0 && high >= 0 && least <= flat) return `more than ${least.toPrecision(3)} mm either way`;
  if (least > flat) return `flat: more than ${Math.min(least, 1e12).toPrecision(3)} mm`;
  const middle = (1 / low + 1 / high) / 2, bound = Math.max(Math.abs(1 / low - 1 / high) / 2, 1e-15 * Math.abs(middle));
  const digits = Math.min(Math.max(-Math.floor(Math.log10(bound)), 0), 6);
  return `${Math.abs(middle).toFixed(digits)} ± ${boundDigits(bound + 0.5 * 10 ** -digits)} mm ${sideOf(middle)}`;
}

/** A bound with one digit, rounded up. */
function boundDigits(bound: number): string {
  if (!(bound > 0)) return "0";
  const unit = 10 ** Math.floor(Math.log10(bound));
  return (Math.ceil(bound / unit) * unit).toPrecision(1);
}

function boundText({ bound, unique }: Proof): string {
  return `${boundDigits(bound)} mm${unique ? ", the only hit of its surface piece" : ""}`;
}

/** Distance and angle between two places in words. */
function apartText(a: Picked, b: Picked): string {
  const angle = Math.atan2(length(cross(a.normal, b.normal)), dot(a.normal, b.normal)) * 180 / Math.PI;
  return `${length(difference(b.place, a.place)).toFixed(3)} mm, normals ${angle.toFixed(3)}° apart`;
}

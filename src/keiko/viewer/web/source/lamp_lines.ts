import { Measured, measureLine } from "./measured";
import { Vector } from "./vector";

/** A reflection line of keiko-lines/2, as far as the page shows it. */
export interface LampLine { pieces: { face: number; points: Vector[] }[] }

/** Where a line crosses a seam; the last three are there only where it goes on beyond. */
export interface Crossing {
  line: number;
  faces: string;
  verdict: string | null;
  place: Vector;
  turn: Measured;
  jump?: Measured;
  kink?: Measured;
  bend?: Measured;
}

/** The lines of a view, and their crossings, the worst first. */
export interface LampLines { lines: LampLine[]; crossings: Crossing[] }

const quantities: readonly { name: "turn" | "jump" | "kink" | "bend"; words: string; unit: string }[] = [
  { name: "jump", words: "jumps sideways by", unit: "\u00a0mm" },
  { name: "turn", words: "jumps as over an angle of", unit: "°" },
  { name: "kink", words: "kinks by", unit: "°" },
  { name: "bend", words: "changes its curvature by", unit: "\u00a0/mm" },
];

/** What a crossing fails first; undefined if it does not fail. */
export function failingOf(crossing: Crossing): string | undefined {
  return quantities.find(({ name }) => crossing[name]?.verdict === "fail")?.name;
}

/** A line of words for each quantity of a crossing, with the class of its verdict. */
export function measuresOf(crossing: Crossing): { words: string; verdict: string }[] {
  return quantities.flatMap(({ name, words, unit }) => {
    const measured = crossing[name];
    return measured ? [measureLine(words, measured, unit)] : [];
  });
}

const severity = ["pass", "undecided", "fail"];

/** The worst verdict of the crossings on each line; "none" without a judged one. */
export function verdictsOf({ lines, crossings }: LampLines): string[] {
  const worst = lines.map(() => -1);
  for (const { line, verdict } of crossings) if (verdict) worst[line] = Math.max(worst[line], severity.indexOf(verdict));
  return worst.map((at) => severity[at] ?? "none");
}

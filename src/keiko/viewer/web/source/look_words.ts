import { Look, looks } from "./picture";
import { Vector } from "./vector";

/** Curvatures that colours may stand for; the words of `keiko render --look curvature:KIND`. */
export const curvatureKinds = ["mean", "gauss", "k1", "k2", "absolute", "section"] as const;
export type CurvatureKind = typeof curvatureKinds[number];

/**
 * A look, and the curvature that the look of that name shows. That of sections is along parallel planes with the normal
 * `across`, as `keiko render --section` has it.
 */
export interface StatedLook { look: Look; kind: CurvatureKind; across: Vector }

const usual = { kind: "mean", across: [0, 1, 0] as Vector } as const; // of sections: the default of --section

/** The look at the start. */
export const firstLook: StatedLook = { look: "lamps", ...usual };

const words: Partial<Record<Look, string>> = { isophotes: "isophote", "highlight lines": "highlight" };

/** The word of a look in analyses and links, which `keiko render --look` takes but for faces. */
export function wordOf({ look, kind }: StatedLook, fullCurvature?: number): string {
  if (look !== "curvature") return words[look] ?? look;
  return `curvature:${kind}${fullCurvature ? `=${fullCurvature}` : ""}`;
}

/** True for the curvature of sections, whose planes have a direction. */
export const hasSections = ({ look, kind }: StatedLook): boolean => look === "curvature" && kind === "section";

/** The word of a direction, which `keiko render --section` takes. */
export const directionWord = (across: Vector): string => across.map((x) => Number(x.toPrecision(9))).join(",");

/** The direction of a word; null for another word, and for no direction. */
export function directionOf(word: string): Vector | null {
  const parts = word.split(",").map((part) => part.trim() ? Number(part) : NaN);
  return parts.length === 3 && parts.every(Number.isFinite) && parts.some((part) => part !== 0) ? parts as Vector : null;
}

/** The look of a word, sections with a normal of their planes; null if this page draws none of that name. */
export function lookOf(word: string, across: Vector = usual.across): StatedLook | null {
  const kind = curvatureKinds.find((name) => word.split("=")[0] === `curvature:${name}`);
  if (kind) return { look: "curvature", kind, across };
  const look = looks.find((name) => name !== "curvature" && (words[name] ?? name) === word);
  return look ? { ...usual, look } : null;
}

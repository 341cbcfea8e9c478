import { Look, looks } from "./picture";

/** Curvatures that colours may stand for; the words of `keiko render --look curvature:KIND`. */
export const curvatureKinds = ["mean", "gauss", "k1", "k2", "absolute"] as const;
export type CurvatureKind = typeof curvatureKinds[number];

/** A look, and the curvature that the look of that name shows. */
export interface StatedLook { look: Look; kind: CurvatureKind }

const words: Partial<Record<Look, string>> = { isophotes: "isophote", "highlight lines": "highlight" };

/** The word of a look in analyses and links, which `keiko render --look` takes but for faces. */
export function wordOf({ look, kind }: StatedLook, fullCurvature?: number): string {
  if (look !== "curvature") return words[look] ?? look;
  return `curvature:${kind}${fullCurvature ? `=${fullCurvature}` : ""}`;
}

/** The look of a word; null if this page draws none of that name. */
export function lookOf(word: string): StatedLook | null {
  const kind = curvatureKinds.find((name) => word.split("=")[0] === `curvature:${name}`);
  if (kind) return { look: "curvature", kind };
  const look = looks.find((name) => name !== "curvature" && (words[name] ?? name) === word);
  return look ? { look, kind: "mean" } : null;
}

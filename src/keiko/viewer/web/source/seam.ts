import { Measured, measureLine } from "./measured";
import { Vector } from "./vector";

/** A quantity of a seam at its worst place. */
interface SeamMeasured extends Measured { place: Vector }

/** A stretch of a seam in keiko-inspection/1, as far as the page shows it. */
export interface Seam {
  number: number;
  faces: string;
  face_ids: [number, number];
  verdict: string;
  kind: string;
  scrap: boolean;
  severity: number; // of the worst judged quantity, 1 at its limit
  length: number;
  middle: Vector;
  course: Vector[][]; // piece by piece
  gap: SeamMeasured;
  angle: SeamMeasured | null;
  curvature: SeamMeasured | null;
  curvature_slope: SeamMeasured | null;
  fading: SeamMeasured | null;
}

/** What is judged of a seam. `mending`: the word of the quantity in faults; `shown`: of 1 of its unit. */
interface Continuity { label: string; name: string; mending: string; of: (seam: Seam) => SeamMeasured | null; unit: string; shown: number }

const continuities: Continuity[] = [
  { label: "G0", name: "gap", mending: "position", of: (seam) => seam.gap, unit: "\u00a0mm", shown: 1 },
  { label: "G1", name: "angle", mending: "tangent", of: (seam) => seam.angle, unit: "°", shown: 1 },
  { label: "G2", name: "curvature mismatch", mending: "curvature", of: (seam) => seam.curvature, unit: "\u00a0%", shown: 100 },
  { label: "G3", name: "slope of curvature", mending: "curvature", of: (seam) => seam.curvature_slope, unit: "°", shown: 1 },
  { label: "run-out", name: "step where the crease fades", mending: "tangent", of: (seam) => seam.fading, unit: "°/mm", shown: 1 },
];

/** What a seam fails first; undefined if it does not fail. */
export function failing(seam: Seam): Continuity | undefined {
  return continuities.find(({ of }) => of(seam)?.verdict === "fail");
}

/** Where a seam fails first, or else its middle. */
export function worstPlace(seam: Seam): Vector {
  return failing(seam)?.of(seam)?.place ?? seam.middle;
}

/** A line of words for each quantity of a seam, with the class of its verdict. */
export function measures(seam: Seam): { words: string; verdict: string }[] {
  return continuities.flatMap(({ label, name, of, unit, shown }) => {
    const measured = of(seam);
    return measured ? [measureLine(`${label} ${name}`, measured, unit, shown)] : [];
  });
}

import { Camera } from "./camera";
import { Facts } from "./facts";
import { StatedLook } from "./look_words";
import { Display } from "./picture";
import { Vector } from "./vector";

/** What the parts of the panel ask of the page. */
export interface Host {
  readonly facts: Facts;
  /** The eye that is shown. */
  camera(): Camera;
  /** Lamps, look and exposure that are shown. */
  display(): Display;
  /** The faces that are not shown, by their numbers in the file. */
  hidden(): number[];
  /** Shows another look. */
  choose(look: StatedLook): void;
  /** Shows the scene from another eye, in a picture of the same size. */
  lookFrom(camera: Camera): void;
  /** Shows a place in the middle from where the eye is, near enough for what is some mm long there. */
  flyTo(place: Vector, long?: number): void;
  /** Marks a place over the picture, and the stretch of a seam that it is about, piece by piece. */
  mark(place: Vector, stretch?: Vector[][]): void;
  /** Shows the scene without some faces, by their numbers in the file. */
  hide(faces: number[]): void;
  /** Something else that a link restores has changed. */
  keep(): void;
  /** Tells the user a line. */
  tell(line: string): void;
  /** Tells the user of an error. */
  fail(error: unknown): void;
}

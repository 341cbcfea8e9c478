import { Camera } from "./camera";
import { Facts } from "./facts";
import { Display } from "./picture";

/** What the parts of the panel ask of the page. */
export interface Host {
  readonly facts: Facts;
  /** The eye that is shown. */
  camera(): Camera;
  /** Lamps, look and exposure that are shown. */
  display(): Display;
  /** Shows the scene from another eye, in a picture of the same size. */
  lookFrom(camera: Camera): void;
  /** Shows the scene without some faces, by their numbers in the file. */
  hide(faces: number[]): void;
  /** Tells the user of an error. */
  fail(error: unknown): void;
}

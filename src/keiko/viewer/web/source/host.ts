import { Camera } from "./camera";
import { Facts } from "./facts";

/** What the parts of the panel ask of the page. */
export interface Host {
  readonly facts: Facts;
  /** The eye that is shown. */
  camera(): Camera;
  /** Shows the scene from another eye, in a picture of the same size. */
  lookFrom(camera: Camera): void;
  /** Tells the user of an error. */
  fail(error: unknown): void;
}

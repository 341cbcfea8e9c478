import { Camera } from "./camera";
import { Plane } from "./facts";
import { afterMove, dragged, movedWithin, RowMove } from "./row_moves";
import { difference, length, Vector } from "./vector";

/** What the rows of lamps ask of the page. */
export interface RowsHost {
  camera(): Camera;
  /** The nearest row that a pixel of the picture mirrors; -1 without one. */
  rowAt(x: number, y: number): number;
  /** Where the reflection at a pixel meets the plane of a row; null if it does not. */
  mirroredOn(x: number, y: number, plane: Plane): Vector | null;
  /** Another row is chosen, or there are others. */
  rowChosen(): void;
  changed(isEye: boolean, isOver: boolean): void;
}

/** The rows of lamps that are shown, of which one is chosen to be moved. */
export class LampRows {
  chosen = 0;

  constructor(private planes: Plane[], private readonly host: RowsHost) {}

  get all(): Plane[] { return this.planes; }
  get row(): Plane | undefined { return this.planes[this.chosen]; }

  /** Takes other rows, without showing them. */
  take(planes: Plane[]): void {
    this.planes = planes;
  }

  /** Shows other rows. */
  set(planes: Plane[]): void {
    this.take(planes);
    this.choose(0);
    this.host.changed(false, true);
  }

  choose(row: number): void {
    this.chosen = row;
    this.host.rowChosen();
  }

  next(): void {
    this.choose((this.chosen + 1) % Math.max(this.planes.length, 1));
  }

  /** Chooses the row that a pixel of the picture mirrors. */
  grab(x: number, y: number): void {
    const row = this.host.rowAt(x, y);
    if (row >= 0 && row !== this.chosen) this.choose(row);
  }

  /**
   * Moves the chosen row in its plane so that its image follows the mouse from one pixel of the picture to another; the
   * caller shows it. Where the reflection jumps, or is none, the row moves as far as the mouse at the target.
   */
  follow(from: [number, number], to: [number, number]): void {
    const { row } = this;
    if (!row) return;
    const begin = this.host.mirroredOn(...from, row), end = this.host.mirroredOn(...to, row), step = begin && end && difference(end, begin);
    const farthest = 0.25 * Math.max(length(row.u), length(row.v));
    if (step && length(step) <= farthest) this.edit(this.chosen, (plane) => movedWithin(plane, step));
    else this.drag(to[0] - from[0], to[1] - from[1]);
  }

  /** Moves the chosen row in its plane, by pixels of the picture at the target; the caller shows it. */
  drag(x: number, y: number): void {
    this.edit(this.chosen, (plane) => dragged(plane, this.host.camera(), x, y));
  }

  /** Moves the chosen row by mm, or degrees. */
  move(move: RowMove, amount: number, isOver = true): void {
    this.edit(this.chosen, (plane) => afterMove(plane, move, amount));
    this.host.changed(false, isOver);
  }

  /** Shows another row in place of one. */
  change(row: number, plane: Plane): void {
    this.edit(row, () => plane);
    this.host.changed(false, true);
  }

  private edit(row: number, change: (plane: Plane) => Plane): void {
    this.planes = this.planes.map((plane, i) => i === row ? change(plane) : plane);
  }
}

import { Note } from "./analysis";
import { EyeOverlay } from "./eye_overlay";
import { Host } from "./host";
import { button, element } from "./panel";
import { Projection } from "./projection";

/** Notes on places of the part: numbers over the picture, and a list; a click flies to the place. */
export class Notes {
  private notes: Note[] = [];
  private readonly marks: EyeOverlay;

  /** `changed` is called after each change by the user. */
  constructor(private readonly into: HTMLElement, private readonly host: Host, picture: HTMLElement, private readonly changed: () => void) {
    this.marks = new EyeOverlay("note-marks", picture, () => host.camera(), (context, camera) => {
      const projection = new Projection(camera);
      this.notes.forEach((note, i) => {
        if (projection.set(note.place)) mark(context, projection.x, projection.y, String(i + 1));
      });
    });
  }

  get all(): Note[] {
    return this.notes;
  }

  show(notes: Note[]): void {
    this.notes = notes;
    this.marks.show(notes.length > 0);
    this.into.replaceChildren(notes.length > 0
      ? element("ol", notes.map((note) => this.entry(note)))
      : element("p", "Click on the body and write one beside it.", { className: "soft" }));
  }

  add(note: Note): void {
    this.show([...this.notes, note]);
    this.changed();
  }

  private entry(note: Note): HTMLElement {
    const remove = button("×", () => {
      this.show(this.notes.filter((other) => other !== note));
      this.changed();
    });
    remove.title = "remove the note";
    const lost = note.face > 0 ? [] : [element("div", "not on this part any more", { className: "soft" })];
    return element("li", [button(note.text, () => this.host.flyTo(note.place)), remove, ...lost]);
  }
}

function mark(context: CanvasRenderingContext2D, x: number, y: number, text: string): void {
  const radius = 9; // px
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fillStyle = "#ffd23a", context.strokeStyle = "#222";
  context.fill(), context.stroke();
  context.fillStyle = "#222", context.font = "bold 12px sans-serif";
  context.textAlign = "center", context.textBaseline = "middle";
  context.fillText(text, x, y + 0.5);
}

import { Host } from "./host";
import { button, element } from "./panel";
import { ask } from "./server";

/** The bodies and faces of keiko-model-facts/1, as far as the tree shows them. */
interface ModelFacts {
  part_list: { name: string }[];
  face_list: { id: number; name: string; part: number; layer: string }[];
}

/** A box that shows or hides faces; a click on its name shows them alone. */
function row(name: string, faces: number[], boxes: Map<number, HTMLInputElement[]>, changed: () => void): HTMLElement {
  const own = new Set(faces);
  const box = element("input", "", { type: "checkbox", checked: true, ariaLabel: `show ${name}` }) as HTMLInputElement;
  box.onchange = () => {
    for (const face of faces) for (const each of boxes.get(face)!) each.checked = box.checked;
    changed();
  };
  const alone = button(name, () => {
    for (const [face, all] of boxes) for (const each of all) each.checked = own.has(face);
    changed();
  });
  alone.title = "show this alone";
  if (faces.length === 1) boxes.set(faces[0], [...boxes.get(faces[0]) ?? [], box]);
  return element("span", [box, alone]);
}

function body(facts: ModelFacts, part: number, boxes: Map<number, HTMLInputElement[]>, changed: () => void): HTMLElement {
  const faces = facts.face_list.filter((face) => face.part === part);
  const leaves = faces.map((face) => element("li", [row(`${face.id} ${face.name}`, [face.id], boxes, changed)]));
  const name = facts.part_list[part].name || `body ${part + 1}`;
  return element("details", [
    element("summary", [row(`${name} (${faces.length})`, faces.map((face) => face.id), boxes, changed)]),
    element("ul", leaves),
  ], { open: facts.part_list.length === 1 });
}

/** A button that fetches the tree of bodies and faces; boxes hide, names isolate. */
export class Tree {
  private readonly boxes = new Map<number, HTMLInputElement[]>();

  constructor(private readonly into: HTMLElement, private readonly host: Host) {
    into.replaceChildren(button("list", () => void this.fetch()));
  }

  /** Takes over which faces are hidden. */
  update(): void {
    const hidden = new Set(this.host.hidden());
    for (const [face, boxes] of this.boxes) for (const box of boxes) box.checked = !hidden.has(face);
    for (const body of this.into.querySelectorAll("details")) {
      const [all, ...faces] = body.querySelectorAll<HTMLInputElement>("input");
      all.checked = faces.some((box) => box.checked);
    }
  }

  private async fetch(): Promise<void> {
    try {
      this.show(await (await ask("GET", "/facts")).json());
    } catch (error) {
      this.host.fail(error);
    }
  }

  private show(facts: ModelFacts): void {
    const hide = (): void => {
      this.host.hide([...this.boxes].filter(([, [box]]) => !box.checked).map(([face]) => face));
    };
    const parts = facts.part_list.map((_, part) => body(facts, part, this.boxes, hide));
    this.into.replaceChildren(button("show all", () => this.host.hide([])), ...parts);
    this.update();
  }
}

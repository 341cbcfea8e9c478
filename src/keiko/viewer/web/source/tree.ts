import { Facts } from "./facts";
import { Host } from "./host";
import { button, element } from "./panel";

type Boxes = Map<number, HTMLInputElement[]>; // by face

/** A box that shows or hides faces; a click on its name shows them alone. */
function row(name: string, faces: number[], boxes: Boxes, changed: () => void): HTMLElement {
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

const openFaces = 50; // of a body whose faces are listed at once

function body({ parts, faces }: Facts, part: number, boxes: Boxes, changed: () => void): HTMLElement {
  const own = faces.filter((face) => face.part === part), name = parts[part] || `body ${part + 1}`;
  const leaves = own.map((face) => element("li", [row(`${face.id} ${face.name}`.trim(), [face.id], boxes, changed)]));
  return element("details", [
    element("summary", [row(`${name} (${own.length})`, own.map((face) => face.id), boxes, changed)]),
    element("ul", leaves),
  ], { open: parts.length === 1 && own.length <= openFaces });
}

/** The bodies and faces: boxes hide, names isolate, and a line of text finds faces by number or name. */
export class Tree {
  private readonly boxes: Boxes = new Map();

  constructor(private readonly into: HTMLElement, private readonly host: Host) {
    const hide = (): void => {
      host.hide([...this.boxes].filter(([, [box]]) => !box.checked).map(([face]) => face));
    };
    const find = element("input", "", { type: "search", placeholder: "find a face", ariaLabel: "find a face" }) as HTMLInputElement;
    find.oninput = () => this.find(find.value.trim().toLowerCase());
    into.replaceChildren(button("show all", () => host.hide([])), find,
      ...host.facts.parts.map((_, part) => body(host.facts, part, this.boxes, hide)));
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

  /** Lists the faces that have a text in their number or name; all for an empty one. */
  private find(text: string): void {
    for (const body of this.into.querySelectorAll("details")) {
      const leaves = [...body.querySelectorAll("li")];
      for (const leaf of leaves) leaf.hidden = !leaf.textContent!.toLowerCase().includes(text);
      if (text) body.open = leaves.some((leaf) => !leaf.hidden);
    }
  }
}

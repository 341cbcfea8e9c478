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
  const box = element("input", "", { type: "checkbox", checked: true, ariaLabel: `show ${name}` }) as HTMLInputElement;
  box.onchange = () => {
    for (const face of faces) for (const each of boxes.get(face)!) each.checked = box.checked;
    changed();
  };
  const alone = button(name, () => {
    for (const [face, all] of boxes) for (const each of all) each.checked = faces.includes(face);
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
export function treePanel(into: HTMLElement, host: Host): void {
  const show = (facts: ModelFacts): void => {
    const boxes = new Map<number, HTMLInputElement[]>();
    const changed = (): void => host.hide([...boxes].filter(([, [box]]) => !box.checked).map(([face]) => face));
    const all = (): void => {
      for (const box of into.querySelectorAll("input")) box.checked = true;
      changed();
    };
    const parts = facts.part_list.map((_, part) => body(facts, part, boxes, changed));
    into.replaceChildren(button("show all", all), ...parts);
  };
  const fetchAll = async (): Promise<void> => {
    try {
      show(await (await ask("GET", "/facts")).json());
    } catch (error) {
      host.fail(error);
    }
  };
  into.replaceChildren(button("list", () => void fetchAll()));
}

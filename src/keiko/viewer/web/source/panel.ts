import { Facts, Plane } from "./facts";

/** An element with text or children. */
export function element(tag: string, content: string | Node[] = "", properties: object = {}): HTMLElement {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...(typeof content === "string" ? [content] : content));
  return made;
}

export const byId = (id: string): HTMLElement => document.getElementById(id)!;

export function button(name: string, act: () => void): HTMLElement {
  return element("button", name, { onclick: act, type: "button" });
}

/** Hands a file to the user. */
export function download(name: string, bytes: Blob): void {
  const href = URL.createObjectURL(bytes);
  element("a", "", { href, download: name }).click();
  URL.revokeObjectURL(href);
}

/** The text of a file that the user picks, whose name ends as stated. */
export function pickedText(ending: string): Promise<string> {
  const input = element("input", "", { type: "file", accept: ending }) as HTMLInputElement;
  return new Promise((use) => {
    input.onchange = () => { if (input.files?.[0]) use(input.files[0].text()); };
    input.click();
  });
}

/** Fills a list with entries, the first of them at once and the others on request; `words` names how many are left. */
export function longList<Item>(into: HTMLElement, items: Item[], entry: (item: Item) => HTMLElement, atOnce: number,
  words: (left: number) => string): HTMLElement {
  into.append(...items.slice(0, atOnce).map(entry));
  if (items.length <= atOnce) return into;
  const more = button(words(items.length - atOnce), () => {
    into.append(...items.slice(atOnce).map(entry));
    more.remove();
  });
  return element("div", [into, more]);
}

/** Buttons of which one is pressed. */
export function choice(into: HTMLElement, names: readonly string[], pressed: string, choose: (name: string) => void): void {
  into.replaceChildren(...names.map((name) => {
    const made = button(name, () => {
      choice(into, names, name, choose);
      choose(name);
    });
    made.setAttribute("aria-pressed", String(name === pressed));
    return made;
  }));
}

/** A list of which one is chosen. */
export function selection(name: string, options: readonly string[], chosen: string, choose: (option: string) => void): HTMLElement {
  const list = element("select", options.map((option) => element("option", option, { selected: option === chosen })), { ariaLabel: name });
  list.onchange = () => choose((list as HTMLSelectElement).value);
  return element("label", [new Text(`${name} `), list]);
}

/** Name and value, as entries of a list. */
export function showPairs(list: HTMLElement, pairs: [string, string][]): void {
  list.replaceChildren(...pairs.flatMap(([name, value]) => [element("dt", name), element("dd", value)]));
}

export function showFacts(facts: Facts): void {
  const { lower, upper } = facts.bounds;
  const size = upper.map((x, i) => (x - lower[i]).toFixed(0)).join(" × ");
  showPairs(byId("facts"), [
    ["file", facts.inputs.join(", ")], ["view", facts.view], ["faces", String(facts.faces.length)],
    ["size", `${size} mm`], ["materials", facts.materials.map((m) => m.name).join(", ")],
    ["Keiko", facts.tool.version],
    ...facts.remarks.map(({ entity, message }): [string, string] => ["note", `${entity} ${message}`]),
  ]);
}

/** The rows of lamps: which one is dragged, and its numbers. `change` gets the row after an edit. */
export function showRows(planes: Plane[], selected: number, select: (row: number) => void,
  change: (row: number, plane: Plane) => void): void {
  const number = (row: number, key: "lamps" | "diameter" | "pitch", least: number): HTMLElement => {
    const input = element("input", "", {
      type: "number", min: least, value: String(Number(planes[row][key].toFixed(2))), ariaLabel: key,
    }) as HTMLInputElement;
    input.onchange = () => {
      const value = Number(input.value);
      if (value >= least) change(row, { ...planes[row], [key]: key === "lamps" ? Math.round(value) : value });
    };
    return input;
  };
  const lines = planes.map((_, row) => element("tr", [
    element("td", [element("input", "", { type: "radio", name: "row", checked: row === selected, onchange: () => select(row) })]),
    element("td", [number(row, "lamps", 1)]), element("td", [number(row, "pitch", 1)]),
    element("td", [number(row, "diameter", 1)]),
  ]));
  const head = element("tr", ["row", "lamps", "pitch mm", "Ø mm"].map((name) => element("th", name)));
  byId("rows").replaceChildren(element("table", [head, ...lines]));
}

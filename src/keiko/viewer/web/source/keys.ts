import { Key, showDialog } from "./help";
import { mouseHelp } from "./mouse";
import { Look } from "./picture";
import { act, PointerHost } from "./pointer";

/** What keys do to the page besides what the mouse does. */
export interface KeyHost extends PointerHost {
  views(): { name: string; show: () => void }[];
  chooseLook(look: Look): void;
  savePicture(): void;
  /** Draws the seams over the picture, or takes them off. */
  toggleSeams(): void;
  /** Draws the lines of the lamps over the picture, or takes them off. */
  toggleLines(): void;
}

const lookKeys: Record<string, Look> = {
  l: "lamps", z: "zebra", i: "isophotes", h: "highlight lines", c: "curvature", m: "radius", d: "draft", f: "faces",
};
const arrowStep = 10; // px
const arrows: Record<string, [number, number]> = {
  ArrowLeft: [-arrowStep, 0], ArrowRight: [arrowStep, 0], ArrowUp: [0, -arrowStep], ArrowDown: [0, arrowStep],
};

function keysOf(host: KeyHost): Key[] {
  const step = 50, angle = 2; // mm, degrees
  return [
    ...Object.entries(lookKeys).map(([key, look]) => ({ key, words: look, act: () => host.chooseLook(look) })),
    ...host.views().map(({ name, show }, i) => ({ key: String(i), words: `view: ${name}`, act: show })),
    { key: "n", words: "the next row of lamps", act: () => host.lamps.next() },
    { key: "+", words: "row 50 mm along its normal", act: () => host.lamps.move("normal", step) },
    { key: "-", words: "row 50 mm back", act: () => host.lamps.move("normal", -step) },
    { key: "[", words: "turn the row by 2 degrees", act: () => host.lamps.move("turn", angle) },
    { key: "]", words: "turn the row back", act: () => host.lamps.move("turn", -angle) },
    { key: "s", words: "seams over the picture, by verdict", act: () => host.toggleSeams() },
    { key: "r", words: "reflection lines of the lamps over the picture", act: () => host.toggleLines() },
    { key: "p", words: "the picture as a file, with its command line", act: () => host.savePicture() },
    { key: "?", words: "this list", act: () => showKeys(host) },
  ];
}

/** Opens the list of keys and of what the mouse does. */
export function showKeys(host: KeyHost): void {
  showDialog("Keys and mouse", [
    ["mouse", `${mouseHelp[host.style()]}; wheel zooms`], ["Ctrl + drag", "moves the chosen row of lamps in its plane"],
    ["Ctrl + Shift + drag", "turns the section plane"],
    ["click", "place, normal and radii; on a seam its verdict"], ["arrows", "turn; with Shift pan; with Ctrl move the row; with both turn the section"],
    ...keysOf(host).map(({ key, words }) => [key, words] as const),
  ]);
}

/** Keys on the picture. */
export function listenToKeys(canvas: HTMLCanvasElement, host: KeyHost): void {
  const keys = new Map(keysOf(host).map((key) => [key.key, key.act]));
  canvas.onkeydown = (event) => {
    const way = arrows[event.key], does = keys.get(event.key);
    if (!way && !does || event.altKey) return;
    if (does && (event.ctrlKey || event.metaKey)) return;
    event.preventDefault();
    if (does) return does();
    const action = event.ctrlKey ? event.shiftKey ? "section" : "lamps" : event.shiftKey ? "pan" : "orbit";
    act(host, action, ...way);
    if (action !== "section") host.changed(action !== "lamps", true);
  };
}

import { showInColours } from "./colours";
import { Facts, Plane } from "./facts";
import { faultsPanel } from "./faults";
import { KeyHost, showKeys } from "./keys";
import { lampButtons, LampsHost, showLamps } from "./lamps_panel";
import { curvatureKinds, CurvatureKind, directionOf, directionWord, StatedLook } from "./look_words";
import { MouseStyle, mouseStyles } from "./mouse";
import { button, byId, choice, download, element, selection, showFacts } from "./panel";
import { Look, looks } from "./picture";
import { viewText } from "./server";
import { unit, Vector } from "./vector";

const shownViews = ["front", "rear", "left", "right", "top", "three-quarter-front", "three-quarter-rear"];

/** What the panel asks of the page besides. */
export interface PageHost extends LampsHost, KeyHost {
  copyLink(): void;
  setStyle(style: MouseStyle): void;
}

/** The views that are one click away: that of the start, those of a report, and the usual ones. */
export function namedViews(facts: Facts): { name: string; camera: Facts["camera"] }[] {
  return [{ name: "opened", camera: facts.camera }, ...facts.own_views, ...facts.views.filter(({ name }) => shownViews.includes(name))];
}

/** Shows which look is chosen; `row`: the chosen one, whose lamps sections may be across. */
export function showLooks(stated: StatedLook, row: Plane | undefined, choose: (look: StatedLook) => void): void {
  const { look, kind } = stated;
  choice(byId("look-buttons"), looks, look, (name) => choose({ ...stated, look: name as Look }));
  byId("curvature-kind").replaceChildren(...look === "curvature" ? [
    selection("of", curvatureKinds, kind, (name) => choose({ ...stated, kind: name as CurvatureKind })),
    ...kind === "section" ? sectionDirection(stated, row, choose) : [],
  ] : []);
}

/** Which way the planes of sections face: along an axis, along the lamps of a row, or as numbers say. */
function sectionDirection(stated: StatedLook, row: Plane | undefined, choose: (look: StatedLook) => void): HTMLElement[] {
  const known: Record<string, Vector> = { x: [1, 0, 0], y: [0, 1, 0], z: [0, 0, 1], ...row ? { lamps: unit(row.u) } : {} };
  const named = Object.keys(known).find((name) => directionWord(known[name]) === directionWord(stated.across)) ?? "";
  const input = element("input", "", { ariaLabel: "normal of the planes", value: directionWord(stated.across), size: 14 }) as HTMLInputElement;
  input.onchange = () => {
    const across = directionOf(input.value);
    if (across) choose({ ...stated, across });
    else input.value = directionWord(stated.across);
  };
  return [selection("across", ["", ...Object.keys(known)], named, (name) => { if (name) choose({ ...stated, across: known[name] }); }), input];
}

/** A list of the views that have no button: from higher up, or from the eye of somebody who stands there. */
function moreViews(host: PageHost): HTMLElement {
  const views = host.facts.views.filter(({ name }) => !shownViews.includes(name));
  return selection("more", ["", ...views.map(({ name }) => name)], "", (chosen) => {
    const view = views.find(({ name }) => name === chosen);
    if (view) host.lookFrom(view.camera);
  });
}

/** Fills the panel beside the picture, but for the parts that keep something. */
export function showPanel(host: PageHost): void {
  byId("views").replaceChildren(...host.views().map(({ name, show }) => button(name, show)), moreViews(host),
    button("save view", () => download("view.toml", new Blob([viewText(host.camera())]))));
  showLamps(host);
  lampButtons(host);
  faultsPanel(byId("faults"), host);
  byId("page").replaceChildren(button("picture", () => host.savePicture()), button("copy link", () => host.copyLink()),
    button("keys", () => showKeys(host)),
    selection("mouse", mouseStyles, host.style(), (style) => host.setStyle(style as MouseStyle)),
    selection("colours", ["light dark", "light", "dark"], localStorage.getItem("colours") ?? "light dark", showInColours));
  showFacts(host.facts);
}

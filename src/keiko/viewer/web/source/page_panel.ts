import { showInColours } from "./colours";
import { comparePanel } from "./compare";
import { Facts } from "./facts";
import { faultsPanel } from "./faults";
import { KeyHost, showKeys } from "./keys";
import { lampButtons, LampsHost, showLamps } from "./lamps_panel";
import { curvatureKinds, CurvatureKind, StatedLook } from "./look_words";
import { MouseStyle, mouseStyles } from "./mouse";
import { button, byId, choice, download, selection, showFacts } from "./panel";
import { Look, looks } from "./picture";
import { viewText } from "./server";

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

/** Shows which look is chosen. */
export function showLooks({ look, kind }: StatedLook, choose: (look: StatedLook) => void): void {
  choice(byId("look-buttons"), looks, look, (name) => choose({ look: name as Look, kind }));
  byId("curvature-kind").replaceChildren(...look === "curvature" ? [
    selection("of", curvatureKinds, kind, (name) => choose({ look, kind: name as CurvatureKind })),
  ] : []);
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
export function showPanel(host: PageHost, canvas: HTMLElement): void {
  byId("views").replaceChildren(...host.views().map(({ name, show }) => button(name, show)), moreViews(host),
    button("save view", () => download("view.toml", new Blob([viewText(host.camera())]))));
  showLamps(host);
  lampButtons(host);
  faultsPanel(byId("faults"), host);
  comparePanel(byId("compare"), host, canvas);
  byId("page").replaceChildren(button("picture", () => host.savePicture()), button("copy link", () => host.copyLink()),
    button("keys", () => showKeys(host)),
    selection("mouse", mouseStyles, host.style(), (style) => host.setStyle(style as MouseStyle)),
    selection("colours", ["light dark", "light", "dark"], localStorage.getItem("colours") ?? "light dark", showInColours));
  showFacts(host.facts);
}

import { Camera, lookingAt } from "./camera";
import { Host } from "./host";
import { button, element, longList } from "./panel";
import { Profile, profilePlot } from "./profile_plot";
import { ask, requestText } from "./server";
import { difference, length, Vector } from "./vector";

/** A fault of keiko-faults/1, as far as the page shows it. */
export interface Fault {
  mending: string;
  verdict: string;
  faces: string;
  message: string;
  place: Vector;
  view: string;
  length: number;
  visible: number;
  width: number;
  mirrored: boolean;
  profile: Profile | null;
}

/** The stretch that a profile is of, piece by piece. */
function stretchOf({ samples }: Profile): Vector[][] {
  const pieces = new Map<number, Vector[]>();
  for (const { piece, place } of samples) pieces.set(piece, [...pieces.get(piece) ?? [], place]);
  return [...pieces.values()];
}

interface Faults { verdict: string; items: Fault[]; hidden: Fault[] }

/** Share of the body's size that a close-up shows from top to bottom. */
const shown = 0.16;

/** The eye of the view that shows most of a fault, turned to the fault. */
export function closeUp(host: Host, fault: Fault): Camera {
  const { upper, lower } = host.facts.bounds, height = shown * length(difference(upper, lower));
  const view = host.facts.views.find(({ name }) => name === fault.view);
  if (!view) return lookingAt(host.camera(), fault.place, 3 * height);
  const away = length(difference(fault.place, view.camera.eye));
  return {
    ...view.camera, target: fault.place, orthographic_height: height,
    vertical_fov: 2 * Math.atan(height / (2 * away)) * 180 / Math.PI,
  };
}

function sightOf(fault: Fault): string {
  const seen = fault.width >= 0.05 ? ` · breaks a reflection by ${fault.width.toFixed(1)}′` : "";
  const long = fault.length > 0 ? ` · ${fault.length.toFixed(1)} mm, ${(100 * fault.visible).toFixed(0)} % visible` : "";
  return fault.mending + seen + long + (fault.mirrored ? " · on both sides" : "");
}

function entry(host: Host, fault: Fault): HTMLElement {
  const into = element("div");
  const go = (): void => {
    host.lookFrom(closeUp(host, fault));
    host.mark(fault.place, fault.profile ? stretchOf(fault.profile) : []);
    for (const other of document.querySelectorAll("#faults button")) other.removeAttribute("aria-pressed");
    named.setAttribute("aria-pressed", "true");
    if (fault.profile) into.replaceChildren(profilePlot(fault.profile, fault.mending));
  };
  const named = button(fault.faces, go);
  return element("li", [
    named, element("div", fault.message, { className: fault.verdict }),
    element("div", sightOf(fault), { className: "soft" }), into,
  ]);
}

const atOnce = 20; // entries of a list

const list = (host: Host, faults: Fault[], start: number): HTMLElement =>
  longList(element("ol", "", { start }), faults, (fault) => entry(host, fault), atOnce, (left) => `${left} more`);

/** Buttons that fetch the faults in the order of mending, of the body alone or under the lamps too; a click on one flies there. */
export function faultsPanel(into: HTMLElement, host: Host): void {
  const found = element("div");
  const fetchAll = async (reply: Promise<Response>): Promise<void> => {
    try {
      host.tell("inspecting");
      const { items, hidden }: Faults = await (await reply).json();
      found.replaceChildren(items.length + hidden.length > 0 ? list(host, items, 1) : element("p", "no faults"));
      if (hidden.length > 0) found.append(element("p", "In hidden places:"), list(host, hidden, items.length + 1));
      host.tell(`${items.length + hidden.length} faults, in the order of mending`);
    } catch (error) {
      host.fail(error);
    }
  };
  const withLines = button("with lines of these lamps",
    () => void fetchAll(ask("POST", "/inspect", requestText(host.camera(), host.display().planes))));
  withLines.title = "judges the lamps' reflection lines in this view, too";
  into.replaceChildren(button("inspect", () => void fetchAll(ask("GET", "/inspect"))), withLines, found);
}

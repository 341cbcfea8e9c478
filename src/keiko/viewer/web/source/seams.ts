import { Seam } from "./facts";
import { Host } from "./host";
import { button, element } from "./panel";
import { ask } from "./server";

const order = ["fail", "undecided", "pass"];

/** The seams, the worst first; a click flies there. */
function list(host: Host, seams: Seam[]): HTMLElement {
  const sorted = [...seams].sort((a, b) => order.indexOf(a.verdict) - order.indexOf(b.verdict) || a.number - b.number);
  return element("table", sorted.map((seam) => element("tr", [
    element("td", seam.verdict, { className: seam.verdict }), element("td", seam.kind),
    element("td", [button(seam.faces, () => host.flyTo(seam.middle))]),
  ])));
}

/** A button that judges the seams and lists them. */
export function seamsPanel(into: HTMLElement, host: Host): void {
  const judge = async (): Promise<void> => {
    try {
      host.tell("judging the seams");
      const { seams }: { seams: Seam[] } = await (await ask("GET", "/seams")).json();
      into.replaceChildren(seams.length > 0 ? list(host, seams) : element("p", "no seams"));
      host.tell(`${seams.length} stretches of seams, the worst first`);
    } catch (error) {
      host.fail(error);
    }
  };
  into.replaceChildren(button("judge", () => void judge()));
}

import { Seam } from "./facts";
import { Host } from "./host";
import { button, element } from "./panel";
import { ask } from "./server";

const order = ["fail", "undecided", "pass"];

function entry(host: Host, seam: Seam): HTMLElement {
  return element("tr", [
    element("td", seam.verdict, { className: seam.verdict }), element("td", seam.kind),
    element("td", [button(seam.faces, () => host.flyTo(seam.middle))]),
  ]);
}

const atOnce = 20; // entries of a list in which nothing fails

/** The seams, the worst first; many that pass on request. A click flies there. */
function list(host: Host, seams: Seam[]): HTMLElement {
  const sorted = [...seams].sort((a, b) => order.indexOf(a.verdict) - order.indexOf(b.verdict) || a.number - b.number);
  const faulty = sorted.filter((seam) => seam.verdict !== "pass").length, first = Math.max(faulty, atOnce);
  const shown = element("table", sorted.slice(0, first).map((seam) => entry(host, seam))), left = sorted.slice(first);
  if (left.length === 0) return shown;
  const more = button(`${left.length} more, which pass`, () => {
    shown.append(...left.map((seam) => entry(host, seam)));
    more.remove();
  });
  return element("div", [shown, more]);
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

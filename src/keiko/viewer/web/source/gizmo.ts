import { axesOf, Camera } from "./camera";
import { Plane } from "./facts";
import { mmOfPixel, rowAxes, RowMove } from "./row_moves";
import { dot, Vector } from "./vector";

const size = 130, reach = 44; // px
const handles: readonly { move: RowMove; color: string; title: string }[] = [
  { move: "along", color: "#e05050", title: "move the row along its lamps" },
  { move: "across", color: "#50c050", title: "move the row across its lamps" },
  { move: "normal", color: "#5090ff", title: "move the row along its normal" },
];

function shape(tag: string, attributes: Record<string, string | number>, title = ""): SVGElement {
  const made = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, String(value));
  if (title) made.append(Object.assign(document.createElementNS("http://www.w3.org/2000/svg", "title"), { textContent: title }));
  return made;
}

/** The axes of the chosen row in the corner of the picture, by which it is dragged: three arrows, a ring and a knob. */
export class Gizmo {
  private readonly root: SVGElement;
  private grabbed: { move: RowMove; way: [number, number]; x: number; y: number } | null = null;

  /** `act` gets moves in mm or degrees, and true at the end of a drag. */
  constructor(parent: HTMLElement, private readonly act: (move: RowMove, amount: number, isOver: boolean) => void) {
    this.root = shape("svg", { id: "gizmo", width: size, height: size, viewBox: `${-size / 2} ${-size / 2} ${size} ${size}` });
    parent.append(this.root);
  }

  /** Draws the axes of a row as a camera sees them; nothing without a row. */
  show(plane: Plane | undefined, camera: Camera): void {
    if (this.grabbed) return;
    this.root.replaceChildren();
    if (!plane) return;
    const { right, up } = axesOf(camera), axes = rowAxes(plane), pixel = 1 / mmOfPixel(camera);
    const least = 0.26; // an axis that points to the eye is taken for one at 15 degrees to it
    const project = (axis: Vector): [number, number] => {
      const x = dot(axis, right), y = -dot(axis, up), length = Math.hypot(x, y);
      return length > least ? [x, y] : length > 0 ? [x * least / length, y * least / length] : [0, -least];
    };
    this.handle(shape("circle", { r: reach + 14, fill: "none", stroke: "#c0a030", "stroke-width": 5 }, "turn the row about its normal"), "turn", [-1.5, 0]);
    for (const { move, color, title } of handles) {
      const [x, y] = project(axes[move as "along"]);
      this.handle(shape("line", { x2: reach * x, y2: reach * y, stroke: color, "stroke-width": 6, "stroke-linecap": "round" }, title), move, [x * pixel, y * pixel]);
      this.handle(shape("circle", { cx: reach * x, cy: reach * y, r: 7, fill: color }, title), move, [x * pixel, y * pixel]);
    }
    this.handle(shape("circle", { r: 8, fill: "#ddd" }, "tilt the row about its lamps"), "tilt", [0, 4]);
  }

  /** Lets a shape be dragged; `way`: pixels that a mm or a degree takes in the picture. */
  private handle(element: SVGElement, move: RowMove, way: [number, number]): void {
    element.setAttribute("data-move", move);
    element.onpointerdown = (event) => {
      element.setPointerCapture(event.pointerId);
      this.grabbed = { move, way, x: event.clientX, y: event.clientY };
    };
    element.onpointermove = (event) => {
      const { grabbed } = this;
      if (!grabbed) return;
      this.act(move, this.amount(event.clientX - grabbed.x, event.clientY - grabbed.y, grabbed.way), false);
      grabbed.x = event.clientX, grabbed.y = event.clientY;
    };
    element.onpointerup = () => {
      this.grabbed = null;
      this.act(move, 0, true);
    };
    this.root.append(element);
  }

  /** mm or degrees of a drag by pixels. */
  private amount(x: number, y: number, [byX, byY]: [number, number]): number {
    return (x * byX + y * byY) / (byX * byX + byY * byY);
  }
}

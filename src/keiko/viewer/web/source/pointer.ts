import { Camera, dollied, orbited, panned } from "./camera";
import { LampRows } from "./lamp_rows";
import { mouseAction, MouseAction, MouseStyle } from "./mouse";

/** What the mouse does to the page. */
export interface PointerHost {
  readonly lamps: LampRows;
  camera(): Camera;
  style(): MouseStyle;
  setCamera(camera: Camera): void;
  /** Something has moved: the eye, or lamps. `isOver`: no more of this drag will come. */
  changed(isEye: boolean, isOver: boolean): void;
  /** The section is turned by a drag of the picture by pixels. */
  turnSection(x: number, y: number): void;
  /** A click on a pixel of the picture. */
  pick(x: number, y: number): void;
}

const rest = 300; // ms without a turn of the wheel after which it has come to rest
const threshold = 3; // px that a click may move

/** Does what a drag by pixels of the picture means. */
export function act(host: PointerHost, action: MouseAction, x: number, y: number): void {
  const camera = host.camera();
  if (action === "lamps") host.lamps.drag(x, y);
  if (action === "section") return host.turnSection(x, y);
  if (action === "pan") host.setCamera(panned(camera, x, y));
  if (action === "zoom") host.setCamera(dollied(camera, Math.exp(y / 200)));
  if (action === "orbit") host.setCamera(orbited(camera, camera.target, -x / 200, -y / 200));
}

/** The mouse on the picture: drags, clicks and the wheel. */
export class Pointer {
  private drag: { x: number; y: number; pixel: [number, number]; action: MouseAction; moved: boolean } | null = null;
  private timer = 0;

  constructor(private readonly canvas: HTMLCanvasElement, private readonly host: PointerHost) {
    canvas.onpointerdown = (event) => this.press(event);
    canvas.onpointermove = (event) => this.move(event);
    canvas.onpointerup = (event) => this.release(event);
    canvas.oncontextmenu = (event) => event.preventDefault();
    canvas.onwheel = (event) => this.wheel(event);
  }

  /** The pixel of the picture under the mouse. */
  private pixel(event: PointerEvent): [number, number] {
    const { width, height } = this.canvas, box = this.canvas.getBoundingClientRect();
    return [Math.floor((event.clientX - box.left) / box.width * width), Math.floor((event.clientY - box.top) / box.height * height)];
  }

  private press(event: PointerEvent): void {
    const { canvas, host } = this, action = mouseAction(host.style(), event);
    canvas.setPointerCapture(event.pointerId);
    if (action === "lamps") host.lamps.grab(...this.pixel(event));
    this.drag = { x: event.clientX, y: event.clientY, pixel: this.pixel(event), action, moved: false };
  }

  private move(event: PointerEvent): void {
    const { drag, host } = this;
    if (!drag) return;
    const x = event.clientX - drag.x, y = event.clientY - drag.y;
    if (!drag.moved && Math.hypot(x, y) < threshold) return;
    // A second button changes what CATIA's middle one does.
    if (drag.action !== "lamps" && drag.action !== "section") drag.action = mouseAction(host.style(), event);
    if (drag.action === "none") return;
    const scale = host.camera().height / this.canvas.clientHeight, pixel = this.pixel(event);
    if (drag.action === "lamps") host.lamps.follow(drag.pixel, pixel);
    else act(host, drag.action, x * scale, y * scale);
    Object.assign(drag, { x: event.clientX, y: event.clientY, pixel, moved: true });
    if (drag.action !== "section") host.changed(drag.action !== "lamps", false);
  }

  private release(event: PointerEvent): void {
    const { drag } = this;
    this.drag = null;
    if (drag?.moved && drag.action !== "section") return this.host.changed(drag.action !== "lamps", true);
    if (!drag?.moved && event.button === 0) this.host.pick(...this.pixel(event));
  }

  private wheel(event: WheelEvent): void {
    const { host } = this;
    event.preventDefault();
    clearTimeout(this.timer);
    host.setCamera(dollied(host.camera(), Math.exp(event.deltaY / 1000)));
    host.changed(true, false);
    this.timer = window.setTimeout(() => host.changed(true, true), rest);
  }
}

import { Camera } from "./camera";
import { Facts, Plane, Rig } from "./facts";

/** The token comes in the address's fragment once, and stays for reloads of this page. */
function tokenOf(): string {
  const fragment = new URLSearchParams(location.hash.slice(1)), given = fragment.get("token");
  if (given) {
    sessionStorage.setItem("token", given);
    fragment.delete("token");
    history.replaceState(null, "", `#${fragment}`);
  }
  return sessionStorage.getItem("token") ?? "";
}

export const token = tokenOf();
const headers = { "X-Keiko-Token": token, "X-Keiko-Client": `page-${crypto.randomUUID()}` };

/** Sends a request; throws an error with the server's own words. */
export async function ask(method: string, path: string, body?: string, signal?: AbortSignal): Promise<Response> {
  const reply = await fetch(path, { method, headers, body: method === "GET" ? undefined : body ?? "", signal });
  if (reply.ok) return reply;
  const text = await reply.text();
  let reason = text;
  try {
    reason = JSON.parse(text).error;
  } catch {
    // It is no answer of this server: the text says what it is.
  }
  throw new Error(`${path}: ${reason}`);
}

export const facts = async (): Promise<Facts> => (await ask("GET", "/scene")).json();
export const newRig = async (toml: string): Promise<Rig> => (await ask("PUT", "/rig", toml)).json();

const vector = (v: readonly number[]): string => `[${v.join(", ")}]`;

function planeText(plane: Plane): string {
  return ["[[c_plane]]", `origin = ${vector(plane.origin)}`, `u = ${vector(plane.u)}`, `v = ${vector(plane.v)}`,
    `lamps = ${plane.lamps}`, `pitch = ${plane.pitch}`, `diameter = ${plane.diameter}`,
    `luminance = ${vector(plane.luminance)}`, `caps = "${plane.caps}"`, `mirror = "${plane.mirror}"`].join("\n");
}

/** The lines of a camera's table but for its size. */
export function cameraText(camera: Camera): string {
  const lens = camera.projection === "orthographic"
    ? `orthographic_height = ${camera.orthographic_height}` : `vertical_fov = ${camera.vertical_fov}`;
  return [`projection = "${camera.projection}"`, `eye = ${vector(camera.eye)}`, `target = ${vector(camera.target)}`,
    `up = ${vector(camera.up)}`, lens].join("\n");
}

/** The text of a view file, keiko-view/1. */
export const viewText = (camera: Camera): string => `format = "keiko-view/1"\n${cameraText(camera)}\n`;

/** The line of a request that hides faces. */
export const hiddenText = (faces: number[]): string => faces.length > 0 ? `hidden = ${vector(faces)}` : "";

/** The text of a request, keiko-view-request/1. */
export function requestText(camera: Camera, planes?: Plane[], more = ""): string {
  return ['format = "keiko-view-request/1"', more, planes?.length === 0 ? "c_plane = []" : "", "[camera]",
    cameraText(camera), `size = [${camera.width}, ${camera.height}]`, ...(planes ?? []).map(planeText), ""].join("\n");
}

/** Progress of the work that this page has asked for, until the server ends. */
export async function followProgress(tell: (work: string, fraction: number) => void): Promise<void> {
  const reader = (await ask("GET", "/events")).body!.pipeThrough(new TextDecoderStream()).getReader();
  let text = "";
  for (;;) {
    const { value, done } = await reader.read();
    if (done) return;
    const lines = (text + value).split("\n");
    text = lines.pop()!;
    for (const line of lines)
      if (line.startsWith("data: ")) {
        const { stage, fraction } = JSON.parse(line.slice(6));
        tell(stage, fraction);
      }
  }
}

import { Facts } from "./facts";
import { showDialog } from "./help";
import { linkOf, ViewState } from "./link";
import { directionWord, hasSections, wordOf } from "./look_words";
import { download } from "./panel";
import { Display } from "./picture";

/** Hands out a picture, and tells which command makes it. */
export function savePicture(picture: Blob, facts: Facts, display: Display, { width, height }: { width: number; height: number }): void {
  download("picture.png", picture);
  const command = `keiko render ${facts.inputs.join(" ")} --view view.toml --rig rig.toml --size ${width}x${height}${lookOptions(display)} -o picture.png`;
  showDialog("Picture", [
    ["file", "picture.png, in your downloads"],
    ["made by", display.look === "faces" ? "this page alone" : command],
    ["", "save view and save write the view and the rig"],
  ]);
}

/** The options of `keiko render` that make a look. */
function lookOptions(display: Display): string {
  if (display.look === "lamps") return "";
  const section = hasSections(display) ? ` --section ${directionWord(display.across)}` : "";
  const scale = display.look === "radius" ? ` --scale ${display.radii.join(":")}` : "";
  return ` --look ${wordOf(display, display.fullCurvature)}${section}${scale}`;
}

/** Copies the address that opens a state; `tell` gets a line for the user. */
export async function copyLink(state: ViewState, tell: (line: string) => void): Promise<void> {
  try {
    await navigator.clipboard.writeText(linkOf(state));
    tell("the link is copied; it opens this view as long as the server goes on");
  } catch {
    showDialog("Link", [["address", linkOf(state)]]);
  }
}

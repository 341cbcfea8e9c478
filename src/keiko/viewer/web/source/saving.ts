import { Facts } from "./facts";
import { showDialog } from "./help";
import { linkOf, ViewState } from "./link";
import { directionWord, wordOf } from "./look_words";
import { download } from "./panel";
import { Display } from "./picture";

/** Hands out a picture, and tells which command makes it. */
export function savePicture(picture: Blob, facts: Facts, display: Display, { width, height }: { width: number; height: number }): void {
  download("picture.png", picture);
  const section = display.look === "curvature" && display.kind === "section" ? ` --section ${directionWord(display.across)}` : "";
  const look = display.look === "lamps" ? "" : ` --look ${wordOf(display, display.fullCurvature)}${section}`;
  const command = `keiko render ${facts.inputs.join(" ")} --view view.toml --rig rig.toml --size ${width}x${height}${look} -o picture.png`;
  showDialog("Picture", [
    ["file", "picture.png, in your downloads"],
    ["made by", display.look === "faces" ? "this page alone" : command],
    ["", "save view and save write the view and the rig"],
  ]);
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

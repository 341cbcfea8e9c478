import { Camera } from "./camera";
import { Rig } from "./facts";
import { hasSections, wordOf } from "./look_words";
import { Display } from "./picture";
import { ask, cameraText, hiddenText, requestText } from "./server";
import { Vector } from "./vector";

/** A remark of the user on a place; `face` 0: the place is not on the part any more. */
export interface Note { text: string; place: Vector; face: number }

/** A view that is kept with its look, a word of look_words, and the normal of the planes of its sections. */
export interface KeptView { name: string; look: string; across?: Vector; camera: Camera }

/** The view of a camera as it is displayed, under a name. */
export const keptView = (name: string, camera: Camera, display: Display): KeptView =>
  ({ name, look: wordOf(display, display.fullCurvature), ...hasSections(display) ? { across: display.across } : {}, camera });

/** What an analysis on this body holds: keiko-analysis/1, as far as the page uses it. */
interface Analysis {
  views: KeptView[];
  sections: string[];
  hidden: { face: number }[];
  notes: { text: string; place: Vector; face?: number }[];
}

/** keiko-view-analysis/1 */
interface ViewAnalysis { analysis: Analysis | null; remarks: { entity: string; message: string }[]; rig: Rig }

/** An analysis that was opened. */
export interface OpenedAnalysis {
  views: KeptView[];
  sections: string[];
  hidden: number[];
  notes: Note[];
  remarks: string[];
  rig: Rig;
}

function opened({ analysis, remarks, rig }: ViewAnalysis): OpenedAnalysis | null {
  if (!analysis) return null;
  return {
    views: analysis.views, sections: analysis.sections, rig,
    hidden: analysis.hidden.map(({ face }) => face),
    notes: analysis.notes.map(({ text, place, face }) => ({ text, place, face: face ?? 0 })),
    remarks: remarks.map(({ entity, message }) => `${entity} ${message}`),
  };
}

/** The analysis that the server was started with; null without one. */
export const fetchAnalysis = async (): Promise<OpenedAnalysis | null> => opened(await (await ask("GET", "/analysis")).json());

/** The analysis of a file's text, on this body. Its lamps are those of the server from now on. */
export const openAnalysis = async (text: string): Promise<OpenedAnalysis> => opened(await (await ask("PUT", "/analysis", text)).json())!;

/** The name of the view that is shown as an analysis is saved; it is shown first when that is opened. */
export const shownView = "shown";

/** What is shown, for a file. */
export interface Shown { camera: Camera; display: Display; hidden: number[]; sections: string[]; views: KeptView[]; notes: Note[] }

// JSON quotes as TOML does, except for one control character.
const quoted = (text: string): string => JSON.stringify(text.replace(/\u007f/g, ""));

function viewText({ name, look, across, camera }: KeptView): string {
  const planes = across ? `across = [${across.join(", ")}]\n` : "";
  return `[[view]]\nname = ${quoted(name)}\nlook = ${quoted(look)}\n${planes}[view.camera]\n${cameraText(camera)}\nsize = [${camera.width}, ${camera.height}]`;
}

/** The file of an analysis, keiko-analysis/1. */
export async function analysisFile({ camera, display, hidden, sections, views, notes }: Shown): Promise<Blob> {
  const first = keptView(shownView, camera, display);
  const more = [hiddenText(hidden), sections.length > 0 ? `sections = [${sections.map(quoted).join(", ")}]` : ""].join("\n");
  const tables = [...[first, ...views].map(viewText),
    ...notes.map(({ text, place }) => `[[note]]\ntext = ${quoted(text)}\nplace = [${place.join(", ")}]`)].join("\n");
  return (await ask("POST", "/analysis", `${requestText(camera, display.planes, more)}${tables}\n`)).blob();
}

import { Host } from "./host";
import { LampRows } from "./lamp_rows";
import { button, byId, download, pickedText, showRows } from "./panel";
import { withRoom } from "./row_moves";
import { ask, newRig, requestText } from "./server";

/** What the panel of the lamps asks of the page besides. */
export interface LampsHost extends Host {
  readonly lamps: LampRows;
}

/** Shows the rows of lamps with their numbers. */
export function showLamps(host: LampsHost): void {
  const { lamps } = host;
  showRows(lamps.all, lamps.chosen, (row) => lamps.choose(row), (row, plane) => lamps.change(row, withRoom(plane)));
}

/** Buttons that place lamps, save them and open others. */
export function lampButtons(host: LampsHost): void {
  const run = async (work: () => Promise<void>): Promise<void> => {
    try {
      await work();
      host.tell("");
    } catch (error) {
      host.fail(error);
    }
  };
  const request = (): string => requestText(host.camera(), host.lamps.all);
  const place = async (): Promise<void> => host.lamps.set((await (await ask("POST", "/place", request())).json()).rig.planes);
  const save = async (): Promise<void> => download("rig.toml", await (await ask("POST", "/rig", request())).blob());
  const open = async (): Promise<void> => host.lamps.set((await newRig(await pickedText(".toml"))).planes);
  byId("lamp-buttons").replaceChildren(button("place for this view", () => void run(place)),
    button("save", () => void run(save)), button("open", () => void run(open)));
}

import { Plane, Rig } from "./facts";
import { Host } from "./host";
import { button, byId, download, pickedText, showRows } from "./panel";
import { withRoom } from "./row_moves";
import { ask, newRig, requestText } from "./server";

/** What the panel of the lamps asks of the page besides. */
export interface LampsHost extends Host {
  planes(): Plane[];
  row(): number;
  chooseRow(row: number): void;
  change(row: number, plane: Plane): void;
  setRig(rig: Rig): void;
}

/** Shows the rows of lamps with their numbers. */
export function showLamps(host: LampsHost): void {
  showRows(host.planes(), host.row(), (row) => host.chooseRow(row), (row, plane) => host.change(row, withRoom(plane)));
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
  const request = (): string => requestText(host.camera(), host.planes());
  const place = async (): Promise<void> => host.setRig((await (await ask("POST", "/place", request())).json()).rig);
  const save = async (): Promise<void> => download("rig.toml", await (await ask("POST", "/rig", request())).blob());
  const open = async (): Promise<void> => host.setRig(await newRig(await pickedText(".toml")));
  byId("lamp-buttons").replaceChildren(button("place for this view", () => void run(place)),
    button("save", () => void run(save)), button("open", () => void run(open)));
}

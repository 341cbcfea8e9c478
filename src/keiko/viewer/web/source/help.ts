import { element } from "./panel";

/** A key of the page. */
export interface Key { key: string; words: string; act: () => void }

/** Opens a dialog with lines of two columns, which Escape or its button closes. */
export function showDialog(title: string, lines: readonly (readonly [string, string])[]): void {
  const rows = lines.map(([name, words]) => element("tr", [element("th", name), element("td", words)]));
  const close = element("button", "close", { type: "button", onclick: () => dialog.close() });
  const dialog = element("dialog", [element("h2", title), element("table", rows), close]) as HTMLDialogElement;
  dialog.onclose = () => dialog.remove();
  document.body.append(dialog);
  dialog.showModal();
}

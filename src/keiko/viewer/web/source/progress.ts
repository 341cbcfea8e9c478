import { byId } from "./panel";

const patience = 1000; // ms until work that nothing is heard of is taken for done
let timer = 0;

/** Shows what the server works on, until it is done or nothing has been heard of it for a while. */
export function showProgress(stage: string, fraction: number): void {
  const shown = byId("work"), clear = (): void => { shown.textContent = ""; };
  clearTimeout(timer);
  if (fraction >= 1) return clear();
  shown.textContent = `${stage} ${Math.floor(100 * fraction)} %`;
  timer = window.setTimeout(clear, patience);
}

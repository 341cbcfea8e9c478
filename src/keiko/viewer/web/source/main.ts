import { showInColours } from "./colours";
import { byId } from "./panel";
import { showProgress } from "./progress";
import { facts, followProgress } from "./server";
import { Viewer } from "./viewer";

async function start(): Promise<void> {
  try {
    showInColours(localStorage.getItem("colours") ?? "light dark");
    await new Viewer(await facts()).start();
    await followProgress(showProgress);
  } catch (error) {
    byId("state").textContent = error instanceof Error ? error.message : String(error);
  }
}

void start();

/** The module's doors: a page that has an element `explorer` gets one; notebooks call `render` (anywidget). */

import "./page/style.css";
import { Explorer } from "./page/app";

export { Explorer };

/** What anywidget gives: a model with the trait `address`, and the element to fill. */
interface Widget {
  model: {
    get(name: string): unknown;
    set(name: string, value: unknown): void;
    save_changes(): void;
    on(event: string, heard: () => void): void;
    off(event: string, heard: () => void): void;
  };
  el: HTMLElement;
}

function render({ model, el }: Widget): () => void {
  const root = document.createElement("div");
  root.classList.add("embedded");
  el.append(root);
  let own = String(model.get("address") ?? "");
  const settled = (query: string): void => {
    if (query === own) return;
    own = query;
    model.set("address", query);
    model.save_changes();
  };
  const explorer = new Explorer(root, { query: own, settled });
  const heard = (): void => {
    const query = String(model.get("address") ?? "");
    if (query !== own) explorer.go((own = query));
  };
  model.on("change:address", heard);
  return () => model.off("change:address", heard);
}

export default { render };

const root = document.getElementById("skydome-explorer");
if (root) {
  const settled = (query: string): void => history.replaceState(null, "", query + location.hash);
  const start = (): void => {
    try {
      Object.assign(root, { explorer: new Explorer(root, { query: location.search, settled }) });
    } catch (error) {
      root.textContent = error instanceof Error ? error.message : String(error);
    }
  };
  root.dataset.theme = matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light";
  requestAnimationFrame(() => setTimeout(start));
}

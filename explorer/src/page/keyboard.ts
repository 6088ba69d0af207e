/** Keys of the whole page, where nobody is typing. */

import type { Explorer } from "./app";
import { h } from "./element";
import type { State } from "./state";

/** What each key does. */
const KEYS: [string, string][] = [
  ["← → ↑ ↓", "move the sun, Shift for 10°"], ["space", "play the day"], [", .", "an hour back, on"],
  ["d", "dome or panorama"], ["f", "false colours"], ["e", "lock the exposure"], ["p", "sun path"], ["a", "analemma"],
];

/** The keys and what they do, to be read. */
export const keysList = (): HTMLElement => h("dl", {}, ...KEYS.flatMap(([key, does]) => [h("dt", {}, key), h("dd", {}, does)]));

/** Hear the keys that are pressed within the explorer, and of a page of its own those that nothing on it has in focus. */
export function onKeys(explorer: Explorer): void {
  const { root } = explorer;
  hear(root, explorer);
  if (!root.parentElement?.classList.contains("sd-page")) return;
  const body = root.parentElement;
  body.addEventListener("keydown", (event) => event.target === body && !event.defaultPrevented && explorer.stage.key(event));
  hear(body, explorer, (event) => event.target === body);
}

function hear(element: HTMLElement, explorer: Explorer, meant: (event: KeyboardEvent) => boolean = () => true): void {
  element.addEventListener("keydown", (event) => {
    if (!meant(event)) return;
    const target = event.target as HTMLElement;
    if (event.ctrlKey || event.metaKey || event.altKey || target.matches("input:not([type=range]), select, textarea")) return;
    if (event.key === " " && target.matches("button, input, summary")) return;
    const part = effect(event.key, explorer);
    if (!part) return;
    event.preventDefault();
    explorer.change(part);
  });
}

function effect(key: string, explorer: Explorer): Partial<State> | null {
  const { state } = explorer;
  switch (key) {
    case " ":
      explorer.toggleDay();
      return {};
    case ",":
    case ".":
      return { minutes: (state.minutes + (key === "," ? -60 : 60) + 1440) % 1440, sun: null };
    case "d":
      return { view: state.view === "dome" ? "panorama" : "dome" };
    case "f":
      return { show: state.show === "luminance" ? "photo" : "luminance" };
    case "e":
      return { ev: state.ev === null ? explorer.exposure : null };
    case "p":
      return { path: !state.path };
    case "a":
      return { analemma: !state.analemma };
    default:
      return null;
  }
}

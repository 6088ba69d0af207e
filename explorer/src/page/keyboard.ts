/** Keys of the whole page, where nobody is typing. */

import type { Explorer } from "./app";
import type { State } from "./state";

/** What each key does, for people. */
export const KEYS: [string, string][] = [
  ["← → ↑ ↓", "move the sun (picture in focus), Shift for 10°"], ["space", "play the day"], [", .", "an hour back, on"],
  ["d", "dome or panorama"], ["f", "false colours"], ["e", "lock the exposure"], ["p", "sun path"], ["a", "analemma"],
];

export function onKeys(explorer: Explorer): void {
  explorer.root.addEventListener("keydown", (event) => {
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

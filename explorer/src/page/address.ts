/** The page's state in its address: named values, readable, with the version of their meaning. */

import { ENTRIES, USUAL, VERSION, type State } from "./state";

export interface Read {
  state: State;
  /** What was not understood, a line each. */
  refused: string[];
}

/** The state that a query tells; what is wrong or unknown is left at its usual value and told. */
export function readAddress(query: string): Read {
  const given = new URLSearchParams(query.slice(0, 4000));
  const state = { ...USUAL };
  const refused: string[] = [];
  const version = given.get("v");
  if (version !== null && version !== String(VERSION)) refused.push(`v=${short(version)} (this page knows ${VERSION})`);
  for (const [key, text] of given) {
    if (key === "v") continue;
    const entry = ENTRIES.find((known) => known.key === key);
    const found = entry?.read(text);
    if (found) Object.assign(state, found);
    else refused.push(`${short(key)}=${short(text)}`);
  }
  if (given.has("place") && !given.has("name")) state.name = "";
  if (state.beside === "" && state.show === "difference") state.show = "photo";
  return { state, refused };
}

/** The query that tells a state; what is usual is left out. */
export function writeAddress(state: State): string {
  const told = new URLSearchParams({ v: String(VERSION) });
  for (const entry of ENTRIES) {
    const text = entry.write(state);
    if (text !== entry.write(USUAL) || entry.key === "place") told.set(entry.key, text);
  }
  if (told.has("place") && state.name) told.set("name", state.name);
  return `?${told.toString().replaceAll("%2C", ",").replaceAll("%3A", ":").replaceAll("%2F", "/")}`;
}

function short(text: string): string {
  return text.length > 24 ? `${text.slice(0, 24)}…` : text;
}

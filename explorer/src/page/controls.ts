/** Controls bound to the state: each tells a change and follows the state that it is shown. */

import { h, tell } from "./element";
import type { Scene } from "./scene";
import type { State } from "./state";

export interface Control {
  element: HTMLElement;
  follow(scene: Scene): void;
}

export type Change = (part: Partial<State>, dragging?: boolean) => void;

let count = 0;

export interface SliderChoices {
  label: string;
  hint?: string;
  step: number;
  limits(scene: Scene): [number, number];
  value(scene: Scene): number;
  text(value: number, scene: Scene): string;
  change(value: number, scene: Scene): Partial<State>;
  shown?(scene: Scene): boolean;
}

/** A labelled slider with its value beside. */
export function slider(choices: SliderChoices, change: Change): Control {
  const id = `sd-${++count}`;
  const output = h("output", { for: id });
  const input = h("input", { id, type: "range", step: choices.step });
  let shown: Scene;
  input.addEventListener("input", () => change(choices.change(Number(input.value), shown), true));
  input.addEventListener("change", () => change({}));
  const label = h("label", { for: id, title: choices.hint }, choices.label);
  const element = h("div", { class: "slider" }, label, output, input);
  return {
    element,
    follow(scene) {
      shown = scene;
      element.hidden = choices.shown ? !choices.shown(scene) : false;
      const [low, high] = choices.limits(scene);
      const value = choices.value(scene);
      input.min = String(low);
      input.max = String(high);
      input.value = String(value);
      const text = choices.text(value, scene);
      tell(output, text);
      input.setAttribute("aria-valuetext", text);
      input.style.setProperty("--done", `${(100 * (Number(input.value) - low)) / (high - low)}%`);
    },
  };
}

/** A row of buttons of which one is pressed. */
export function segments<K extends keyof State>(
  label: string, name: K, options: [State[K] & string, string][], change: Change, shown?: (scene: Scene, value: string) => boolean,
): Control {
  const buttons = options.map(([value, text]) =>
    h("button", { type: "button", "data-value": value, click: () => change({ [name]: value } as unknown as Partial<State>) }, text));
  const element = h("div", { class: "segments", role: "group", "aria-label": label }, ...buttons);
  return {
    element,
    follow(scene) {
      for (const button of buttons) {
        button.setAttribute("aria-pressed", String(button.dataset.value === scene.state[name]));
        button.hidden = shown ? !shown(scene, button.dataset.value!) : false;
      }
    },
  };
}

/** A select with groups of options. */
export function select<K extends keyof State>(
  label: string, name: K, groups: Map<string, [string, string][]>, change: Change, also: (value: string) => Partial<State> = () => ({}),
): Control {
  const id = `sd-${++count}`;
  const input = h("select", { id });
  for (const [group, options] of groups) {
    const made = options.map(([value, text]) => h("option", { value }, text));
    if (group) input.append(h("optgroup", { label: group }, ...made));
    else input.append(...made);
  }
  input.addEventListener("change", () => change({ [name]: input.value, ...also(input.value) } as Partial<State>));
  const element = h("div", { class: "field" }, h("label", { for: id }, label), input);
  return { element, follow: (scene) => void (input.value = String(scene.state[name])) };
}

/** A box to tick. */
export function checkbox(label: string, name: "path" | "moon" | "stars" | "analemma", change: Change): Control {
  const input = h("input", { type: "checkbox", change: () => change({ [name]: input.checked }) });
  const element = h("label", { class: "check" }, input, label);
  return { element, follow: (scene) => void (input.checked = scene.state[name]) };
}

/** A titled part of the panel. */
export function section(title: string, ...children: (Node | null)[]): HTMLElement {
  return h("section", {}, h("h2", {}, title), ...children);
}

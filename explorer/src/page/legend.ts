/** The bar beside false colours: luminance in cd m-2, or the difference of two skies in stops; it can be locked. */

import { DIVERGING, VIRIDIS } from "../picture/display";
import type { Change } from "./controls";
import { h, tell } from "./element";
import type { Scene } from "./scene";

/** Stops at the ends of the bar of differences. */
export const STOPS = 2;

function gradient(colours: number[][]): string {
  const stops = colours.map((c) => `rgb(${c.map((v) => Math.round(255 * v)).join()})`);
  return `linear-gradient(to top, ${stops.join(", ")})`;
}

function luminanceText(log: number): string {
  const value = 10 ** log;
  return value >= 1000 ? `${Number((value / 1000).toPrecision(2))}k` : String(Number(value.toPrecision(2)));
}

export class Legend {
  private title = h("div", { class: "legend-title" });
  private ramp = h("div", { class: "ramp" });
  private marks = h("div", { class: "marks" });
  private lock = h("button", { type: "button", "aria-pressed": "false", title: "Keep these ends while the sky changes" }, "Lock");
  private bar: [number, number] = [2, 5];
  private state: "free" | "locked" = "free";
  readonly element = h("div", { class: "legend", hidden: true }, this.title, h("div", { class: "legend-body" }, this.ramp, this.marks), this.lock);

  constructor(change: Change) {
    this.lock.addEventListener("click", () => change({ bar: this.state === "locked" ? null : this.bar }));
  }

  follow({ state }: Scene, bar: [number, number]): void {
    this.element.hidden = state.show === "photo";
    this.bar = bar;
    this.state = state.bar ? "locked" : "free";
    const difference = state.show === "difference";
    tell(this.title, difference ? "right over left" : "cd/m²");
    this.ramp.style.background = gradient(difference ? DIVERGING : VIRIDIS);
    this.lock.hidden = difference;
    this.lock.setAttribute("aria-pressed", String(this.state === "locked"));
    tell(this.lock, this.state === "locked" ? "Locked" : "Lock");
    const texts = difference ? ["−2 stops", "−1", "equal", "+1", "+2 stops"]
      : [0, 0.25, 0.5, 0.75, 1].map((share) => luminanceText(bar[0] + share * (bar[1] - bar[0])));
    if (this.marks.textContent !== texts.join("")) this.marks.replaceChildren(...texts.map((text) => h("span", {}, text)));
  }
}

/** Hour and date below the picture; the hour's track has the day's own colours, from the model that is shown. */

import { TABLES } from "../core/tables";
import { azimuth, direction, elevation, limited, times, type Vec3 } from "../core/vector";
import { modelNamed, MODELS, skyOf } from "../skies/catalogue";
import { xyzToward } from "../skies/light";
import { clockText, dateOfDay, dayOfYear, daysInYear, instant, offsetMinutes, offsetText } from "../sun/clock";
import { sunOver } from "../sun/position";
import type { Change } from "./controls";
import { h, icon, tell } from "./element";
import { conditionsOf, exposureOf, usualEV, type Scene } from "./scene";
import type { State } from "./state";

const STEPS = 72;
const PLAY = "M8 5v14l11-7z";
const PAUSE = "M7 5h4v14H7zM13 5h4v14h-4z";
const MONTHS = ["Jan", "Feb", "Mar", "Apr", "May", "Jun", "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"];

export class Timeline {
  private hour = h("input", { type: "range", min: 0, max: 1439, step: 1, class: "track hour", "aria-label": "Local time" });
  private day = h("input", { type: "range", min: 0, max: 364, step: 1, class: "track day", "aria-label": "Day of the year" });
  private date = h("input", { type: "date", "aria-label": "Date" });
  private clock = h("output", { class: "clock" });
  private zone = h("span", { class: "zone" });
  private play = h("button", { type: "button", class: "round", "aria-label": "Play the day", title: "Play the day (space)" }, icon(PLAY));
  private picture = h("canvas", { width: STEPS, height: 2, class: "daylight", "aria-hidden": "true" });
  private drawn = "";
  private timer = 0;
  readonly element = h("div", { class: "timeline" },
    h("div", { class: "row" }, this.play, h("div", { class: "when" }, this.clock, this.zone),
      h("div", { class: "strip" }, this.picture, this.hour, scale(["0", "3", "6", "9", "12", "15", "18", "21", "24"]))),
    h("div", { class: "row" }, h("div", { class: "when date" }, this.date),
      h("div", { class: "strip" }, this.day, scale(MONTHS))));

  constructor(private change: Change, private state: () => State) {
    this.hour.addEventListener("input", () => this.tell({ minutes: Number(this.hour.value) }));
    this.day.addEventListener("input", () => this.tell({ date: dateOfDay(this.state().date, Number(this.day.value)) }));
    for (const input of [this.hour, this.day]) input.addEventListener("change", () => this.change({}));
    this.date.addEventListener("change", () => this.date.value && this.change({ date: this.date.value, sun: null }));
    this.play.addEventListener("click", () => this.toggle());
  }

  private tell(part: Partial<State>): void {
    this.change({ ...part, sun: null }, true);
  }

  get playing(): boolean {
    return this.timer !== 0;
  }

  /** Start or stop the day: an hour passes in a second. */
  toggle(): void {
    const stop = this.playing;
    if (stop) cancelAnimationFrame(this.timer);
    this.timer = 0;
    this.play.replaceChildren(icon(stop ? PLAY : PAUSE));
    this.play.setAttribute("aria-label", stop ? "Play the day" : "Stop");
    if (stop) return this.change({});
    let before = performance.now();
    const step = (now: number): void => {
      const minutes = (this.state().minutes + ((now - before) / 1000) * 60) % 1440;
      before = now;
      this.tell({ minutes });
      this.timer = requestAnimationFrame(step);
    };
    this.timer = requestAnimationFrame(step);
  }

  follow(scene: Scene, calm: boolean): void {
    const { state } = scene;
    this.hour.value = String(Math.round(state.minutes));
    this.day.max = String(daysInYear(state.date) - 1);
    this.day.value = String(dayOfYear(state.date));
    this.date.value = state.date;
    tell(this.clock, clockText(Math.min(1439, state.minutes)));
    const ahead = offsetText(offsetMinutes(state.zone, scene.utc));
    tell(this.zone, state.sun ? "sun set by hand" : `UTC${ahead}`);
    this.element.classList.toggle("by-hand", state.sun !== null);
    if (calm) this.paint(state);
  }

  /** The colour high in the sky, away from the sun, through the day, on the track. */
  private paint(state: State): void {
    const { minutes, sun, look, ev, bar, wipe, ...rest } = state;
    const key = JSON.stringify(rest);
    if (key === this.drawn) return;
    this.drawn = key;
    const given = { ...state };
    let k = 0;
    const some = (until: number): void => {
      do {
        if (k === STEPS || this.drawn !== key) return;
        this.paintStep(given, k++);
      } while (performance.now() < until);
      idle(some);
    };
    idle(some);
  }

  /** One part of the day on the track. */
  private paintStep(state: State, k: number): void {
    const context = this.picture.getContext("2d", { willReadFrequently: true })!;
    const utc = instant(state.date, 0, state.zone) + ((k + 0.5) / STEPS) * 86400e3;
    const { toward, distance } = sunOver(state, utc);
    const sky = skyOf(modelNamed(state.model) ?? MODELS[0], conditionsOf(state, toward, distance));
    const exposure = exposureOf(Math.max(usualEV(sky), 6));
    for (const [row, height] of [[0, 50], [1, 8]]) {
      const view = direction(azimuth(toward) + 1, (height * Math.PI) / 180);
      context.fillStyle = sky.day && elevation(toward) > -0.1 ? css(xyzToward(sky, view), exposure) : night(elevation(toward));
      context.fillRect(k, row, 1, 1);
    }
  }
}

/** Call when nothing else is to be done, with the moment until which that holds. */
const idle = (work: (until: number) => void): void => {
  if ("requestIdleCallback" in window) requestIdleCallback((given) => work(performance.now() + given.timeRemaining() - 8), { timeout: 200 });
  else setTimeout(() => work(performance.now() + 10), 16);
};

function scale(marks: string[]): HTMLElement {
  return h("div", { class: "scale", "aria-hidden": "true" }, ...marks.map((text) => h("span", {}, text.slice(0, 1), h("i", {}, text.slice(1)))));
}

/** A dark blue that fades as the sun sinks: where the model has no light of its own. */
function night(height: number): string {
  const share = limited(1 + height / 0.31, 0, 1);
  return `rgb(${Math.round(10 + 26 * share)},${Math.round(13 + 34 * share)},${Math.round(22 + 58 * share)})`;
}

/** A colour developed as the picture is. */
export function css(xyz: Vec3, exposure: number): string {
  const rgb = times(TABLES.colour.srgbFromXYZ, xyz).map((value) => Math.max(0, value * exposure));
  const peak = Math.max(...rgb, 1e-9);
  const mapped = Math.min((peak * (2.51 * peak + 0.03)) / (peak * (2.43 * peak + 0.59) + 0.14), 1);
  const shown = rgb.map((value) => (value * mapped) / peak);
  const coded = shown.map((v) => (v <= 0.0031308 ? 12.92 * v : 1.055 * v ** (1 / 2.4) - 0.055));
  return `rgb(${coded.map((value) => Math.round(255 * value)).join()})`;
}

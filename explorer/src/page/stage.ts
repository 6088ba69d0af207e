/** The picture and what is done to it by hand: the sun dragged, the panorama turned, the wipe moved, light asked. */

import { azimuth, DEG, elevation, limited, wrapped, type Vec3 } from "../core/vector";
import { drawOver } from "../picture/overlay";
import { Renderer, type Shown } from "../picture/renderer";
import { domeView, panoramaView, placeOf, toward, type View } from "../picture/view";
import type { Line } from "../sun/path";
import type { Change } from "./controls";
import { h } from "./element";
import type { Scene } from "./scene";

/** Pixels of a picture that is drawn while something is dragged, at first; its light has so many times fewer each way. */
const QUICK = 512 * 256;
const COARSER = 2;
/** Steps between the sizes of such a picture: a new size costs more than it saves. */
const STEP = Math.SQRT1_2;

export interface Lines {
  path: Line | null;
  analemma: Line | null;
}

export type Asked = (toward: Vec3 | null, x: number, y: number, right: boolean) => void;

type Grip = "sun" | "look" | "wipe" | null;

export class Stage {
  readonly canvas = h("canvas", { "aria-hidden": "true" });
  readonly over = h("canvas", {
    class: "over", tabindex: 0, role: "img",
    "aria-label": "The sky. Arrow keys move the sun; Shift makes larger steps.",
  });
  readonly element = h("div", { class: "stage" }, this.canvas, this.over);
  renderer!: Renderer;
  private scene: Scene | null = null;
  private grip: Grip = null;
  private from: [number, number, number] = [0, 0, 0];
  private quick = QUICK;
  private last = 0;
  /** Milliseconds between frames while something moves, lately. */
  late = 28;

  constructor(private change: Change, private asked: Asked, private redraw: () => void) {
    this.canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
    this.canvas.addEventListener("webglcontextrestored", () => {
      this.renderer.restart();
      this.redraw();
    });
    this.over.addEventListener("pointerdown", (event) => this.press(event));
    this.over.addEventListener("pointermove", (event) => this.move(event));
    for (const name of ["pointerup", "pointercancel"] as const) this.over.addEventListener(name, () => this.release());
    this.over.addEventListener("pointerleave", () => this.grip ?? this.asked(null, 0, 0, false));
    this.over.addEventListener("keydown", (event) => this.key(event));
  }

  /** Begin to draw, once the page has its size: a canvas whose size changes later makes the graphics wait. */
  start(): void {
    const { width, height } = this.over.getBoundingClientRect();
    const dense = Math.min(devicePixelRatio || 1, 2);
    resize(this.canvas, width * dense, height * dense);
    this.renderer = new Renderer(this.canvas);
  }

  get dragging(): boolean {
    return this.grip !== null;
  }

  /** The view that suits the state and the place on the page. */
  view(scene: Scene): View {
    const { width, height } = this.over.getBoundingClientRect();
    const aspect = Math.max(width, 1) / Math.max(height, 1);
    return scene.state.view === "dome" ? domeView(aspect) : panoramaView(scene.state.look * DEG, aspect);
  }

  /** Draw the picture, coarser while something moves, and what lies over it. */
  draw(scene: Scene, shown: Shown, lines: Lines, moving: boolean, ink: string): void {
    this.scene = scene;
    const { width, height } = this.over.getBoundingClientRect();
    if (width < 2 || height < 2) return;
    const dense = Math.min(devicePixelRatio || 1, 2);
    if (moving) this.adapt();
    const scale = moving ? Math.min(dense, Math.sqrt(this.quick / (width * height))) : dense;
    resize(this.canvas, width * scale, height * scale);
    const view = this.view(scene);
    this.renderer.draw(scene.skies, view, shown, moving ? COARSER : 1);
    resize(this.over, width * dense, height * dense);
    const context = this.over.getContext("2d", { willReadFrequently: true })!;
    context.setTransform(dense, 0, 0, dense, 0, 0);
    const two = scene.skies.length > 1 && scene.state.show !== "difference";
    const labels = scene.skies.map((sky) => sky.name) as [string, string];
    drawOver(context, {
      view, width, height, sun: scene.sun, moon: scene.state.moon ? scene.moon : null, ...lines, wipe: two ? scene.state.wipe : null, labels: two ? labels : null, ink,
      held: this.grip === "sun",
    });
  }

  /** Fewer pixels where frames take long, more where they are quick. */
  private adapt(): void {
    const now = performance.now();
    const took = now - this.last;
    this.last = now;
    if (took > 1000) return;
    this.late = 0.8 * this.late + 0.2 * Math.min(took, 100);
    if (this.late > 36) this.quicker(STEP);
    else if (this.late < 20) this.quicker(1 / STEP);
  }

  private quicker(factor: number): void {
    this.quick = limited(this.quick * factor, 256 * 128, 4e6);
    this.late = 28;
  }

  private place(event: PointerEvent): [number, number, number, number] {
    const { left, top, width, height } = this.over.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top, width, height];
  }

  private press(event: PointerEvent): void {
    if (!this.scene || event.button !== 0) return;
    const [x, y, width, height] = this.place(event);
    const [u, v] = placeOf(this.view(this.scene), this.scene.sun);
    const reach = event.pointerType === "touch" ? 34 : 24;
    const onSun = Math.hypot(x - u * width, y - v * height) < reach;
    const two = this.scene.skies.length > 1 && this.scene.state.show !== "difference";
    const onWipe = two && Math.abs(x - this.scene.state.wipe * width) < (event.pointerType === "touch" ? 24 : 14);
    this.grip = onSun ? "sun" : onWipe ? "wipe" : this.scene.state.view === "panorama" ? "look" : null;
    this.from = [x, y, this.scene.state.look];
    if (this.grip) this.over.setPointerCapture(event.pointerId);
    if (this.grip !== "look") event.preventDefault();
    this.over.focus({ preventScroll: true });
    if (this.grip === "sun") this.change({}, true);
    if (event.pointerType === "touch" && this.grip !== "sun") this.hover(x, y, width, height);
  }

  private move(event: PointerEvent): void {
    if (!this.scene) return;
    const [x, y, width, height] = this.place(event);
    const view = this.view(this.scene);
    if (this.grip === "sun") this.dragSun(view, x / width, y / height);
    else if (this.grip === "wipe") this.change({ wipe: Math.min(1, Math.max(0, x / width)) }, true);
    else if (this.grip === "look") {
      const turned = ((x - this.from[0]) / width) * (view.across / DEG);
      this.change({ look: wrapped(this.from[2] - turned, 360) }, true);
    } else this.hover(x, y, width, height);
    this.cursor(x, y, width, height);
  }

  private dragSun(view: View, u: number, v: number): void {
    const found = toward(view, u, v) ?? rim(view, u, v);
    const height = Math.max(elevation(found) / DEG, this.scene!.model.lowest);
    this.change({ sun: [azimuth(found) / DEG, Math.min(height, 89.9)] }, true);
  }

  private hover(x: number, y: number, width: number, height: number): void {
    const found = toward(this.view(this.scene!), x / width, y / height);
    const right = this.scene!.skies.length > 1 && x / width > this.scene!.state.wipe;
    this.asked(found, x, y, right);
  }

  private cursor(x: number, y: number, width: number, height: number): void {
    const [u, v] = placeOf(this.view(this.scene!), this.scene!.sun);
    const near = Math.hypot(x - u * width, y - v * height) < 24;
    const wipe = this.scene!.skies.length > 1 && Math.abs(x - this.scene!.state.wipe * width) < 14;
    this.over.style.cursor = this.grip === "sun" ? "grabbing" : near ? "grab" : wipe ? "ew-resize" : "crosshair";
  }

  private release(): void {
    if (!this.grip) return;
    this.grip = null;
    this.change({});
  }

  /** Arrows move the sun. */
  key(event: KeyboardEvent): void {
    const step = event.shiftKey ? 10 : 1;
    const way = ({ ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] } as const)[event.key as "ArrowUp"];
    if (!way || !this.scene || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    const { sun, model } = this.scene;
    const height = Math.min(89.9, Math.max(model.lowest, elevation(sun) / DEG + way[1] * step));
    this.change({ sun: [wrapped(azimuth(sun) / DEG + way[0] * step, 360), height] });
  }
}

/** The point of the dome's rim that lies nearest to a place outside it. */
function rim(view: View, u: number, v: number): Vec3 {
  const [x, y] = [(2 * u - 1) * Math.max(view.aspect, 1), ((1 - 2 * v) * Math.max(view.aspect, 1)) / view.aspect];
  const angle = Math.atan2(-x, y);
  return [Math.sin(angle), Math.cos(angle), 0];
}

function resize(canvas: HTMLCanvasElement, width: number, height: number): void {
  const [w, t] = [Math.max(1, Math.round(width)), Math.max(1, Math.round(height))];
  if (canvas.width !== w) canvas.width = w;
  if (canvas.height !== t) canvas.height = t;
}

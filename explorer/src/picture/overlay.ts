/** What is drawn over the picture: compass, rings of elevation, the sun's path, the sun to take hold of, the wipe. */

import { DEG, direction, elevation, type Vec3 } from "../core/vector";
import type { Line } from "../sun/path";
import type { Moon } from "../sun/moon";
import { placeOf, type View } from "./view";

const COMPASS: [string, number][] = [["N", 0], ["NE", 45], ["E", 90], ["SE", 135], ["S", 180], ["SW", 225], ["W", 270], ["NW", 315]];

export interface Over {
  view: View;
  width: number;
  height: number;
  sun: Vec3;
  moon: Moon | null;
  path: Line | null;
  analemma: Line | null;
  wipe: number | null;
  labels: [string, string] | null;
  /** Text colour of what lies outside the picture. */
  ink: string;
  held: boolean;
}

const WHITE = "rgba(255,255,255,0.92)";
const SHADE = "rgba(10,14,20,0.55)";

/** Draw everything; the context is in CSS pixels. */
export function drawOver(context: CanvasRenderingContext2D, over: Over): void {
  context.clearRect(0, 0, over.width, over.height);
  context.lineCap = context.lineJoin = "round";
  rings(context, over);
  if (over.analemma) line(context, over, over.analemma, "rgba(255,255,255,0.75)", [1, 5], false);
  if (over.path) line(context, over, over.path, "rgba(255,214,150,0.95)", [], true);
  compass(context, over);
  if (over.moon) moon(context, over, over.moon);
  holder(context, over);
  if (over.wipe !== null) wipe(context, over);
}

function at(over: Over, toward: Vec3): [number, number] {
  const [u, v] = placeOf(over.view, toward);
  return [u * over.width, v * over.height];
}

/** Circles of elevation at 30 and 60 degrees, and the horizon. */
function rings(context: CanvasRenderingContext2D, over: Over): void {
  for (const height of [0, 30, 60]) {
    context.lineWidth = 1;
    context.strokeStyle = height === 0 ? "rgba(255,255,255,0.32)" : "rgba(255,255,255,0.16)";
    context.beginPath();
    for (let turn = 0; turn <= 360; turn += 2) {
      const degrees = over.view.dome ? turn : over.view.left / DEG + (turn / 360) * (over.view.across / DEG);
      const v = direction(degrees * DEG, height * DEG);
      const [x, y] = over.view.dome ? at(over, v) : [(turn / 360) * over.width, at(over, v)[1]];
      if (turn === 0) context.moveTo(x, y);
      else context.lineTo(x, y);
    }
    context.stroke();
    if (height > 0) label(context, `${height}°`, ...ringLabel(over, height), 10, "rgba(255,255,255,0.6)", true);
  }
}

function ringLabel(over: Over, height: number): [number, number] {
  if (!over.view.dome) return [18, at(over, direction(over.view.left, height * DEG))[1] - 9];
  const southward = over.path?.points[72] ?? [0, -1, 0];
  const [x, y] = at(over, direction((southward[1] < 0 ? 45 : 135) * DEG, height * DEG));
  return [x - 4, y + (southward[1] < 0 ? -4 : 4)];
}

function compass(context: CanvasRenderingContext2D, over: Over): void {
  for (const [name, degrees] of COMPASS) {
    const main = name.length === 1;
    if (over.view.dome) {
      const [x, y] = at(over, direction(degrees * DEG, -3.4 * DEG));
      label(context, name, x, y, main ? 13 : 10, over.ink, false, main);
    } else {
      const [u] = placeOf(over.view, direction(degrees * DEG, 0));
      if (u < 0.01 || u > 0.99) continue;
      const [, y] = at(over, direction(degrees * DEG, 0));
      tick(context, u * over.width, y, main ? 7 : 4);
      label(context, name, u * over.width, y + 18, main ? 13 : 10, WHITE, true, main);
    }
  }
}

function tick(context: CanvasRenderingContext2D, x: number, y: number, length: number): void {
  context.strokeStyle = "rgba(255,255,255,0.7)";
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(x, y + length);
  context.stroke();
}

function label(
  context: CanvasRenderingContext2D, text: string, x: number, y: number, size: number, colour: string, shaded: boolean, bold = false,
): void {
  context.font = `${bold ? 600 : 400} ${size}px system-ui, sans-serif`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  if (shaded) {
    context.strokeStyle = SHADE;
    context.lineWidth = 2.5;
    context.strokeText(text, x, y);
  }
  context.fillStyle = colour;
  context.fillText(text, x, y);
}

/** A line of the sun with its marks, above the horizon, broken where it leaves the picture. */
function line(context: CanvasRenderingContext2D, over: Over, drawn: Line, colour: string, dash: number[], hours: boolean): void {
  for (const [style, width] of [[SHADE, 3.2], [colour, 1.5]] as const) {
    context.strokeStyle = style;
    context.lineWidth = width;
    context.setLineDash(dash);
    context.beginPath();
    let before: [number, number] | null = null;
    for (const toward of drawn.points) {
      const here = elevation(toward) < -0.3 * DEG || nearSun(over, toward) ? null : at(over, toward);
      const jumps = here && before && Math.abs(here[0] - before[0]) > over.width / 2;
      if (here && before && !jumps) context.lineTo(...here);
      else if (here) context.moveTo(...here);
      before = here;
    }
    context.stroke();
  }
  context.setLineDash([]);
  for (const mark of drawn.marks) {
    if (elevation(mark.toward) < 1 * DEG || nearSun(over, mark.toward)) continue;
    const [x, y] = at(over, mark.toward);
    context.fillStyle = colour;
    context.beginPath();
    context.arc(x, y, hours ? 2.2 : 2, 0, 7);
    context.fill();
    if (hours && mark.number % 3 === 0) label(context, String(mark.number), x, y - 11, 10, WHITE, true);
  }
}

/** Whether a direction lies in the ring about the sun, which stays free. */
function nearSun(over: Over, toward: Vec3): boolean {
  const [[x, y], [sx, sy]] = [at(over, toward), at(over, over.sun)];
  return Math.hypot(x - sx, y - sy) < 17;
}

/** A ring about the sun by which it is taken hold of. */
function holder(context: CanvasRenderingContext2D, over: Over): void {
  const [x, y] = at(over, over.sun);
  const under = over.sun[2] < 0;
  for (const [style, width] of [[SHADE, 3.5], [under ? "rgba(255,255,255,0.6)" : "#ffcf87", 1.6]] as const) {
    context.strokeStyle = style;
    context.lineWidth = width;
    context.setLineDash(under ? [3, 4] : []);
    context.beginPath();
    context.arc(x, y, over.held ? 19 : 14, 0, 7);
    context.stroke();
  }
  context.setLineDash([]);
}

/** A ring about the moon, above the horizon. */
function moon(context: CanvasRenderingContext2D, over: Over, { toward }: Moon): void {
  if (toward[2] < 0) return;
  const [x, y] = at(over, toward);
  context.strokeStyle = "rgba(210,222,245,0.6)";
  context.lineWidth = 1;
  context.beginPath();
  context.arc(x, y, 9, 0, 7);
  context.stroke();
  label(context, "moon", x, y + 18, 10, "rgba(210,222,245,0.8)", true);
}

function wipe(context: CanvasRenderingContext2D, over: Over): void {
  const x = over.wipe! * over.width;
  context.strokeStyle = SHADE;
  context.lineWidth = 3.5;
  stroke(context, x, over.height);
  context.strokeStyle = WHITE;
  context.lineWidth = 1.5;
  stroke(context, x, over.height);
  const y = over.height - 46;
  context.fillStyle = "rgba(14,18,24,0.82)";
  context.beginPath();
  context.roundRect(x - 17, y - 13, 34, 26, 13);
  context.fill();
  context.stroke();
  label(context, "‹ ›", x, y - 1, 14, WHITE, false, true);
  if (over.labels) names(context, over, x);
}

function stroke(context: CanvasRenderingContext2D, x: number, height: number): void {
  context.beginPath();
  context.moveTo(x, 0);
  context.lineTo(x, height);
  context.stroke();
}

/** The two models' names on either side of the wipe. */
function names(context: CanvasRenderingContext2D, over: Over, x: number): void {
  context.font = "500 12px system-ui, sans-serif";
  over.labels!.forEach((text, k) => {
    const width = context.measureText(text).width + 20;
    const left = k === 0 ? x - width - 10 : x + 10;
    context.fillStyle = "rgba(14,18,24,0.72)";
    context.beginPath();
    context.roundRect(left, 14, width, 24, 12);
    context.fill();
    label(context, text, left + width / 2, 26.5, 12, WHITE, false);
  });
}

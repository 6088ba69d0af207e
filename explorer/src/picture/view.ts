/** From the picture's coordinates to directions and back: the whole map, a panorama, the dome looking up. */

import { azimuth, DEG, direction, elevation, wrapped, type Vec3 } from "../core/vector";

export interface View {
  dome: boolean;
  /** Panorama: azimuth at the left edge and across the picture, radians. */
  left: number;
  across: number;
  /** Panorama: elevation at the top edge and down to the bottom edge (a positive span), radians. */
  top: number;
  down: number;
  /** Width over height of the picture. */
  aspect: number;
}

export const HORIZON_BELOW = 9 * DEG;

/** The whole sphere, 2:1, with an azimuth at its left edge. */
export function mapView(left: number): View {
  return { dome: false, left, across: 2 * Math.PI, top: Math.PI / 2, down: Math.PI, aspect: 2 };
}

/** A panorama about an azimuth that fills a picture of that aspect, from below the horizon to the zenith. */
export function panoramaView(look: number, aspect: number): View {
  const down = Math.PI / 2 + HORIZON_BELOW;
  const across = Math.min(down * aspect, 2 * Math.PI);
  return { dome: false, left: look - across / 2, across, top: Math.PI / 2, down, aspect };
}

/** The dome looking up: north at the top, east at the left. */
export function domeView(aspect: number): View {
  return { dome: true, left: 0, across: 2 * Math.PI, top: Math.PI / 2, down: Math.PI / 2, aspect };
}

/** Share of the picture's shorter side that the dome takes. */
export const DOME_SIZE = 0.92;

/** The direction at (u, v), 0..1 from the left and from the top; null outside the dome. */
export function toward(view: View, u: number, v: number): Vec3 | null {
  if (!view.dome) return direction(view.left + u * view.across, view.top - v * view.down);
  const [x, y] = domePlane(view, u, v);
  const r = Math.hypot(x, y);
  return r > 1 ? null : direction(Math.atan2(-x, y), (Math.PI / 2) * (1 - r));
}

/** Coordinates in the dome's plane, 1 at the horizon, x to the right and y to the top. */
function domePlane(view: View, u: number, v: number): [number, number] {
  const [x, y] = [2 * u - 1, 1 - 2 * v];
  return view.aspect > 1 ? [(x * view.aspect) / DOME_SIZE, y / DOME_SIZE] : [x / DOME_SIZE, y / view.aspect / DOME_SIZE];
}

/** Where a direction lies, (u, v); u may fall outside 0..1 in a panorama that does not show it. */
export function placeOf(view: View, v: Vec3): [number, number] {
  if (!view.dome) {
    const middle = view.left + view.across / 2;
    const turn = wrapped(azimuth(v) - middle + Math.PI, 2 * Math.PI) - Math.PI;
    return [0.5 + turn / view.across, (view.top - elevation(v)) / view.down];
  }
  const r = ((Math.PI / 2 - elevation(v)) / (Math.PI / 2)) * DOME_SIZE;
  const [x, y] = [-Math.sin(azimuth(v)) * r, Math.cos(azimuth(v)) * r];
  return view.aspect > 1 ? [(1 + x / view.aspect) / 2, (1 - y) / 2] : [(1 + x) / 2, (1 - y * view.aspect) / 2];
}

/** Radians that one pixel of a picture so many pixels high spans, about. */
export function pixelSize(view: View, height: number): number {
  return (view.dome ? Math.PI / DOME_SIZE / Math.min(1, view.aspect) : view.down) / height;
}

/** Lines on the sky: the sun's way through a day, and where it stands at one hour through a year (the analemma). */

import type { Vec3 } from "../core/vector";
import { dateOfDay, daysInYear, instant } from "./clock";
import { sunOver, type Place } from "./position";

export interface Mark {
  toward: Vec3;
  /** Local hour of a day's path, or month (0 to 11) of an analemma. */
  number: number;
}

export interface Line {
  points: Vec3[];
  marks: Mark[];
}

/** The sun's way through a local day, a point each 10 minutes, a mark each hour. */
export function dayPath(place: Place, date: string, zone: string): Line {
  const start = instant(date, 0, zone);
  const points: Vec3[] = [];
  const marks: Mark[] = [];
  for (let minutes = 0; minutes <= 1440; minutes += 10) {
    const { toward } = sunOver(place, start + minutes * 60000);
    points.push(toward);
    if (minutes % 60 === 0 && minutes < 1440) marks.push({ toward, number: minutes / 60 });
  }
  return { points, marks };
}

/** The sun at one hour of standard time through a year, a point each four days, a mark each month. */
export function analemma(place: Place, date: string, minutes: number, zone: string): Line {
  const points: Vec3[] = [];
  const marks: Mark[] = [];
  const days = daysInYear(date);
  const first = instant(dateOfDay(date, 0), minutes, zone);
  for (let day = 0; day <= days; day += 4) points.push(sunOver(place, first + day * 86400e3).toward);
  for (let month = 0; month < 12; month++) {
    const day = Math.round((month * days) / 12);
    marks.push({ toward: sunOver(place, first + day * 86400e3).toward, number: month });
  }
  return { points, marks };
}

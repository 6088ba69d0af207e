/** EnergyPlus weather files: hours of a year with their irradiances; errors name the line. */

export interface Hour {
  month: number;
  day: number;
  /** 1 to 24, the end of the hour in the site's standard time. */
  hour: number;
  dew: number;
  /** W m-2 on the horizontal, facing the sun, and diffuse; NaN where missing. */
  global: number;
  direct: number;
  diffuse: number;
}

export interface Weather {
  name: string;
  latitude: number;
  longitude: number;
  /** Hours ahead of UTC. */
  zone: number;
  hours: Hour[];
}

const MOST = 8784;
export const MOST_BYTES = 8e6;
const HEAD = 8;
const DAYS = [31, 29, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31];

function number(text: string | undefined, what: string, line: number, low: number, high: number): number {
  const value = text === undefined || text.trim() === "" ? NaN : Number(text);
  if (!(value >= low && value <= high)) {
    throw new Error(`line ${line}: ${what} must be a number in [${low}, ${high}], got ${JSON.stringify((text ?? "").slice(0, 20))}`);
  }
  return value;
}

/** An irradiance; missing ones are written 9999. */
function irradiance(text: string | undefined, what: string, line: number): number {
  const value = number(text, what, line, 0, 99999);
  return value >= 9999 ? NaN : value;
}

/** The weather of a file's text; Error with the line for what is none. */
export function readWeather(text: string): Weather {
  const lines = text.slice(0, MOST_BYTES).split(/\r?\n/);
  const site = lines[0].split(",");
  if (site[0].trim().toUpperCase() !== "LOCATION") throw new Error("line 1: an .epw file begins with LOCATION");
  if (site.length < 9) throw new Error(`line 1: LOCATION must have ten fields, got ${site.length}`);
  const hours: Hour[] = [];
  for (let k = HEAD; k < lines.length; k++) {
    if (lines[k].trim() === "") continue;
    if (hours.length === MOST) throw new Error(`line ${k + 1}: more than ${MOST} hours; the explorer reads one year by hours`);
    const f = lines[k].split(",");
    if (f.length < 16) throw new Error(`line ${k + 1}: an hour must have 16 fields or more, got ${f.length}`);
    const month = number(f[1], "the month", k + 1, 1, 12);
    hours.push({
      month, day: number(f[2], "the day", k + 1, 1, DAYS[month - 1]), hour: number(f[3], "the hour", k + 1, 1, 24),
      dew: Math.min(40, Math.max(-30, number(f[7], "the dew point", k + 1, -200, 200))),
      global: irradiance(f[13], "the global irradiance", k + 1), direct: irradiance(f[14], "the direct irradiance", k + 1),
      diffuse: irradiance(f[15], "the diffuse irradiance", k + 1),
    });
  }
  if (!hours.length) throw new Error(`line ${lines.length}: the file has no hours`);
  return {
    name: [site[1], site[3]].map((part) => part.trim()).filter(Boolean).join(", ").slice(0, 60),
    latitude: number(site[6], "the latitude", 1, -90, 90), longitude: number(site[7], "the longitude", 1, -180, 180),
    zone: number(site[8], "the time zone", 1, -12, 14), hours,
  };
}

/** Milliseconds since 1970 of the middle of an hour, in a year. */
export function middleOf(weather: Weather, { month, day, hour }: Hour, year: number): number {
  return Date.UTC(year, month - 1, day) + (hour - 0.5 - weather.zone) * 3600e3;
}

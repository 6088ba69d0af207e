/** Local times in named zones: from a date and minutes of a day to an instant, and back. */

const formats = new Map<string, Intl.DateTimeFormat>();

function format(zone: string): Intl.DateTimeFormat {
  let found = formats.get(zone);
  if (!found) {
    found = new Intl.DateTimeFormat("en-US", {
      timeZone: zone, hourCycle: "h23", year: "numeric", month: "numeric", day: "numeric", hour: "numeric",
      minute: "numeric", second: "numeric", era: "short",
    });
    formats.set(zone, found);
  }
  return found;
}

/** Whether the browser knows the zone. */
export function isZone(zone: string): boolean {
  try {
    return Boolean(format(zone));
  } catch {
    return false;
  }
}

/** Minutes that a zone is ahead of UTC at an instant. */
export function offsetMinutes(zone: string, utc: number): number {
  const parts: Record<string, number> = {};
  for (const part of format(zone).formatToParts(new Date(utc))) parts[part.type] = Number(part.value);
  const local = Date.UTC(parts.year, parts.month - 1, parts.day, parts.hour, parts.minute, parts.second);
  return Math.round((local - Math.floor(utc / 1000) * 1000) / 60000);
}

/** Milliseconds of 0 h UTC of a date written YYYY-MM-DD. */
export function dayStart(date: string): number {
  const [year, month, day] = date.split("-").map(Number);
  return Date.UTC(year, month - 1, day);
}

/** The instant of a local date and minutes after midnight. */
export function instant(date: string, minutes: number, zone: string): number {
  const local = dayStart(date) + minutes * 60000;
  let utc = local - offsetMinutes(zone, local) * 60000;
  utc = local - offsetMinutes(zone, utc) * 60000;
  return utc;
}

const two = (value: number): string => String(value).padStart(2, "0");

/** Minutes as hh:mm. */
export function clockText(minutes: number): string {
  const whole = Math.round(minutes);
  return `${two(Math.floor(whole / 60))}:${two(whole % 60)}`;
}

/** Offset minutes as +hh:mm. */
export function offsetText(minutes: number): string {
  const size = Math.abs(minutes);
  return `${minutes < 0 ? "-" : "+"}${two(Math.floor(size / 60))}:${two(size % 60)}`;
}

/** A local time with its offset, ISO 8601. */
export function isoText(date: string, minutes: number, zone: string): string {
  return `${date}T${clockText(minutes)}${offsetText(offsetMinutes(zone, instant(date, minutes, zone)))}`;
}

/** The date, YYYY-MM-DD, so many days into the year of another. */
export function dateOfDay(date: string, day: number): string {
  return new Date(Date.UTC(Number(date.slice(0, 4)), 0, 1 + day)).toISOString().slice(0, 10);
}

/** Days from the first of January. */
export function dayOfYear(date: string): number {
  return Math.round((dayStart(date) - Date.UTC(Number(date.slice(0, 4)), 0, 1)) / 86400e3);
}

/** Days in the year of a date. */
export function daysInYear(date: string): number {
  const year = Number(date.slice(0, 4));
  return Math.round((Date.UTC(year + 1, 0, 1) - Date.UTC(year, 0, 1)) / 86400e3);
}

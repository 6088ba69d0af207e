/** What one takes along: the sky as text for other programs. */

import { section } from "./controls";
import type { Explorer } from "./app";

export function takeAway(_explorer: Explorer): HTMLElement {
  return section("Take away");
}

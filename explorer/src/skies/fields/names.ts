/** The kinds of cloud of fields, and of what they are. */

import type { Kind } from "../clouds/optics";
import type { FieldKind } from "./kinds";

export const FIELD_KINDS: Record<FieldKind, Kind> = { cumulus: "water", stratocumulus: "water", altocumulus: "water", cirrus: "ice" };

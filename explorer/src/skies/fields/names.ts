/** The kinds of cloud of fields by name; their numbers are the worker's alone. */

import type { FieldKind } from "./kinds";

export const FIELD_KINDS: readonly FieldKind[] = ["cumulus", "stratocumulus", "altocumulus", "cirrus"];

"""A lit field of cloud that remembers what was seen of it: several lights share its rays."""

from collections import OrderedDict
from dataclasses import dataclass
from functools import cached_property
from hashlib import blake2b

import numpy as np

from skydome.skies.clouds.fields.lit_field import LitField

KEPT = 4
"""Blocks of views that are remembered, of some MB each."""


@dataclass(frozen=True, eq=False)
class RememberedField(LitField):
    """A field under one sun or moon; lights without a beam may stand behind it too, whatever that shines on."""

    @cached_property
    def remembered(self) -> "OrderedDict[bytes, np.ndarray]":
        """What was seen last, by views."""
        return OrderedDict()

    def seen(self, directions: np.ndarray) -> np.ndarray:
        """What is seen of the field toward directions (D, 3), (D, 5 + DEPTHS), found once for the same views."""
        key = blake2b(np.asarray(directions, np.float64).tobytes()).digest()
        found = self.remembered.get(key)
        if found is None:
            found = super().seen(directions)
            self.remembered[key] = found
            while len(self.remembered) > KEPT:
                self.remembered.popitem(last=False)
        return found

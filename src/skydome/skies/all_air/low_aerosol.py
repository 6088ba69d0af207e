"""Low aerosols of any phase law as what the networks were taught, one lobe, and what their law scatters beyond it.

A part f of the scattered light counts as not met at all (delta scaling, Joseph et al. 1976; Wiscombe 1977): depth
t (1 - w f), albedo w (1 - f) / (1 - w f), and one Henyey-Greenstein lobe of mean cosine (g - f) / (1 - f). The f that
also makes the second moments alike is twice too much for light that comes from all over the sky: half of it is taken.
The light scattered once takes the true law (as Nakajima and Tanaka 1988), and that scattered twice what the law has
beyond the lobe, along paths as those of the light scattered once; docs/models/physical.md.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from skydome.air.atmosphere import Atmosphere
from skydome.air.constituents import Aerosol, Constituent
from skydome.air.phase_functions import henyey_greenstein
from skydome.air.phase_laws import PhaseLaw
from skydome.air.series.legendre import combined, legendre, strengths
from skydome.ground.arrays import Array, at_least, constant, is_numpy, limited, namespace, safe_divide
from skydome.skies.all_air.blocks import Block, part_of

HIGH = 10_000.0
"""Mean height, m, from which an aerosol counts as stratospheric."""
SHARE = 0.5
"""Of the part that would make the second moments alike, what counts as going straight on."""
LEAST_LOBE = 0.48
"""Least mean cosine that scaling leaves: that of what was taught."""
TERMS = 128
"""Legendre moments of the light scattered twice."""
STEP = 0.01
"""Part of the aerosol that is added to tell how much of it the light scattered once has met."""


class LowAerosol(NamedTuple):
    """The low aerosols of an air at wavelengths (W,), each (..., W), where together they are not one lobe."""

    members: tuple[int, ...]
    """Which constituents they are, ..."""
    shares: list[Array]
    """... and how much of the scattering each does."""
    straight: Array
    """The part f of the scattered light that counts as going straight on."""
    lobe: Array
    """Mean cosine of the lobe of the rest."""
    albedo: Array
    """Scattering over the depth that is left."""

    @classmethod
    def of(cls, air: Atmosphere, wavelengths: Any, like: Array) -> "LowAerosol | None":
        """Of an atmosphere, in the library of `like`; None where there is one lobe, or nothing."""
        if lone(air):
            return None
        low = [number for number, part in enumerate(air.constituents) if is_low(part)]
        parts = [air.constituents[number] for number in low]
        scattered = [same(p.depth(wavelengths), like) * same(p.scattered(wavelengths), like) for p in parts]
        depth, scattering = total([same(p.depth(wavelengths), like) for p in parts]), total(scattered)
        shares = [safe_divide(one, scattering) for one in scattered]
        laws = [part.phase_law for part in parts]
        mean = weighted(shares, [same(law.mean_cosine(wavelengths), like) for law in laws])
        second = weighted(shares, [same(law.second_moment(wavelengths), like) for law in laws])
        straight = straight_part(mean, second)
        left = safe_divide(scattering, depth - straight * scattering)
        return cls(tuple(low), shares, straight, (mean - straight) / (1 - straight), left)

    def part(self, block: Block) -> "LowAerosol":
        """Those of some of the airs."""
        shares = [part_of(share, block) for share in self.shares]
        return LowAerosol(self.members, shares, *(part_of(one, block) for one in self[2:]))

    def scaled(self, depths: list[Array], shares: list[Array]) -> tuple[list[Array], list[Array]]:
        """Depths of all constituents, and the share of them that scatters, less what goes straight on."""
        depths, shares = list(depths), list(shares)
        for k in self.members:
            left = 1 - shares[k] * self.straight
            depths[k], shares[k] = depths[k] * left, shares[k] / left
        return depths, shares

    def thicker(self, depths: list[Array]) -> list[Array]:
        """Depths of all constituents with a little more of these."""
        return [depth * (1 + STEP) if k in self.members else depth for k, depth in enumerate(depths)]

    def beyond(
        self, once: list[Array], more: list[Array], glow: Array, laws: Sequence[PhaseLaw], wavelengths: np.ndarray
    ) -> "Orders":
        """What is scattered once, less what the straight part takes of it, and what is scattered twice beyond the lobe.

        `once`: what each constituent scatters once, per phase function, (..., W) each; `more`: the same in `thicker`
        air; `glow` (...,): cosine of the angle to the sun; the constituents' laws.
        """
        xp = namespace(glow, *once)
        first = total([once[k] for k in self.members])
        lost = total([once[k] - more[k] / (1 + STEP) for k in self.members])
        twice = lost * self.albedo / (2 * STEP)
        taken = limited(2 * self.straight * safe_divide(twice, first), 0.0, 60.0)
        own = [laws[k] for k in self.members]
        law = weighted(self.shares, [same(one.value(glow, wavelengths), first) for one in own])
        folded = self.folded(own, glow, wavelengths)
        lobe = (1 - self.straight) ** 2 * henyey_greenstein(glow[..., None], self.lobe * self.lobe)
        left = xp.exp(-taken)
        blunt, none = first * (1 - taken - left), xp.zeros_like(folded)
        smooth = blunt * xp.where(law < folded, law - folded, none) - twice * lobe
        faded = [one * left if k in self.members else one for k, one in enumerate(once)]
        return Orders(faded, twice + blunt, smooth, folded)

    def folded(self, laws: Sequence[PhaseLaw], glow: Array, wavelengths: np.ndarray) -> Array:
        """The law of light that these have scattered twice, sr-1, (..., W), by its moments: the squares of theirs."""
        each = [same(law.moments(TERMS, wavelengths), glow) for law in laws]
        mixed = [weighted(self.shares, [moments[order] for moments in each]) for order in range(TERMS)]
        return combined(legendre(TERMS, glow), strengths(namespace(glow).stack([one * one for one in mixed])))


class Orders(NamedTuple):
    """Light scattered once, and what of the rest lies beyond one lobe, (..., W) each."""

    once: list[Array]
    """Of each constituent, per phase function."""
    twice: Array = 0.0
    """Of the low aerosols, per phase function `folded`."""
    smooth: Array = 0.0
    folded: Array = 0.0

    @property
    def beyond(self) -> Array:
        """What lies beyond one lobe."""
        return self.twice * self.folded + self.smooth


@dataclass(frozen=True, eq=False)
class FoldedLaw(PhaseLaw):
    """The law of light that the low aerosols of an `atmosphere` have scattered twice."""

    atmosphere: Atmosphere
    wavelengths_alike: ClassVar[bool] = False

    def value(self, cosine: ArrayLike, wavelengths: ArrayLike) -> Array:
        """By its Legendre moments, in NumPy."""
        angle, w = np.asarray(cosine, np.float64), np.atleast_1d(np.asarray(wavelengths, np.float64))
        low = LowAerosol.of(self.atmosphere, w, angle)
        laws = [part.phase_law for part in self.atmosphere.constituents if is_low(part)]
        return np.zeros((*angle.shape, w.size)) if low is None else low.folded(laws, angle, w)


def is_low(part: Constituent) -> bool:
    """Whether it is an aerosol below the stratosphere."""
    return isinstance(part, Aerosol) and part.profile.mean_height < HIGH


def lone(air: Atmosphere) -> bool:
    """Whether the low aerosols of an atmosphere are one lobe, or nothing."""
    laws = [part.phase_law for part in air.constituents if is_low(part)]
    return len(laws) < 2 and all(law.one_lobe for law in laws)


def straight_part(mean: Array, second: Array) -> Array:
    """The part f of light scattered with mean cosine and second Legendre moment (...,) that goes straight on."""
    beyond = second - mean * mean
    alike = safe_divide(beyond, 1 - 2 * mean + second)  # 1 - f = (1 - g) / (1 - lobe), lobe = (g - second) / (1 - g)
    most = limited((mean - LEAST_LOBE) / (1 - LEAST_LOBE), 0.0, 1.0)
    wanted = at_least(SHARE * alike, 0.0)
    return namespace(mean).where(wanted < most, wanted, most)


def weighted(shares: list[Array], values: list[Array]) -> Array:
    """The sum of values by their shares."""
    return total([share * value for share, value in zip(shares, values, strict=True)])


def total(parts: list[Array]) -> Array:
    """The sum of one or more arrays."""
    return sum(parts[1:], parts[0])


def same(value: Any, like: Array) -> Array:
    """An array of NumPy's as one of the library of `like`; others as they are."""
    return constant(value, like) if is_numpy(value) else value

"""Random layers of cloud in random air, each under one sun at one wavelength: what the overcast sky is taught."""

from dataclasses import dataclass, replace

import numpy as np

from skydome.air.clouds.cloud import Cloud
from skydome.air.clouds.particles import CloudParticles, Ice, Water
from skydome.air.constituents import Molecules, Ozone

ICE = 0.25
"""Share of clouds of ice."""


@dataclass(frozen=True)
class RandomLayer:
    """A cloud in air over a ground of `albedo`, under a sun of an elevation in degrees, at a wavelength, nm."""

    molecules: Molecules
    ozone: Ozone
    cloud: Cloud
    albedo: float
    elevation: float
    wavelength: float


def random_layer(random: np.random.Generator) -> RandomLayer:
    """One: depths even in their logarithm from 1 to 65, low suns and visible light more often than others."""
    kind: CloudParticles = Ice() if random.random() < ICE else Water()
    low, high = np.log(kind.radii.low * 1.001), np.log(kind.radii.high * 0.999)
    visible = random.random() < 0.65
    base = random.uniform(4000.0, 11_000.0) if isinstance(kind, Ice) else 100.0 + 7000.0 * random.random() ** 2
    cloud = Cloud(
        optical_depth=float(np.exp(random.uniform(0.0, np.log(65.0)))),
        base=base,
        thickness=random.uniform(200.0, 2500.0),
        effective_radius=float(np.exp(random.uniform(low, high))),
        kind=kind,
    )
    return RandomLayer(
        Molecules(pressure=random.uniform(60_000.0, 105_000.0)),
        Ozone(column=random.uniform(0.0, 500.0)),
        cloud,
        random.random() if random.random() < 0.9 else 0.0,
        90.0 * random.random() ** 1.5,
        random.uniform(320.0, 800.0) if visible else random.uniform(800.0, 1800.0),
    )


def hard_layer(random: np.random.Generator) -> RandomLayer:
    """One where the light changes fastest: most under a sun below 8 degrees, a third at 320-365 nm."""
    layer = random_layer(random)
    elevation = 8.0 * random.random() ** 2 if random.random() < 0.7 else layer.elevation
    wavelength = random.uniform(320.0, 365.0) if random.random() < 0.35 else layer.wavelength
    return replace(layer, elevation=elevation, wavelength=wavelength)

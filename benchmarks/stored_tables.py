"""Hosek and Wilkie's tables in few bits, the rival of networks: python benchmarks/stored_tables.py."""

import numpy as np

from skydome.ground.directions import elevation
from skydome.ground.interpolation import weights
from skydome.skies.formula.perez_formula import evaluate, view_geometry
from skydome.skies.formula.sky_tables import blended, control_weights
from skydome.skies.hosek_wilkie import TURBIDITIES, HosekWilkieRGB, published
from skydome.training.lessons import TEACHERS, even_lesson, lesson

OFFSET = HosekWilkieRGB.offset


def as_half(table):
    """The table in 16 bit floats, and its bytes."""
    return table.astype(np.float16).astype(float), table.size * 2


def as_levels(table, bits=12):
    """The table in levels between the least and the greatest of each of its ten numbers; its bytes, ends included."""
    axes = tuple(range(table.ndim - 1))
    low, high = table.min(axis=axes), table.max(axis=axes)
    step = np.where(high > low, high - low, 1) / (2**bits - 1)
    return low + np.round((table - low) / step) * step, table.size * bits / 8 + 2 * 4 * low.size


def light(table, test):
    """Light of a table on a lesson's conditions and views, (C, D, channels)."""
    turbidity, albedo = test.turbidity[:, 0], test.albedo[:, 0]
    shares = np.stack([1 - albedo, albedo], axis=-1)[:, None, :]
    if table.shape[1] == 1:
        shares = np.ones((len(albedo), 1, 1))
    numbers = blended(table, weights(TURBIDITIES, turbidity), shares, control_weights(elevation(test.sun[:, 0])))
    return evaluate(numbers[:, None], *view_geometry(test.directions, test.sun), offset=OFFSET)


def main():
    """Print a row for each form and precision."""
    even = even_lesson(TEACHERS["hosek-wilkie-spectral"])
    height = np.arcsin(np.clip(even.sun[:, 0, 2], -1, 1))
    half = np.full(len(height), 0.5)
    rgb = lesson(TEACHERS["hosek-wilkie"], height, even.turbidity[:, 0], half, even.directions)
    one = published("rgb").mean(axis=1, keepdims=True)
    for name, table, test in (("RGB, albedo 0.5", one, rgb), ("11 bands, any albedo", published("spectral"), even)):
        exact = light(table, test)
        unit = exact / test.light  # W against cd: one number, if these tables are the model
        print(f"{name}: {table.size} numbers, the model to {unit.max() / unit.min() - 1:.0e}")
        for kind, (rounded, size) in (("float16", as_half(table)), ("12 bits", as_levels(table))):
            error = np.sqrt(np.mean((light(rounded, test) / exact - 1) ** 2))
            print(f"  {kind}: {size / 1000:.1f} kB, rms relative {error:.3%}")


if __name__ == "__main__":
    main()

"""The error map of aerial perspective: `python docs/figures/aerial_perspective_errors.py`, figure and table."""

from pathlib import Path

import matplotlib
import numpy as np

from skydome import deg
from skydome.air.scattering import gas_total, haze_total
from skydome.haze.integrals import FewNodes, Ray, coefficients_like
from skydome.haze.published import AdaptiveQuadrature, PublishedClosedForm

matplotlib.use("Agg")
from matplotlib import pyplot as plt
from matplotlib.colors import LogNorm

WAVELENGTHS = [450.0, 550.0, 650.0]
ZENITHS = np.unique(np.concatenate([np.linspace(0, 120, 121), np.linspace(85, 95, 41)]))
DISTANCES = np.logspace(2, 5, 61)
BANDS = ((100, 1e3), (1e3, 3e3), (3e3, 1e4), (1e4, 3e4), (3e4, 1e5))


def worst(method, turbidities=(2.0, 4.0, 6.0), heights=(0.0, 3000.0), dtype=np.float64):
    """Largest relative error of I1 and I2 over wavelengths, turbidities and heights, (distances, zeniths)."""
    errors = np.zeros((DISTANCES.size, ZENITHS.size))
    for turbidity in turbidities:
        for height in heights:
            rays = []
            for kind in (np.float64, dtype):
                distance, cosine = (
                    a.astype(kind) for a in np.meshgrid(DISTANCES, np.cos(ZENITHS * deg), indexing="ij")
                )
                at_550 = float(haze_total([550.0], turbidity)[0]), float(gas_total([550.0])[0])
                air = coefficients_like(haze_total(WAVELENGTHS, turbidity), gas_total(WAVELENGTHS), *at_550, distance)
                rays.append((Ray.at(distance, cosine, np.asarray(height, kind)), air))
            reference, found = AdaptiveQuadrature().integrals(*rays[0]), method.integrals(*rays[1])
            for own, true in zip(found, reference, strict=True):
                errors = np.fmax(errors, np.nan_to_num(np.abs(own / true - 1), nan=np.inf).max(axis=-1))
    return errors


def main():
    methods = {"published closed form": (PublishedClosedForm(), np.float64)}
    for count in (6, 8, 12):
        methods[f"{count} nodes"] = (FewNodes(count), np.float64)
    methods["8 nodes, float32"] = (FewNodes(8), np.float32)
    maps = {name: worst(method, dtype=dtype) for name, (method, dtype) in methods.items()}
    for name, errors in maps.items():
        cells = [f"{errors[(low <= DISTANCES) & (high >= DISTANCES)].max():.1e}" for low, high in BANDS]
        print("|", name, "|", " | ".join(cells), "|", f"{errors[:, ZENITHS <= 90].max():.1e} |")
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained", sharey=True)
    for axis, name in zip(axes, ("published closed form", "8 nodes"), strict=True):
        image = axis.pcolormesh(
            ZENITHS,
            DISTANCES / 1000,
            np.clip(maps[name], 1e-7, 1e2),
            norm=LogNorm(1e-6, 1e2),
            cmap="magma",
            rasterized=True,
        )
        axis.set(yscale="log", title=name, xlabel="zenith angle of the view, degrees")
    axes[0].set_ylabel("distance, km")
    figure.colorbar(image, ax=axes, label="largest relative error of I1, I2")
    figure.savefig(Path(__file__).with_suffix(".png"), dpi=110)


if __name__ == "__main__":
    main()

"""A map of spectra, for `skydome render --wavelengths`: what it may be asked, its making, and what is said of it."""

import warnings
from dataclasses import fields
from pathlib import Path
from typing import Any

from skydome.cli.doors import require_output
from skydome.cli.map_file import FileOptions
from skydome.cli.numbers_of_light import light_facts, light_rows, notes_row
from skydome.cli.options import SkyOptions, numbers
from skydome.cli.scene import scene_of
from skydome.ground.limits.sizes import require_count

ENDINGS = (".hsr", ".exr")
ROWS = 128
"""Of a map whose height is not given: spectra are large."""
MOST_WAVELENGTHS = 2000


def steps(text: str) -> list[float]:
    """Wavelengths, nm, from FROM,TO,STEP."""
    low, high, step = numbers(text, 3, "--wavelengths", "380,720,20")
    if not 0 < low < high or not 0 < step <= high - low:
        raise ValueError(f"--wavelengths must be FROM,TO,STEP with FROM < TO, got {text!r}")
    require_count((high - low) / step + 1, MOST_WAVELENGTHS, "wavelengths")
    return [low + k * step for k in range(int((high - low) / step + 1e-9) + 1)]


def spectral_map(
    options: SkyOptions, file: FileOptions, output: Path, wavelengths: list[float], height: int | None, north: float
) -> dict[str, Any]:
    """Write the map of the sky's spectra, without the sun's disc: the facts of the light and of the file.

    ValueError, before any work, for other endings and for what only colours can have, and for a sky without spectrum.
    """
    from skydome.export.spectral_pictures import save_spectra
    from skydome.skies.colour_sky import SpectralSky

    require_output(output, "a map of spectra", ENDINGS)
    plain = FileOptions()
    asked = [field.name for field in fields(file) if getattr(file, field.name) != getattr(plain, field.name)]
    if asked:
        raise ValueError(f"a map of spectra has no --{asked[0].replace('_', '-')}: it holds W m-2 sr-1 by wavelength")
    scene = scene_of(options, north, any_hour=True)
    if not isinstance(scene.sky, SpectralSky):
        raise ValueError(f"the model {scene.name} has no spectrum; physical, hosek-wilkie and preetham have")
    rows = ROWS if height is None else height
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always", UserWarning)
        save_spectra(scene.sky, output, wavelengths, rows)
    facts = light_facts(scene)
    notes = facts["notes"] + [str(warning.message) for warning in caught if warning.category is UserWarning]
    if scene.disc is not None:
        notes.append("the sun's disc is not in a map of spectra")
    return facts | {
        "file": str(output),
        "bytes": output.stat().st_size,
        "height": rows,
        "wavelengths_nm": wavelengths,
        **({"north_deg": north} if north else {}),
        "notes": notes,
    }


def spectral_rows(facts: dict[str, Any]) -> dict[str, str]:
    """The same for people."""
    waves = facts["wavelengths_nm"]
    bands = f"{facts['height']} rows, {len(waves)} bands, {waves[0]:g}-{waves[-1]:g} nm, {facts['bytes'] / 1e3:,.0f} kB"
    return light_rows(facts) | {"file": facts["file"], "size": bands} | notes_row(facts["notes"])

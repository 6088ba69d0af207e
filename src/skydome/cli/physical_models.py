"""The skies from first principles as models of the command line: what air, how long to trace, with what progress."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from skydome.cli.models import DEFAULTS, Model
from skydome.cli.options import SkyOptions

if TYPE_CHECKING:
    from skydome.air.atmosphere import Atmosphere
    from skydome.skies.path_tracing.sky import PathTraced
    from skydome.skies.physical.held import HeldSky
    from skydome.skies.sky import Sky

USUAL_ERROR = 0.01


@dataclass(frozen=True)
class PhysicalModel(Model):
    """A sky of standard air with a turbidity and an albedo, its colours held in a table."""

    def build(self, sun: Any, options: SkyOptions) -> "tuple[Sky, list[str]]":
        """The sky, and what to say of the air that was chosen."""
        self.refuse_what_it_does_not_take(options)
        air, note = air_of(options)
        return self.held(self.cls()(sun, air), options), [note]  # type: ignore[call-arg]

    def held(self, sky: Any, options: SkyOptions) -> "HeldSky":
        """The sky's colours in a table."""
        from skydome.skies.physical.held import held

        return held(sky)


@dataclass(frozen=True)
class TracedModel(PhysicalModel):
    """The path tracer, run until an error or a count of paths is reached, with its progress on stderr."""

    def held(self, sky: "PathTraced", options: SkyOptions) -> "HeldSky":
        """The sky's colours, traced toward a table's nodes."""
        import numpy as np

        from skydome.skies.physical.held import held, node_directions

        bands = np.arange(380.0, 781.0, 20.0)
        wanted = USUAL_ERROR if options.until is None else relative_error(options.until)
        if options.until is None and options.paths is not None:
            wanted = 1e-6
        most = 100_000 if options.paths is None else passes_for(options.paths, sky.paths_per_pass)
        with progress(wanted, most, options.until is not None or options.paths is None) as report:
            tracing = sky.job(node_directions(sky.sun), bands).start().until(wanted, most, report)
        return held(sky, bands, tracing.radiance)


def air_of(options: SkyOptions) -> "tuple[Atmosphere, str]":
    """Clean air with so much aerosol as the turbidity says, over ground of an albedo; ValueError below turbidity 1."""
    from skydome.air.atmosphere import Atmosphere
    from skydome.air.cross_sections import rayleigh_depth

    turbidity = DEFAULTS["turbidity"] if options.turbidity is None else options.turbidity
    if not 1 <= turbidity <= 64:
        raise ValueError(f"turbidity must lie in [1, 64], got {turbidity:g}")
    depth = (turbidity - 1) * float(rayleigh_depth([550.0])[0])
    albedo = DEFAULTS["albedo"] if options.albedo is None else options.albedo
    note = f"air: turbidity {turbidity:g}, an aerosol depth of {depth:.3f} at 550 nm (g 0.76), ozone 330 DU"
    return Atmosphere.standard(depth, albedo=albedo), note


def relative_error(text: str) -> float:
    """The error of --until as a fraction; ValueError unless in (0, 50 %].

    >>> relative_error("0.5%"), relative_error("0.02")
    (0.005, 0.02)
    """
    try:
        value = float(text[:-1]) / 100 if text.endswith("%") else float(text)
    except ValueError:
        value = float("nan")
    if not 1e-6 <= value <= 0.5:
        raise ValueError(f"--until must be an error in (0, 50%] such as 1% or 0.01, got {text!r}")
    return value


def passes_for(paths: int, each: int) -> int:
    """Passes of `each` paths that make up the count; ValueError below 2 passes, which tell no error."""
    if paths < 2 * each:
        raise ValueError(f"--paths must be {2 * each} or more, got {paths}")
    return -(-paths // each)


@contextmanager
def progress(wanted: float, most: int, by_error: bool) -> Iterator[Callable[[float, int], None] | None]:
    """What a tracing reports to: a bar on stderr; None where stderr is no terminal."""
    from rich.console import Console
    from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn

    console = Console(stderr=True)
    if not console.is_terminal:
        yield None
        return
    columns = TextColumn("{task.description}"), BarColumn(), TimeElapsedColumn()
    with Progress(*columns, console=console, transient=True) as bar:
        task = bar.add_task("path tracing", total=1.0)

        def report(error: float, passes: int) -> None:
            done = (wanted / error) ** 2 if by_error and error > 0 else 0.0
            bar.update(task, completed=max(done, passes / most), description=f"path tracing, error {error:.2%}")

        yield report

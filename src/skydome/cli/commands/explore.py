"""`skydome explore`: the explorer in the browser, served from the package to this machine alone."""

import webbrowser
from pathlib import Path
from typing import Annotated

from typer import Option

from skydome.cli.options import SunOptions, taking


@taking(SunOptions)
def explore(
    options: SunOptions,
    model: Annotated[str | None, Option(help="A sky model (`skydome models` lists them).")] = None,
    turbidity: Annotated[float | None, Option(help="Haze: 2 very clear, 3 clear, 6 hazy.")] = None,
    albedo: Annotated[float | None, Option(help="Ground reflectance, 0-1.")] = None,
    weather: Annotated[Path | None, Option(help="An .epw file whose year is shown.")] = None,
    port: Annotated[int, Option(help="Port on this machine; 0 takes a free one.")] = 0,
    browser: Annotated[bool, Option("--browser/--no-browser", help="Open the browser.")] = True,
) -> None:
    """Open the explorer: drag the sun through every model's sky, read its light, take it along. Stop it with Ctrl-C."""
    from skydome.explorer.address import address
    from skydome.explorer.serving import WEATHER, page_server

    told = sun_told(options)
    if model is not None:
        from skydome.skies.catalogue import model_named

        told["model"] = model_named(model).name
    if weather is not None:
        require_weather(weather)
        told["url"] = WEATHER
    if not 0 <= port <= 65535:
        raise ValueError(f"--port must lie in [0, 65535], got {port}")
    with page_server(port, weather) as server:
        where = server.address + address(**told, turbidity=turbidity, albedo=albedo)
        print(where, flush=True)
        if browser:
            webbrowser.open(where)
        server.wait()


def sun_told(options: SunOptions) -> dict[str, str]:
    """The sun in the address's words: by its direction, or by place and time; whatever is not given is left out."""
    from skydome.cli.moment import aware_time, pointing
    from skydome.explorer.address import moment, plain
    from skydome.ground.directions import azimuth, elevation
    from skydome.ground.units import deg
    from skydome.sun.place import Place

    if options.sun is not None:
        sun = pointing(options.sun, "--sun")
        return {"sun": f"{plain(azimuth(sun) / deg)},{plain(elevation(sun) / deg)}"}
    place = None if options.place is None else Place.parse(options.place)
    time = None if options.time is None else aware_time(options.time, options.zone)
    return moment(place, time, options.zone)


def require_weather(path: Path) -> None:
    """ValueError or OSError unless the file is there and is an .epw."""
    from skydome.ground.arguments import require_file

    if path.suffix.lower() != ".epw":
        raise ValueError(f"the explorer reads .epw files, got {path.name!r}")
    require_file(path, "a weather file")

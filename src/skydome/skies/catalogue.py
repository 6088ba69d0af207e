"""The catalogue: every sky model by name, a row each, read by the command line, `fit`, `evaluate`, `train` and `year`.

A new model is its file and a row in `CATALOGUE`. What the class itself tells (fields, `ranges`, rung, `source`,
`lowest_sun`) is not told again.
"""

from difflib import get_close_matches

from skydome.skies.air_models import AirModel, PhysicalModel, TracedModel
from skydome.skies.all_air.sky import PhysicalSky
from skydome.skies.cie import CIE, CIEClear, CIEIntermediate
from skydome.skies.clouds.model import OvercastModel
from skydome.skies.clouds.overcast import OvercastSky
from skydome.skies.formula.igawa import Igawa
from skydome.skies.formula.level import CLEAR, MIDDLE, OVERCAST
from skydome.skies.formula.older.asrc_cie import ASRCCIE
from skydome.skies.formula.older.brunger_hooper import BrungerHooper
from skydome.skies.formula.older.harrison_coombes import HarrisonCoombes
from skydome.skies.formula.older.matsuura_iwata import MatsuuraIwata
from skydome.skies.formula.older.pokrowski import Pokrowski
from skydome.skies.hosek_wilkie import BANDS, HosekWilkie, HosekWilkieRGB
from skydome.skies.model import Model, NeuralModel, PreethamModel
from skydome.skies.neural.files import load_network
from skydome.skies.neural.sky import NeuralSky, NeuralSpectralSky
from skydome.skies.path_tracing.sky import PathTraced
from skydome.skies.perez import Perez
from skydome.skies.perez_all_weather import PerezAllWeather
from skydome.skies.physical.discrete_ordinates import DiscreteOrdinates
from skydome.skies.physical.klassen import Klassen87
from skydome.skies.physical.nishita import Nishita93, Nishita96
from skydome.skies.physical.prague.file import read_prague
from skydome.skies.physical.prague.sky import Prague
from skydome.skies.physical.precomputed.hillaire import Hillaire
from skydome.skies.physical.precomputed.models import ScatteringModel
from skydome.skies.physical.precomputed.sky import PrecomputedScattering
from skydome.skies.preetham import Preetham
from skydome.skies.sky import Sky
from skydome.skies.uniform import MoonSpencer, Uniform

HAZE = ("sun", "turbidity")
SHAPE_ALONE = (
    "knows luminance alone: its colours are daylight's, its level that of irradiances, which were not measured"
)
UP_TO_A_FACTOR = "knows luminance alone, up to a factor: its colours are daylight's, its illuminance is given"


def cie_model(kind: int) -> Model:
    """A CIE type: overcast up to 5, with the sun from 6 on; 6 is as bright as an overcast sky."""
    return Model(
        f"cie-{kind}", CIE, fixed={"type": kind}, level=OVERCAST if kind <= 6 else CLEAR, shines=kind > 5,
        failures=UP_TO_A_FACTOR,
    )  # fmt: skip


MEASURED = (
    "direct_normal_irradiance", "diffuse_horizontal_irradiance", "extraterrestrial_irradiance", "dew_point", "compat",
    "smooth",
)  # fmt: skip

CATALOGUE: tuple[Model, ...] = (
    PhysicalModel(
        "physical",
        PhysicalSky,
        fitted=("sun", "aerosol_depth"),
        failures="no polarisation (up to 7 % at 400 nm) and no refraction; one lobe of aerosol unless given more",
    ),
    Model(
        "hosek-wilkie",
        HosekWilkie,
        ("turbidity", "albedo", "tables"),
        fitted=HAZE,
        lesson="hosek-wilkie-spectral",
        lesson_bands=tuple(BANDS.tolist()),
        failures="at the turbidity that fits best 40 % too bright away from the sun and too dark round it",
    ),
    Model("hosek-wilkie-rgb", HosekWilkieRGB, ("turbidity", "albedo"), fitted=HAZE, lesson="hosek-wilkie"),
    PreethamModel(
        "preetham",
        Preetham,
        ("turbidity", "numbers"),
        fitted=HAZE,
        lesson="preetham",
        failures="about twice too bright away from the sun; far too bright round it",
    ),
    *(
        NeuralModel(f"neural-{network}", NeuralSky, ("turbidity",), {"network": network}, ground=ground)
        for network, ground in (
            ("preetham", None),
            ("hosek-wilkie", 0.5),
            ("hosek-wilkie-compact", 0.5),
            ("hosek-wilkie-deep", 0.5),
        )
    ),
    NeuralModel(
        "neural-hosek-wilkie-spectral",
        NeuralSpectralSky,
        ("turbidity", "albedo"),
        {"network": "hosek-wilkie-spectral"},
    ),
    Model("perez-all-weather", PerezAllWeather, MEASURED, knows_level=True, failures=SHAPE_ALONE),
    Model("igawa", Igawa, MEASURED[:4], knows_level=True, failures=SHAPE_ALONE),
    Model("asrc-cie", ASRCCIE, MEASURED[:4], knows_level=True, failures=SHAPE_ALONE),
    Model("perez", Perez, tuple("abcde"), fitted=("sun", *"abcde", "illuminance")),
    *(cie_model(kind) for kind in range(1, 16)),
    Model("cie-clear", CIEClear, level=CLEAR, fitted=("sun", "illuminance"), failures=UP_TO_A_FACTOR),
    Model("cie-intermediate", CIEIntermediate, level=MIDDLE),
    Model("matsuura-iwata", MatsuuraIwata, level=MIDDLE, failures=UP_TO_A_FACTOR),
    Model("brunger-hooper", BrungerHooper, ("diffuse_share", "clearness"), level=MIDDLE, failures=UP_TO_A_FACTOR),
    Model("harrison-coombes", HarrisonCoombes, ("cloud",), level=MIDDLE, failures=UP_TO_A_FACTOR),
    Model("pokrowski", Pokrowski, ("constant", "depth"), level=CLEAR, failures=UP_TO_A_FACTOR),
    OvercastModel("overcast", OvercastSky),
    Model("moon-spencer", MoonSpencer, level=OVERCAST, shines=False),
    Model("uniform", Uniform, level=OVERCAST, shines=False),
    AirModel(
        "discrete-ordinates",
        DiscreteOrdinates,
        failures="no polarisation (up to 7 % at 400 nm); one lobe cannot have both the aureole and the sides right",
    ),
    AirModel("klassen-1987", Klassen87),
    AirModel(
        "nishita-1993",
        Nishita93,
        failures="one scattering only: too dark, most of all in the blue and away from the sun",
    ),
    AirModel(
        "nishita-1996", Nishita96, failures="two scatterings only: a few percent (red) to a fifth (blue) too dark"
    ),
    ScatteringModel("precomputed", PrecomputedScattering),
    AirModel("hillaire", Hillaire),
    TracedModel(
        "path-traced",
        PathTraced,
        failures="noise of 1 %, so that its numbers are not fitted; else those of discrete ordinates",
    ),
)


def model_named(name: str) -> Model:
    """The model by name, or of a file, .safetensors or .dat; ValueError with the nearest names there are."""
    if name.endswith(".safetensors"):
        return model_of_file(name)
    if name.endswith(".dat"):
        return model_of_prague_file(name)
    known = {model.name: model for model in CATALOGUE}
    if name not in known:
        near = get_close_matches(name, known, n=2)
        names = ", ".join(key for key in known if not key.removeprefix("cie-").isdigit())
        meant = f" (perhaps {' or '.join(near)})" if near else ""
        raise ValueError(f"model must be one of {names}, cie-1 ... cie-15, got {name!r}{meant}")
    return known[name]


def model_of_file(path: str) -> Model:
    """The model of a network file of the user's own (`skydome train`); ValueError for what is none."""
    if load_network(path)[0].bands:
        return NeuralModel(path, NeuralSpectralSky, ("turbidity", "albedo"), {"network": path})
    return NeuralModel(path, NeuralSky, ("turbidity",), {"network": path})


def model_of_prague_file(path: str) -> Model:
    """The Prague model of a file that its authors publish; ValueError for what is none."""
    ground = ("albedo",) if read_prague(path).albedos.size > 1 else ()
    return Model(path, Prague, ("visibility", "altitude", *ground), {"data": path})


def usually_fitted(kind: type[Sky]) -> tuple[str, ...]:
    """What `fit` looks for in a class of sky where nobody says; empty for a class that the catalogue does not tell."""
    return next((model.fitted for model in CATALOGUE if model.kind is kind and model.fitted), ())

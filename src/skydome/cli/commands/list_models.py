"""`skydome models`: every model with its parameters, ranges, rung and source, as the classes tell them."""

from dataclasses import MISSING, fields
from typing import TYPE_CHECKING, Any

from skydome.cli.models import LEVELS
from skydome.cli.options import AsJson, SkyOptions, option_name
from skydome.cli.printing import print_json

if TYPE_CHECKING:
    from skydome.skies.model import Model


def models(as_json: AsJson = False) -> None:
    """List the sky models: parameters with their ranges, what they know, and their source."""
    from skydome.skies.catalogue import CATALOGUE

    facts = [model_facts(model) for model in CATALOGUE]
    if as_json:
        print_json(facts)
    else:
        print_models(facts)


def model_facts(model: "Model") -> dict[str, Any]:
    """A model's name, class, rung, parameters and source."""
    kind = model.kind
    known = {item.name for item in fields(kind)}
    return {
        "name": model.name,
        "class": kind.__name__,
        "rung": rung(kind),
        "parameters": taken_facts(model) if "atmosphere" in known else own_facts(model),
        "fixed": dict(model.fixed),
        "needs_level": model.level_name is not None,
        "source": kind.source,
        "about": (kind.__doc__ or "").strip().splitlines()[0],
    }


def rung(kind: type) -> str:
    """What the model knows: luminance, colour or spectrum."""
    import skydome as sd

    if issubclass(kind, sd.SpectralSky):
        return "spectral"
    return "colour" if issubclass(kind, sd.ColourSky) else "luminance"


def own_facts(model: "Model") -> list[dict[str, Any]]:
    """The parameters of the class, less those that the name settles, and those whose option the model does not take."""
    ranges, left_out = model.kind.ranges, {"check", *model.fixed}
    known = [parameter_facts(item, ranges.get(item.name)) for item in fields(model.kind) if item.name not in left_out]
    taken = {"sun", *model.takes, *((model.level_name, *LEVELS) if model.level_name else ())}
    return [facts for facts in known if facts["option"] is None or facts["name"] in taken]


def taken_facts(model: "Model") -> list[dict[str, Any]]:
    """The parameters of a model that makes its class's from the options that it takes: the air's."""
    from skydome.skies.model import USUAL

    sun = {"name": "sun", "option": "--sun", "required": True}
    return [sun] + [
        {"name": name, "option": option_name(name), "required": False, "default": USUAL.get(name)}
        for name in model.takes
    ]


def parameter_facts(item: Any, interval: Any) -> dict[str, Any]:
    """A parameter's name, option, range with unit, and default."""
    name = "zenith_luminance" if item.name == "value" else item.name
    option = option_name(name) if name in SkyOptions.__dataclass_fields__ else None
    facts: dict[str, Any] = {"name": item.name, "option": option, "required": item.default is MISSING}
    if item.default is not MISSING:
        facts["default"] = item.default
    if interval is not None:
        facts |= {"range": [interval.low, interval.high], "unit": interval.unit}
    return facts


def parameter_text(facts: dict[str, Any]) -> str:
    """A parameter in a line of the table."""
    text: str = facts["option"] or facts["name"]
    if "range" in facts:
        low, high = facts["range"]
        text += f" in [{low:g}, {high:g}] {facts['unit']}".rstrip()
    if facts.get("default") is not None:
        text += f" = {facts['default']}"
    return text


def families(facts: list[dict[str, Any]]) -> list[list[dict[str, Any]]]:
    """The models in groups of one class, in the order of the catalogue."""
    found: dict[str, list[dict[str, Any]]] = {}
    for entry in facts:
        found.setdefault(entry["class"], []).append(entry)
    return list(found.values())


def print_models(facts: list[dict[str, Any]]) -> None:
    """The table for people; models that differ in name alone share a row."""
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    table = Table(box=None, pad_edge=False)
    for heading in ("model", "knows", "parameters", "source"):
        table.add_column(heading, overflow="fold")
    table.columns[0].no_wrap = table.columns[1].no_wrap = True
    for alike in families(facts):
        entry, names = alike[0], [model["name"] for model in alike]
        several = f"{names[0]} ... {names[-1]}" if entry["class"] == "CIE" else "\n".join(names)
        parameters = "\n".join(parameter_text(item) for item in entry["parameters"] if item["name"] != "sun")
        table.add_row(Text(several, style="bold"), entry["rung"], Text(parameters), Text(entry["source"]))
        table.add_section()
    Console().print(table)

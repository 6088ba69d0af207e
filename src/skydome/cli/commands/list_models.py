"""`skydome models`: every model with its parameters, ranges, rung and source, as the classes tell them."""

from dataclasses import MISSING, fields
from typing import TYPE_CHECKING, Any

from skydome.cli.models import LETTERS, LEVELS
from skydome.cli.options import AsJson, option_name
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
    return {
        "name": model.name,
        "class": kind.__name__,
        "rung": rung(kind),
        "parameters": [parameter_facts(model, name) for name in taken(model)],
        "fixed": dict(model.fixed),
        "needs_level": model.level_name is not None and not model.knows_level,
        "usual_levels": [] if model.level is None else [model.level.whose],
        "source": kind.source,
        "about": (kind.__doc__ or "").strip().splitlines()[0],
    }


def rung(kind: type) -> str:
    """What the model knows: luminance, colour or spectrum."""
    import skydome as sd

    if issubclass(kind, sd.SpectralSky):
        return "spectral"
    return "colour" if issubclass(kind, sd.ColourSky) else "luminance"


def taken(model: "Model") -> list[str]:
    """The names of what a user gives: the sun, the model's parameters, and its level."""
    levels = [name for name in LEVELS if name in model.needed or model.level_name] if model.level_name else []
    return [*(["sun"] if model.has_sun else []), *model.takes, *levels]


def parameter_facts(model: "Model", name: str) -> dict[str, Any]:
    """A parameter's name, option, range with unit, and what is taken where it is not given."""
    from skydome.skies.model import USUAL

    kind: Any = model.kind
    own = next((item for item in fields(kind) if item.name == name), None)
    default = USUAL.get(name, None if own is None or own.default is MISSING else own.default)
    facts: dict[str, Any] = {
        "name": name,
        "option": "--letters" if name in LETTERS else option_name(name),
        "required": model.needed.get(name, False) and default is None and name not in LEVELS,
    }
    if isinstance(default, str | int | float):
        facts["default"] = default
    if (interval := kind.ranges.get(name)) is not None:
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


def print_models(facts: list[dict[str, Any]]) -> None:
    """The table for people."""
    from rich.console import Console
    from rich.table import Table
    from rich.text import Text

    table = Table(box=None, pad_edge=False)
    for heading in ("model", "knows", "parameters", "source"):
        table.add_column(heading, overflow="fold")
    table.columns[0].no_wrap = table.columns[1].no_wrap = True
    for names, entry in grouped(facts):
        parameters = "\n".join(
            dict.fromkeys(parameter_text(item) for item in entry["parameters"] if item["name"] != "sun")
        )
        if entry["usual_levels"]:
            parameters += f"\nlevel, if none is given: {' or '.join(entry['usual_levels'])}"
        table.add_row(Text(names, style="bold"), entry["rung"], Text(parameters), Text(entry["source"]))
        table.add_section()
    Console().print(table)


def grouped(facts: list[dict[str, Any]]) -> list[tuple[str, dict[str, Any]]]:
    """Rows of the table: the names of models that take the same and differ in what their names settle only."""
    rows: dict[str, list[dict[str, Any]]] = {}
    for entry in facts:
        key = "CIE" if entry["class"] == "CIE" else f"{entry['class']} {entry['parameters']}"
        rows.setdefault(key, []).append(entry)
    return [(names_of(each), each[0] | {"usual_levels": usual_levels(each)}) for each in rows.values()]


def names_of(alike: list[dict[str, Any]]) -> str:
    """The names of a row."""
    return "cie-1 ... cie-15" if alike[0]["class"] == "CIE" else "\n".join(entry["name"] for entry in alike)


def usual_levels(alike: list[dict[str, Any]]) -> list[str]:
    """The usual levels in a row, each once."""
    return list(dict.fromkeys(level for entry in alike for level in entry["usual_levels"]))

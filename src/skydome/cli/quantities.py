"""Quantities as people write them: 20km, 5000m, 0.5%."""


def metres_from(text: str) -> float:
    """A distance in metres, from 20km or 20000m; ValueError for anything else.

    >>> metres_from("20km"), metres_from("1500 m")
    (20000.0, 1500.0)
    """
    value, unit = text.strip().lower(), 1.0
    for ending, size in (("km", 1000.0), ("m", 1.0)):
        if value.endswith(ending):
            value, unit = value.removesuffix(ending), size
            break
    try:
        metres = float(value) * unit
    except ValueError:
        metres = float("nan")
    if not 0 < metres < float("inf"):
        raise ValueError(f"a visibility is a distance such as 20km or 5000m, got {text!r}")
    return metres


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


def minutes(text: str | None) -> float | str | None:
    """The shift that --shift asks for; ValueError for what is neither auto nor minutes.

    >>> minutes("auto"), minutes("-30"), minutes(None)
    ('auto', -30.0, None)
    """
    if text is None or text == "auto":
        return text
    try:
        return float(text)
    except ValueError:
        raise ValueError(f"--shift must be auto or minutes such as 30, got {text!r}") from None

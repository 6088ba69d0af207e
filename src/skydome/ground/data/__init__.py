"""Tables of measured and fitted figures, and networks, each with its source; `ground.tables` reads the tables."""

from importlib.resources import files

DATA = files(__name__)

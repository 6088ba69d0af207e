"""A year of skies. The module is itself `skydome.year(...)`: both names are one, whichever is imported first."""

import sys
from types import ModuleType
from typing import Any


class CallableModule(ModuleType):
    """A module that, called, makes a year: see `skydome.year.series.year`."""

    def __call__(self, *arguments: Any, **choices: Any) -> Any:
        """The Dataset of `skydome.year.series.year`."""
        from skydome.year.series import year

        return year(*arguments, **choices)


sys.modules[__name__].__class__ = CallableModule

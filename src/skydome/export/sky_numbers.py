"""The numbers of a sky in its code: written as constants, or read from an array that the program sets."""

from abc import ABC, abstractmethod

import numpy as np

from skydome.export.shader_languages import Language, number


class Numbers(ABC):
    """How a sky's numbers come into its code."""

    @abstractmethod
    def spelled(self, value: float) -> str:
        """The expression of a number of the sky."""

    @abstractmethod
    def weighted(self, row: np.ndarray, names: list[str]) -> str:
        """The expression of a weighted sum of named values."""

    def all(self, values: np.ndarray) -> str:
        """The expressions of numbers, as arguments."""
        return ", ".join(self.spelled(value) for value in values)


class Constants(Numbers):
    """Written out; terms of weight 0 are left out."""

    def spelled(self, value: float) -> str:
        """Nine digits."""
        return number(value)

    def weighted(self, row: np.ndarray, names: list[str]) -> str:
        """Without the terms of weight 0."""
        terms = [f"{number(weight)} * {name}" for weight, name in zip(row, names, strict=True) if weight != 0]
        return " + ".join(terms) or "0.0"


class Uniforms(Numbers):
    """Read by index in a `language`: the code is the same for every sky of its form, and `values` are this one's."""

    def __init__(self, language: Language) -> None:
        self.language = language
        self.values: list[float] = []

    def spelled(self, value: float) -> str:
        """The next number."""
        self.values.append(float(value))
        return self.language.read.format(k=len(self.values) - 1)

    def weighted(self, row: np.ndarray, names: list[str]) -> str:
        """Every term."""
        return " + ".join(f"{self.spelled(weight)} * {name}" for weight, name in zip(row, names, strict=True))

    def table(self, values: np.ndarray) -> int:
        """The index of the first of many numbers, which are read at an index that the code works out."""
        self.values.extend(np.ravel(values).tolist())
        return len(self.values) - np.size(values)

    def read_at(self, index: str) -> str:
        """The number at an index, a float expression."""
        return self.language.read.format(k=self.language.whole.format(x=index))


CONSTANTS = Constants()

"""A training that can be interrupted: what is done so far, in a file beside the network to come."""

import json
from dataclasses import dataclass
from os import PathLike
from pathlib import Path

import numpy as np

from skydome.ground.files.reading import arrays_in
from skydome.ground.writing import appearing

State = dict[str, np.ndarray]
MOST_BYTES = 1 << 30


@dataclass(frozen=True)
class Journal:
    """The file of a training's state, and what the training is (a text); another training's state is refused."""

    path: Path
    about: str

    @classmethod
    def beside(cls, network: str | PathLike[str], about: dict[str, object]) -> "Journal":
        """The journal of a network file: its name and `.training.npz`."""
        return cls(Path(f"{network}.training.npz"), json.dumps(about, sort_keys=True, default=str))

    def write(self, **state: np.ndarray) -> None:
        """Keep the state, whole or not at all."""
        with appearing(self.path) as beside, beside.open("wb") as file:
            np.savez(file, about=np.array(self.about), **state)  # type: ignore[arg-type]

    def read(self) -> State | None:
        """The state, None without a file; ValueError for a damaged one, or another training's."""
        if not self.path.exists():
            return None
        try:
            state = arrays_in(self.path, "a training's state", {"about"}, MOST_BYTES, None)
        except ValueError as error:
            raise ValueError(f"{error}; remove it to begin anew") from error
        if str(state.pop("about", "")) != self.about:
            raise ValueError(f"{self.path.name} belongs to another training; remove it to begin anew")
        return state

    def forget(self) -> None:
        """Remove the file."""
        self.path.unlink(missing_ok=True)

"""The evaluation's figures and table: `python docs/figures/evaluation.py path/to/kider2014_open.nc` (some minutes)."""

import subprocess
import sys
import tempfile
from pathlib import Path

from PIL import Image

MODELS = (
    "preetham,hosek-wilkie,nishita-1993,nishita-1996,discrete-ordinates,refitted,two-lobe-air,bruneton-air,path-traced"
)


def main(measured, here=Path(__file__).parent):
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-m", "skydome", "evaluate", measured, "--models", MODELS, "--figures", folder]
        subprocess.run([*command, "--table", str(here / "evaluation.csv")], check=True)
        for path in Path(folder).glob("*.png"):
            small = Image.open(path).convert("RGB").quantize(256, kmeans=3, dither=Image.Dither.NONE)
            small.save(here / path.name, optimize=True)


if __name__ == "__main__":
    main(sys.argv[1])

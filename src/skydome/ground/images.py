"""Pictures in and out, by format."""

from skydome.ground.exr import read_exr, write_exr
from skydome.ground.hdr import read_hdr, write_hdr
from skydome.ground.png import write_png

__all__ = ["read_exr", "read_hdr", "write_exr", "write_hdr", "write_png"]

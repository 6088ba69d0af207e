"""The newest libLLVM by which Mitsuba's llvm variant runs on this machine."""

import os
import re
import subprocess
import sys
from collections.abc import Iterable
from glob import glob

PATTERNS = ("/usr/lib/*/libLLVM*.so*", "/usr/lib/llvm-*/lib/libLLVM*.so*", "/opt/homebrew/opt/llvm*/lib/libLLVM*.dylib")

NO_LLVM = "no libLLVM that works here; install the newest there is (libllvm19 or later): 16 aborts on new processors"

TRIAL = """
import drjit as dr, mitsuba as mi
mi.set_variant("llvm_ad_rgb")
emitter = mi.load_dict({"type": "sunsky", "turbidity": 3.0, "sun_scale": 0.0, "sun_direction": [0.0, 0.6, 0.8]})
points = dr.zeros(mi.SurfaceInteraction3f, 64)
points.wi = mi.Vector3f(0.0, 0.0, -1.0)
dr.eval(emitter.eval(points))
dr.sync_thread()
"""


def llvm_library() -> str | None:
    """Path of the newest libLLVM by which Mitsuba runs here; DRJIT_LIBLLVM_PATH where it is set and works.

    Each is tried in a process of its own: a version that does not know the processor ends the process that asks.
    """
    own = os.environ.get("DRJIT_LIBLLVM_PATH")
    installed = (path for pattern in PATTERNS for path in glob(pattern))
    return next((path for path in ([own] if own else newest_first(installed)) if runs_with(path)), None)


def newest_first(paths: Iterable[str]) -> list[str]:
    """Files of libLLVM, one of each version from 15 on, the newest first.

    >>> newest_first(["libLLVM-16.so.1", "libLLVM.so.19.1", "libLLVM-9.so", "libLLVM.so"])
    ['libLLVM.so.19.1', 'libLLVM-16.so.1']
    """
    versions = {int(found[1]): path for path in sorted(paths) if (found := re.search(r"libLLVM\D*(\d+)", path))}
    return [versions[version] for version in sorted(versions, reverse=True) if version >= 15]


def runs_with(library: str) -> bool:
    """Whether Mitsuba computes its sky with this libLLVM, tried in a process of its own."""
    environment = os.environ | {"DRJIT_LIBLLVM_PATH": library}
    try:
        tried = subprocess.run([sys.executable, "-c", TRIAL], env=environment, capture_output=True, timeout=120)
        return tried.returncode == 0
    except subprocess.TimeoutExpired:
        return False

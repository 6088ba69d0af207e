"""One hash for the same contents, another where one number differs, however things are printed or named."""

import numpy as np
import pytest

import skydome as sd
from skydome.ground.files.contents import digest_of, digest_of_file


def air(depth, last=0.1):
    """Depths whose printed form leaves out the middle."""
    depths = np.full(2001, 0.1)
    depths[400:-400], depths[-500] = depth, last
    return sd.Atmosphere((sd.Molecules(), sd.Aerosol(sd.Spectrum(np.linspace(300, 1100, 2001), depths))))


def test_a_number_in_the_middle_of_a_long_array_counts():
    assert repr(air(0.1)) == repr(air(2.0))
    assert digest_of(air(0.1)) == digest_of(air(0.1))
    assert digest_of(air(0.1)) != digest_of(air(2.0))
    assert digest_of(air(0.1)) != digest_of(air(0.1, last=np.nextafter(0.1, 1)))


def test_neighbours_are_not_mistaken():
    different = [("ab", "c"), ("a", "bc"), ("abc",), (("ab", "c"),), (1,), (1.0,), (True,), ([1],), ((1,),), (None,)]
    different += [(np.float32(1),), (np.ones(1),), (np.ones((1, 1)),), (0.0,), (-0.0,), ({"a": 1},), (sd.Ozone(),)]
    assert len({digest_of(*values) for values in different}) == len(different)


def test_what_has_no_contents_is_refused():
    with pytest.raises(TypeError, match="got function"):
        digest_of(air)


def test_a_file_is_its_bytes(tmp_path):
    for name in ("a", "b"):
        (tmp_path / name).write_bytes(b"same")
    assert digest_of_file(tmp_path / "a") == digest_of_file(tmp_path / "b")


def test_a_tracing_is_not_taken_up_with_another_air(tmp_path):
    """It printed .0449 for .1625 W m-2 sr-1 nm-1."""
    pytest.importorskip("numba")
    thin, thick = (
        sd.PathTraced(np.array([0.0, 0.6, 0.8]), air(depth)).job(np.array([[0, 0, 1.0]]), [700.0]) for depth in (0.1, 2)
    )
    thin.start().more(2).save(tmp_path / "thin.npz")
    assert thin.start().resumed(tmp_path / "thin.npz").passes == (0, 1)
    with pytest.raises(ValueError, match="holds another tracing"):
        thick.start().resumed(tmp_path / "thin.npz")

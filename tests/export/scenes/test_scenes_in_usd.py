"""The USD stage by USD's own library: its schema knows every attribute, and the lamp gives the printed light."""

import numpy as np
import pytest

import skydome as sd


@pytest.fixture
def stage(sky, tmp_path):
    """The stage, opened by pxr."""
    usd = pytest.importorskip("pxr.Usd")
    sd.save_scene(sky.whole, tmp_path / "sky.usda", height=32)
    return usd.Stage.Open(str(tmp_path / "sky.usda"))


def test_the_schema_knows_every_attribute(stage):
    from pxr import Gf, UsdLux

    for prim in stage.Traverse():
        known = set(prim.GetPrimDefinition().GetPropertyNames()) | {"xformOp:transform"}
        assert set(prim.GetAuthoredPropertyNames()) <= known
    dome = UsdLux.DomeLight_1(stage.GetPrimAtPath("/Sky/Dome"))
    assert (dome.GetPoleAxisAttr().Get(), dome.GetTextureFormatAttr().Get()) == ("Y", "latlong")
    assert dome.GetTextureFileAttr().Get().resolvedPath.endswith("sky.exr")
    assert Gf.ColorSpace.IsValid(dome.GetTextureFileAttr().GetColorSpace())


def test_the_lamp_is_the_sun(sky, stage):
    """L = intensity x color over the disc of `angle`: E = L pi sin^2(angle / 2)."""
    from pxr import Usd, UsdGeom, UsdLux

    sun = UsdLux.DistantLight(stage.GetPrimAtPath("/Sky/Sun"))
    turn = np.array(UsdGeom.Xformable(sun).ComputeLocalToWorldTransform(Usd.TimeCode.Default()))[:3, :3]
    np.testing.assert_allclose(turn @ turn.T, np.eye(3), atol=1e-8)
    assert np.linalg.det(turn) == pytest.approx(1)
    travels = np.array([0, 0, -1.0]) @ turn
    np.testing.assert_allclose(-travels, sd.target("usd").frame_vectors(sky.sun), atol=1e-8)
    half = np.radians(sun.GetAngleAttr().Get()) / 2
    light = sun.GetIntensityAttr().Get() * (np.array(sun.GetColorAttr().Get()) @ sd.SRGB.to_xyz[1])
    facing = light * np.pi * np.sin(half) ** 2
    assert facing == pytest.approx(float(sd.illuminance(sd.SunDisc.of(sky.clear), sky.sun)), rel=1e-5)
    assert not sun.GetNormalizeAttr().Get()
    assert not sun.GetEnableColorTemperatureAttr().Get()

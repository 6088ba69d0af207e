"""The Mitsuba scene in Mitsuba itself: a grey floor's light, and a ball's shadow."""

import numpy as np
import pytest

import skydome as sd

pytestmark = pytest.mark.slow

AROUND = """<scene version="3.0.0">
<include filename="sky.xml"/>
<integrator type="path"><integer name="max_depth" value="2"/></integrator>
<shape type="rectangle"><transform name="to_world"><scale value="50"/><rotate x="1" angle="-90"/></transform>
<bsdf type="diffuse"><rgb name="reflectance" value="0.5"/></bsdf></shape>{more}
<sensor type="orthographic"><transform name="to_world"><scale value="{half}"/>
<lookat origin="0,9,0" target="0,0,0" up="0,0,-1"/></transform>
<film type="hdrfilm"><integer name="width" value="{pixels}"/><integer name="height" value="{pixels}"/>
<rfilter type="box"/></film><sampler type="independent"><integer name="sample_count" value="{samples}"/></sampler>
</sensor></scene>"""
BALL = '<shape type="sphere"><point name="center" x="0" y="1" z="0"/><float name="radius" value="0.3"/></shape>'


def rendered(folder, **choices):
    """Luminance of a square that a camera sees from above, north up, in the map's unit."""
    mi = pytest.importorskip("mitsuba")
    mi.set_variant("scalar_rgb")
    (folder / "around.xml").write_text(AROUND.format(**choices))
    return np.array(mi.render(mi.load_file(str(folder / "around.xml")))) @ sd.SRGB.to_xyz[1]


def test_the_floor_has_the_light_that_is_printed(sky, tmp_path):
    scene = sd.save_scene(sky.whole, tmp_path / "sky.xml", height=256)
    seen = rendered(tmp_path, more="", half=0.01, pixels=8, samples=2048).mean()
    assert seen * np.pi / 0.5 == pytest.approx(sky.level, rel=0.01)
    assert sum(scene.horizontal) == pytest.approx(sky.level, rel=1e-6)


def test_shadows_fall_away_from_the_sun(sky, tmp_path):
    sd.save_scene(sky.whole, tmp_path / "sky.xml", height=64)
    seen = rendered(tmp_path, more=BALL, half=2.0, pixels=64, samples=64)
    place = (np.arange(64) + 0.5) / 64 * 4 - 2
    seen[np.hypot(*np.meshgrid(place, place)) < 0.35] = np.median(seen)  # the ball itself
    east, north = np.meshgrid(place, -place)
    assert sky.shadow_azimuth(seen, east, north) == pytest.approx(sky.shadow, abs=0.5)

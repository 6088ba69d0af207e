"""Fields of cloud: shape and cover, light against closed forms and discrete ordinates, and the sky that results."""

from dataclasses import dataclass, replace

import numpy as np
import pytest

import skydome as sd
from skydome.air.clouds.particles import CloudOptics, CloudParticles, Water
from skydome.air.phase_laws import HenyeyGreenstein
from skydome.air.profiles import Tabulated
from skydome.ground.limits.ranges import Range
from skydome.ground.quadrature import hemisphere
from skydome.skies.clouds.fields import noise
from skydome.skies.clouds.fields.air.sunlight import SIDES
from skydome.skies.clouds.fields.field import CloudField
from skydome.skies.clouds.fields.incident import Incident
from skydome.skies.clouds.fields.kinds import Slab
from skydome.skies.clouds.fields.lit_field import LitField
from skydome.skies.clouds.fields.reference import beam, laws_of, photon_shares, traced_through
from skydome.skies.clouds.fields.scattering import ANGLES, DEPTHS, Scattering, grid
from skydome.skies.clouds.fields.shadows import sun_share
from skydome.skies.clouds.fields.thickening import Thickening

pytest.importorskip("numba")
SUN = sd.direction(azimuth=200 * sd.deg, elevation=40 * sd.deg)
VIEWS = sd.direction(np.array([200.0, 200, 110, 20, 20]) * sd.deg, np.array([75.0, 15, 50, 60, 20]) * sd.deg)
HEAPS = CloudField(sd.Cumulus(), cover=0.4, seed=7)
ONE, DARK = np.ones(1), np.zeros((3, 4, 1))


@dataclass(frozen=True)
class Grains(CloudParticles):
    """Particles of one lobe."""

    g: float
    name, radii, usual_radius = "grains", Range(1e-6, 1e-3, "m"), 1e-5

    def optics(self, effective_radius, wavelengths):
        """They absorb nothing."""
        one = np.ones(np.shape(wavelengths))
        return CloudOptics(one, one, self.g * one)

    def phase_law(self, effective_radius):
        """The lobe."""
        return HenyeyGreenstein((self.g,))


def slab(depth, g=0.5):
    """A layer of an optical depth."""
    return CloudField(Slab(Grains(g)), cover=1.0, extinction=depth / 1000.0)


@pytest.mark.parametrize(
    ("readable", "either"), [(noise.gradient_by_numpy, noise.gradient), (noise.cells_by_numpy, noise.cells)]
)
def test_noise_is_the_same_compiled_and_repeats(readable, either):
    points = np.random.default_rng(3).uniform(-9, 9, (noise.FEW + 1, 3))
    known = readable(points, (4, 6, 8), 5)
    np.testing.assert_allclose(either(points, (4, 6, 8), 5), known, atol=1e-12)
    np.testing.assert_allclose(either(points + np.array([4, 12, -8]), (4, 6, 8), 5), known, atol=1e-12)
    assert np.abs(readable(points[:50], (4, 6, 8), 6) - known[:50]).max() > 0.1


@pytest.mark.parametrize("amount", [0.0, 0.4, -0.4])
def test_extinction_is_the_same_compiled(amount):
    from skydome.skies.clouds.fields.medium_kernel import extinctions

    bare = replace(HEAPS, cover=0.7)
    field = replace(bare, thicker=Thickening((0.5, 0.1, 0.5), amount) if amount else None)
    points = np.random.default_rng(3).uniform([-2e4, -2e4, 900], [2e4, 2e4, 2700], (20_000, 3))
    out = np.empty(len(points))
    extinctions(0, len(points), field.medium, points, out)
    np.testing.assert_allclose(out, field.extinction_at(points), atol=1e-8)
    more = out.sum() - bare.extinction_at(points).sum()
    assert np.sign(more.round(4)) == np.sign(amount)


@pytest.mark.parametrize("cover", [0.2, 0.6])
def test_cover_is_the_share_of_columns_with_cloud(cover):
    field = CloudField(sd.Cumulus(), cover=cover, seed=7)
    over = np.random.default_rng(1).uniform(0, field.kind.period, (2500, 1, 2))
    heights = np.linspace(field.base, field.top, 61)
    points = np.concatenate(
        [np.broadcast_to(over, (2500, 61, 2)), np.broadcast_to(heights[:, None], (2500, 61, 1))], -1
    )
    depths = np.trapezoid(field.extinction_at(points), heights, axis=1)
    assert abs((depths > 0.03).mean() - cover) < 0.04


def test_wind_moves_the_field():
    field = CloudField(sd.Cumulus(), 0.4, seed=7, wind=(10.0, -5.0))
    points = np.random.default_rng(2).uniform([0, 0, 1200], [9e3, 9e3, 2000], (500, 3))
    np.testing.assert_allclose(
        field.later(60.0).extinction_at(points + np.array([600, -300, 0])), field.extinction_at(points)
    )


def test_ordinates_through_a_slab():
    lit = LitField.of(slab(10.0, 0.85), SUN)
    _, of_sun, of_sky, back = lit.budget
    assert of_sky == pytest.approx(4 / 3 / (10 * 0.15 + 1.4209), rel=0.005)  # Milne's problem on either side
    assert of_sky + back == pytest.approx(1.0, abs=1e-3)
    straight, scattered = lit.budget[0], of_sun / SUN[2]
    up, down, direct, taken = photon_shares(lit, 6000)
    assert up + down + direct + taken == pytest.approx(1.0)
    assert straight + scattered == pytest.approx(down + direct, abs=0.03)
    assert photon_shares(lit, 2000, 0.98)[3] > 0.2


@pytest.mark.parametrize(("thickness", "extinction"), [(1000.0, 0.3), (300.0, 0.9)])
def test_dense_slab_is_dark(thickness, extinction):
    """Seen by rays, it sends down what two streams leave of a depth of 270-300."""
    field = CloudField(Slab(Water()), cover=1.0, thickness=thickness, extinction=extinction)
    nodes, each = hemisphere(8, 16)
    lit = LitField.of(field, SUN)
    of_sun, of_sky, of_ground = ((each * nodes[:, 2]) @ lit.seen(nodes)[:, 1:4]).tolist()
    known = 1 / (1 + 0.75 * thickness * extinction * (1 - lit.asymmetry))
    assert of_sky == pytest.approx(known, rel=0.03)
    assert of_ground == pytest.approx(1 - known, rel=0.001)
    assert of_sun == pytest.approx(lit.budget[1], rel=0.03)


@pytest.mark.parametrize("particles", [Grains(0.0), Water()])
def test_thin_slab_scatters_once(particles):
    lit = LitField.of(CloudField(Slab(particles), cover=1.0, extinction=0.02 / 1000.0), SUN)
    seen, law = lit.seen(VIEWS), particles.phase_law(1e-5).value(VIEWS @ SUN, [550.0])[:, 0]
    sunlight = seen[:, 1] + lit.scattering().once(VIEWS @ SUN, seen[:, 5:])[:, 0]
    np.testing.assert_allclose(sunlight, 0.02 / VIEWS[:, 2] * law, rtol=0.06, atol=3e-4)
    np.testing.assert_allclose(seen[:, 0], np.exp(-0.02 * lit.kept / VIEWS[:, 2]), rtol=0.002)
    assert sun_share(lit.field, SUN, np.zeros((1, 3)))[0] == pytest.approx(np.exp(-0.02 / SUN[2]), rel=1e-4)


def test_fields_and_layers_scatter_by_one_law():
    for kind, layer in (
        (sd.Cumulus(), Water()),
        (sd.Cirrus(sd.HexagonalIce()), sd.HexagonalIce()),
        (sd.Altocumulus(effective_radius=6e-6), Water()),
    ):
        cosine = np.cos(np.radians([1.0, 22.0, 90.0, 141.0]))
        known = layer.phase_law(kind.radius).value(cosine, [450.0, 650.0])
        weights = np.eye(2)
        law = Scattering.of(kind.law, 0.7, [450.0, 650.0], weights)
        once = law.once(cosine, np.eye(DEPTHS)[np.zeros(4, int)])  # through no depth: the law itself
        np.testing.assert_allclose(once * (1 - 0.7), known, rtol=0.02)


def test_a_peak_of_diffraction_leaves_no_rings():
    kind = sd.Cirrus(sd.HexagonalIce(), effective_radius=80e-6)
    scattering = Scattering.of(kind.law, 0.6, [450.0, 650.0], np.eye(2), kind.particles.peaked)
    between = np.cos(np.radians(np.linspace(1.5, 16.0, 80)))
    light = scattering.once(between, np.eye(DEPTHS)[np.full(80, 4)])
    assert (np.diff(light, axis=0) < 0.01 * light[1:]).all()


def test_what_many_small_turns_leave_of_a_law():
    law = LitField.of(HEAPS, SUN).scattering()
    _, solid = grid(ANGLES)
    assert (solid @ law.peaks)[0] == pytest.approx(law.peak, abs=1e-3)
    f, t = law.peak, 0.2 * np.expm1(0.337 * np.arange(DEPTHS))[1:]
    known = 1 - np.expm1(-f / (1 - f) * t) / t  # moment 0
    np.testing.assert_allclose(np.einsum("a,kac->k", solid, law.seeming)[1:], known, rtol=0.02)
    forward, side = law.seeming[:, 0, 0], law.seeming[:, ANGLES * 7 // 10, 0]
    assert (np.diff(forward) < 0).all()
    assert side[-1] > 5 * side[0]


def test_the_sun_s_light_is_all_told():
    lit = LitField.of(HEAPS, SUN)
    assert lit.straight(SUN[2]) + sum(lit.sunlight[1]) / SUN[2] == pytest.approx(1.0, abs=0.003)
    assert sum(lit.skylight[1]) == pytest.approx(1.0, abs=0.003)
    assert photon_shares(lit, 2000).sum() == pytest.approx(1.0, abs=0.005)


def test_absorption_dims_the_near_infrared():
    lit = LitField.of(HEAPS, SUN)
    share = photon_shares(lit, 8000, 0.98)[1] / photon_shares(lit, 8000)[1]
    assert lit.dimming(np.array([0.0, 0.02]))[0] == pytest.approx([1.0, share], abs=0.08)
    light = Incident.of_spectrum(sd.PhysicalSky(SUN), lit, [1000.0, 1650.0])
    assert light.lost == pytest.approx(1 - Water().optics(1e-5, [1000.0, 1650.0]).albedo)
    assert light.dimming[0, 1] < 0.98 * light.dimming[0, 0]


@pytest.mark.parametrize("albedo", [0.0, 0.5])
def test_paths_through_a_slab_meet_discrete_ordinates(albedo):
    pytest.importorskip("nanodisort")
    field, profile = slab(3.0), Tabulated((999.5, 1000.5, 1999.5, 2000.5), (0.0, 1.0, 1.0, 0.0))
    air = sd.Atmosphere((sd.Aerosol(3.0, 0.0, 1.0, field.kind.law, profile),), albedo, radius=6.371e9, height=5000.0)
    known = sd.DiscreteOrdinates(SUN, air, streams=32).radiance(VIEWS, [550.0])[:, 0] / air.sun_at([550.0])[0]
    lit = LitField.of(field, SUN)
    lights = beam(lit, ONE, albedo)
    laws = laws_of(lit.scattering())
    passes = np.array([traced_through(lit, laws, VIEWS, lights, DARK, 800, 0, n)[:, 0] for n in range(10)])
    error = passes.std(axis=0, ddof=1) / np.sqrt(len(passes))
    assert (np.abs(passes.mean(axis=0) - known) < 3 * error).all()
    assert (error < 0.05 * known).all()


@pytest.fixture(scope="module")
def sky():
    """A sky of heaps."""
    return sd.CloudySky(sd.PhysicalSky(SUN), HEAPS)


def test_without_cloud_the_sky_is_the_clear_one():
    clear = sd.PhysicalSky(SUN)
    np.testing.assert_allclose(sd.CloudySky(clear, CloudField(cover=0.0)).xyz(VIEWS), clear.xyz(VIEWS), rtol=0.01)


def test_spectrum_and_colour_agree(sky):
    from skydome.light.spectrum import xyz_weights

    light = sky.radiance(VIEWS, sky.bands) @ xyz_weights(sky.bands)
    np.testing.assert_allclose(light, sky.xyz(VIEWS), rtol=0.03)
    assert (sky.xyz(-VIEWS) == 0).all()


def test_far_clouds_melt_into_the_air_before_them(sky):
    low = sd.direction(np.linspace(0, 6, 24), 0.15 * sd.deg)
    near = sd.direction(np.linspace(0, 6, 24), 20 * sd.deg)
    uneven = [np.std(sky.luminance(v) / sky.clear.luminance(v)) for v in (low, near)]
    assert uneven[0] < 0.2 * uneven[1]


def test_air_below_a_dark_cover_is_dark(sky):
    far = sd.direction(np.linspace(0, 6, 24), 0.5 * sd.deg)
    dark = sd.CloudySky(sky.clear, CloudField(sd.Cumulus(), 1.0, extinction=0.4, seed=7))
    assert (dark.luminance(far) < 0.15 * sky.clear.luminance(far)).all()
    assert dark.colours.direct < 1e-3


def test_fast_form_against_paths(sky):
    views = sd.direction(np.arange(640) * 2.4 % 6.2, np.arcsin((np.arange(640) + 32) / 680))
    views = views[views @ SUN < 0.95]
    traced = sd.CloudTracing(sky, views).start().more(4)
    assert sky.luminance(views).mean() == pytest.approx(traced.radiance[:, 1].mean(), rel=0.08)


def test_paths_are_taken_up_again(sky, tmp_path):
    tracing = sd.CloudTracing(sky, VIEWS, paths_per_pass=2)
    whole, half = tracing.start().more(4), tracing.start().more(2)
    half.save(tmp_path / "part.npz")
    np.testing.assert_allclose(tracing.start().resumed(tmp_path / "part.npz").more(2).radiance, whole.radiance)


def test_sun_is_dimmed_by_the_cloud_before_it(sky):
    share = np.array([sun_share(HEAPS, SUN, np.array([[x, 0.0, 0.0]]))[0] for x in np.linspace(0, 16e3, 9)])
    assert share.min() < 0.1
    assert share.max() == 1.0
    shaded = sd.CloudySky(
        sky.clear, sd.CloudField(sd.Cumulus(), 0.4, seed=7, place=(np.linspace(0, 16e3, 9)[share.argmin()], 0.0))
    )
    assert sd.SunDisc.of(shaded).normal_xyz[1] == pytest.approx(
        sd.SunDisc.of(sky.clear).normal_xyz[1] * shaded.sun_share
    )


@pytest.mark.parametrize(
    ("wrong", "told"),
    [
        ({"cover": 1.2}, r"cover must lie in \[0, 1\], got 1.2"),
        ({"base": -100.0}, r"base must lie in \[50, 20000\] m, got -100"),
        ({"thickness": -5.0}, r"thickness must lie in \[20, 10000\] m, got -5"),
        ({"extinction": -1.0}, r"extinction must lie in \[0, 1\] m-1, got -1"),
    ],
)
def test_refused(wrong, told):
    with pytest.raises(ValueError, match=told):
        CloudField(**wrong)


def test_air_before_the_cloud_is_the_same_compiled(sky):
    light, rng = sky.colours, np.random.default_rng(1)
    views, seen, clear = VIEWS[np.arange(50) % 5], rng.uniform(0, 1, (50, 5 + DEPTHS)), rng.uniform(0, 1, (50, 3))
    seen[:, 4] = rng.uniform(1e3, 9e4, 50)
    tables = light.at(views[:, 2], seen[:, 4])
    _, sky_light, ground, _ = np.moveaxis(tables, 1, 0)
    toward = (views[:, :2] @ SUN[:2]) / np.hypot(*views[:, :2].T) / np.hypot(*SUN[:2])
    side, each = (toward + 1) / 2 * (SIDES - 1), np.arange(50)
    q = np.minimum(side.astype(int), SIDES - 2)
    sides = np.stack([light.before.at(part, views[:, 2], seen[:, 4]) for part in light.sunlit])
    sunlit = sides[q, each] + (sides[q + 1, each] - sides[q, each]) * (side - q)[:, None, None]
    known = light.around(clear, views, seen[:, 4], seen[:, :1])
    known = known + sunlit[:, 0] * seen[:, 1:2] + sky_light * seen[:, 2:3] + ground * seen[:, 3:4]
    known = known + sunlit[:, 1] * light.scattering.once(views @ light.toward, seen[:, 5:])
    np.testing.assert_allclose(light.put_together(clear, views, seen), known, rtol=1e-9)


def test_paths_of_a_night_bring_no_light():
    night = sd.CloudySky(sd.PhysicalSky(sd.direction(0.0, -0.5)), sd.CloudField(cover=0.4))
    assert not np.any(sd.CloudTracing(night, VIEWS).start().more().radiance)


def test_a_wisp_has_no_rim_wherever_it_floats(sky):
    """What passes has the same air before it: before, light jumped where a ray met next to nothing of low cloud."""
    light, seen = sky.colours, np.zeros((3, 5 + DEPTHS))
    seen[:, 0], views = 1 - 1e-9, np.broadcast_to(sd.direction(1.0, 0.3), (3, 3))
    seen[:, 4] = np.array([sky.field.base, 0.5 * (sky.field.base + sky.field.top), sky.field.top]) / views[0, 2]
    found = light.put_together(np.full((3, 3), 1e3), np.ascontiguousarray(views), seen)
    np.testing.assert_allclose(found, found[2:].repeat(3, axis=0), rtol=1e-7)


def test_energy_of_clouds_in_turbid_air_is_told_and_lights_the_field_once():
    clear = sd.PhysicalSky(
        sd.direction(azimuth=3.5, elevation=0.7), sd.Atmosphere.from_turbidity(10.0)
    )  # beyond what was taught below 380 nm
    alone = sd.broadband(clear).diffuse_horizontal
    assert sd.broadband(sd.CloudySky(clear, sd.CloudField(cover=0.0))).diffuse_horizontal == pytest.approx(
        alone, rel=1e-3
    )
    sky = sd.CloudySky(clear, sd.CloudField(cover=0.4))
    held = sky.without_refusal("clamp")
    assert held.lit is sky.lit
    assert (held.check, held.clear.check, sky.check) == ("clamp", "clamp", "raise")


def test_absorption_by_wider_cells_is_that_by_its_own(monkeypatch):
    """What absorption leaves of sun, sky and ground is told by wide cells."""
    wide = LitField.of(HEAPS, SUN).losses
    monkeypatch.setattr("skydome.skies.clouds.fields.lit_field.WIDEST", 64)
    np.testing.assert_allclose(wide, LitField.of(HEAPS, SUN).losses, rtol=0.06)


def test_what_is_clear_does_not_count_as_traced(sky):
    views = sd.direction(
        np.radians([0.0, 90.0, 180.0, 270.0, 20.0, 45.0]), np.radians([60.0, 35.0, 50.0, 70.0, 25.0, 80.0])
    )
    found = sd.CloudTracing(sky, views, paths_per_pass=2).start().more(4)
    errors = found.standard_error / found.radiance
    assert (errors == 0).any()
    assert found.relative_error == np.median(errors[errors > 0])

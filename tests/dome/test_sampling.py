"""Samples of skies follow their density, and estimate light without bias and with less noise than uniform ones."""

import numpy as np
import pytest
from scipy.stats import chi2

import skydome as sd

SEED = 20260621
SIGNIFICANCE = 1e-4
"""Chance that one true density fails one chi-square test."""
COUNT = 200_000


def sun_at(elevation, azimuth=137.0):
    return sd.direction(azimuth * sd.deg, elevation * sd.deg)


def with_disc(sky, **disc):
    return sky + sd.SunDisc.of(sky, **disc)


SKIES = {
    f"{model.__name__}-T{turbidity:g}-{elevation:g}deg": (model, turbidity, elevation)
    for model in (sd.HosekWilkie, sd.HosekWilkieRGB, sd.Preetham)
    for turbidity in (2.0, 3.7, 6.0)
    for elevation in (1.0, 12.0, 45.0, 89.9)
}
OTHERS = {
    "uniform": lambda: sd.Uniform(1000.0),
    "overcast": lambda: sd.CIE(sun_at(30.0), 1, zenith_luminance=9000.0),
    "cie-13": lambda: sd.CIE(sun_at(50.0, 359.9), 13, illuminance=12_000.0),
    "partly-black": lambda: sd.Perez(sun_at(30.0), 4.0, -0.7, -1.5, -1.0, 0.1, illuminance=9000.0),
    "blend": lambda: sd.blend(
        with_disc(sd.HosekWilkie(sun_at(20.0), 3.0)), sd.Daylight(sd.MoonSpencer(zenith_luminance=9000.0)), 0.4
    ),
    "disc-alone": lambda: sd.SunDisc(sun_at(40.0), 3.0),
    "two-suns": lambda: sd.SunDisc(sun_at(40.0), 3.0) + sd.SunDisc(sun_at(20.0, 300.0), 2.0) * 0.5,
    "all-weather": lambda: sd.PerezAllWeather(sun_at(25.0), 700.0, 120.0),
}


def every_sky():
    for name, (model, turbidity, elevation) in SKIES.items():
        yield pytest.param(lambda m=model, t=turbidity, e=elevation: with_disc(m(sun_at(e), t)), id=name)
    yield from (pytest.param(make, id=name) for name, make in OTHERS.items())


Z_EDGES, TURNS = np.linspace(0.0, 1.0, 24), np.linspace(0.0, 2 * np.pi, 42)
"""Bins in z and azimuth, whose edges do not fall on the sampler's own."""


every = pytest.mark.parametrize("make", [*every_sky()])


def overlap(cells, bins):
    """The part of each cell (rows) that lies in each bin (columns), both given by their edges."""
    low = np.maximum(cells[:-1, None], bins[None, :-1])
    high = np.minimum(cells[1:, None], bins[None, 1:])
    return np.maximum(high - low, 0.0) / np.diff(cells)[:, None]


def probability_of_bins(dome):
    """Exact integral of the dome's density over the bins: it is constant in z and azimuth inside a cell."""
    rings, columns = dome.probability.shape
    heights, turns = dome.heights, np.linspace(0.0, 2 * np.pi, columns + 1)
    z, turn = (heights[1:] + heights[:-1]) / 2, (turns[1:] + turns[:-1]) / 2
    centres = sd.direction(turn[None, :], np.arcsin(z)[:, None])
    mass = dome.density(centres.reshape(-1, 3)).reshape(rings, columns) * np.diff(heights)[:, None] * turns[1]
    return overlap(heights, Z_EDGES).T @ mass @ overlap(turns, TURNS)


def in_bins(directions):
    return np.histogram2d(directions[:, 2], sd.azimuth(directions), bins=(Z_EDGES, TURNS))[0]


def chi_square(counts, expected):
    """Chance of counts at least as far from those expected; bins of fewer than 10 expected are put together."""
    counts, expected = counts.ravel(), expected.ravel()
    small = expected < 10
    rest, expected_rest = counts[small].sum(), expected[small].sum()
    counts, expected = counts[~small], expected[~small]
    if expected_rest >= 10:
        counts, expected = np.append(counts, rest), np.append(expected, expected_rest)
    else:
        assert rest <= 40
    if len(expected) == 1:
        return 1.0 if counts[0] == expected[0] else 0.0
    return chi2.sf(np.sum((counts - expected) ** 2 / expected), len(expected) - 1)


@every
def test_chi_square_of_sky_and_disc(make):
    """Counts in bins, and in each disc, against the exact integral of the density over them."""
    sampler = sd.SkySampler.of(make())
    directions, _ = sampler.sample(COUNT, SEED)
    expected = COUNT * sampler.shares[0] * probability_of_bins(sampler.dome)
    free = np.ones(COUNT, dtype=bool)
    counts_of_discs, expected_of_discs = [], []
    for disc, share in zip(sampler.discs, sampler.shares[1:], strict=True):
        inside = disc.density(directions) > 0
        behind = COUNT * sampler.shares[0] * sampler.dome.density(disc.sun[None])[0] * disc.solid_angle
        expected -= in_bins(disc.sun[None]) * behind
        counts_of_discs.append(inside.sum())
        expected_of_discs.append(COUNT * share + behind)
        free &= ~inside
    counts = np.append(in_bins(directions[free]), counts_of_discs)
    expected = np.append(expected, expected_of_discs)
    assert expected.sum() == pytest.approx(COUNT, rel=1e-9)
    assert chi_square(counts, expected) > SIGNIFICANCE


@pytest.mark.parametrize("elevation", [0.5, 40.0, 90.0])
def test_chi_square_inside_the_disc(elevation):
    """Equal areas of the disc (rings and sectors of equal solid angle) get equal counts."""
    disc = sd.SunDisc(sun_at(elevation), 3.0)
    directions, density = sd.sample(disc, COUNT, SEED)
    target = sd.SkySampler.of(disc).discs[0]
    np.testing.assert_allclose(density, 1 / target.solid_angle, rtol=1e-12)
    hav = np.sum((directions - disc.sun) ** 2, axis=-1) / 4 / np.sin(disc.angular_radius / 2) ** 2
    assert hav.max() <= 1 + 1e-9
    helper = sd.NORTH if elevation > 80 else sd.ZENITH
    u = np.cross(helper, disc.sun) / np.linalg.norm(np.cross(helper, disc.sun))
    v = np.cross(disc.sun, u)
    turn = np.arctan2(directions @ v, directions @ u)
    counts, _, _ = np.histogram2d(
        np.clip(hav, 0, 1), turn, bins=(np.linspace(0, 1, 11), np.linspace(-np.pi, np.pi, 13))
    )
    assert chi_square(counts, np.full(counts.shape, COUNT / counts.size)) > SIGNIFICANCE


def test_a_wrong_density_fails_the_chi_square():
    """The test has teeth: samples of turbidity 3 are told from the density of turbidity 3.3."""
    sky, other = (sd.SkySampler.of(sd.HosekWilkie(sun_at(30.0), t)) for t in (3.0, 3.3))
    directions, _ = sky.sample(COUNT, SEED)
    assert chi_square(in_bins(directions), COUNT * probability_of_bins(sky.dome)) > SIGNIFICANCE
    assert chi_square(in_bins(directions), COUNT * probability_of_bins(other.dome)) < 1e-12


def uniform_directions():
    z, turn = np.random.default_rng(SEED + 1).random((2, COUNT))
    level, turn = np.sqrt(1 - z**2), 2 * np.pi * turn
    return np.stack([np.sin(turn) * level, np.cos(turn) * level, z], axis=-1)


def uniform_variance(sky, normal):
    """Variance of what uniform samples say; their part of the disc, seldom hit, is put in as a lower bound."""
    sampler, directions = sd.SkySampler.of(sky, normal), uniform_directions()
    seen = 1.0 if normal is None else np.maximum(directions @ normal, 0.0)
    free = np.all([disc.density(directions) == 0 for disc in sampler.discs], axis=0) if sampler.discs else True
    plain = np.where(free, sky.luminance(directions) * seen * 2 * np.pi, 0.0)
    total = plain.mean() / sampler.shares[0] if sampler.shares[0] else 0.0
    discs = sum(
        2 * np.pi * (share * total) ** 2 / d.solid_angle
        for share, d in zip(sampler.shares[1:], sampler.discs, strict=True)
    )
    return np.mean(plain**2) + discs - total**2


@every
@pytest.mark.parametrize("normal", [None, sd.ZENITH, sd.direction(1.0, 0.3)], ids=["sphere", "level", "tilted"])
def test_light_is_estimated_without_bias_and_with_less_noise(make, normal):
    """Integrals of luminance, as such and on planes, within 4 standard errors of the quadrature's."""
    sky = make()
    directions, density = sd.sample(sky, COUNT // 4, SEED, normal=normal)
    light = sky.luminance(directions) / density
    values = light if normal is None else light * np.maximum(directions @ normal, 0)
    truth = float(sd.illuminance(sky, sd.ZENITH if normal is None else normal))
    horizontal = light * np.maximum(directions[:, 2], 0) if normal is None else values
    error = horizontal.std() / np.sqrt(len(values))
    assert abs(horizontal.mean() - truth) < 4 * error + 3e-4 * truth  # the second term is the quadrature's own error
    if sd.SkySampler.of(sky).shares[0] > 0 and not (isinstance(sky, sd.Uniform) and normal is None):
        assert values.var() < 0.6 * uniform_variance(sky, normal)


@every
def test_density_is_nearly_the_luminance_over_its_integral(make):
    sky = make()
    directions, density = sd.sample(sky, 20_000, SEED)
    np.testing.assert_allclose(sd.sample_density(sky, directions), density, rtol=1e-12)
    ratio = sky.luminance(directions) / density
    total = np.mean(ratio)
    assert np.median(np.abs(ratio / total - 1)) < 0.25  # the limb's darkening is not sampled
    assert (density > 0).all()


def test_density_integrates_to_one():
    sampler = sd.SkySampler.of(sd.HosekWilkie(sun_at(30.0), 3.0))
    solid_angle = np.diff(sampler.dome.heights)[:, None] * (2 * np.pi / 512)
    z = (sampler.dome.heights[1:] + sampler.dome.heights[:-1]) / 2
    turn = (np.arange(512) + 0.5) * 2 * np.pi / 512
    centres = sd.direction(turn[None, :], np.arcsin(z)[:, None])
    assert np.sum(sampler.density(centres) * solid_angle) == pytest.approx(1.0, abs=1e-12)
    assert (sampler.density(-centres) == 0).all()


def test_one_seed_gives_one_answer_and_none_gives_none():
    sky = with_disc(sd.HosekWilkie(sun_at(30.0), 3.0))
    np.testing.assert_array_equal(sd.sample(sky, 50, 7)[0], sd.sample(sky, 50, 7)[0])
    assert not np.array_equal(sd.sample(sky, 50, 7)[0], sd.sample(sky, 50, 8)[0])
    directions, density = sd.sample(sky, 0, 7)
    assert directions.shape == (0, 3)
    assert density.shape == (0,)
    assert sd.sample_density(sky, np.zeros((0, 3))).shape == (0,)
    assert sd.sample_density(sky, np.broadcast_to(sd.ZENITH, (2, 5, 3))).shape == (2, 5)


def test_samples_come_in_the_library_of_the_sky():
    torch = pytest.importorskip("torch")
    sky = with_disc(sd.HosekWilkie(torch.tensor(sun_at(30.0), dtype=torch.float32), torch.tensor(3.0)))
    directions, density = sd.sample(sky, 1000, 7)
    assert directions.dtype == density.dtype == torch.float32
    light = sky.luminance(directions)
    assert torch.isfinite(light / density).all()
    expected, _ = sd.sample(with_disc(sd.HosekWilkie(sun_at(30.0), 3.0)), 1000, 7)
    np.testing.assert_allclose(directions.numpy(), expected, atol=1e-4)


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (lambda: sd.sample(sd.HosekWilkie(sun_at(-5.0), 3.0), 10, 1), "a sky needs light to be sampled"),
        (lambda: sd.sample(sd.Uniform(0.0), 10, 1), "a sky needs light to be sampled, got 0"),
        (
            lambda: sd.sample(sd.HosekWilkie(sun_at(np.array([[5.0], [9.0]])), 3.0), 10, 1),
            "one sky is sampled at a time",
        ),
        (lambda: sd.sample(sd.SunDisc(sun_at(np.array([5.0, 9.0])), 3.0), 10, 1), "one sky is sampled at a time"),
        (lambda: sd.sample(sd.Uniform(1.0), -1, 1), "n must be a whole number of directions, at least 0, got -1"),
        (lambda: sd.sample(sd.Uniform(1.0), 2.5, 1), "n must be a whole number"),
        (lambda: sd.sample_density(sd.Uniform(1.0), [0.0, 0.0, 2.0]), "finite unit vectors"),
    ],
)
def test_bad_input(call, message):
    with pytest.raises(ValueError, match=message) as caught:
        call()
    assert "\n" not in str(caught.value)

"""Sky models of one's own: close to the skies they are fitted to and to those between; their file; the command."""

import json
import zipfile

import numpy as np
import pytest
from typer.testing import CliRunner

import skydome as sd
from skydome.air.cross_sections import rayleigh_depth
from skydome.cli.main import app
from skydome.light.spectrum import xyz_weights
from skydome.own_air.bezier_family import bezier_family
from skydome.own_air.bezier_fit import AllSuns
from skydome.own_air.family import SkyFamily
from skydome.own_air.grid import Grid, simulate
from skydome.skies.formula.sky_tables import SkyTables
from skydome.skies.hosek_wilkie import BANDS, published

pytest.importorskip("scipy")
pytest.importorskip("nanodisort")
pytest.importorskip("zarr")
W = (450.0, 650.0)


def physical(sun, turbidity, albedo):
    return sd.DiscreteOrdinates(
        sun, sd.Atmosphere.standard((turbidity - 1) * float(rayleigh_depth([550.0])[0]), albedo=albedo)
    )


def published_tables():
    nodes = np.arange(1.0, 11.0), (0.0, 1.0), BANDS
    return SkyTables(*nodes, published("spectral"), np.zeros((10, 2, 11)))


def away(tables, family):
    """Relative RMS errors of the tables' sky, (T, A, E, W)."""
    views, share = family.views.directions, family.views.solid_angles / family.views.solid_angles.sum()
    suns = sd.direction(np.pi, family.elevations)[:, None, :]
    light = np.stack(
        [
            [sd.HosekWilkie(suns, t, a, tables=tables).radiance(views, family.wavelengths) for a in family.albedos]
            for t in family.turbidities
        ]
    )
    return np.sqrt(np.einsum("d,taedw->taew", share, (light / family.radiance - 1) ** 2))


def rms(values):
    return float(np.sqrt((values**2).mean()))


@pytest.fixture(scope="module")
def tables():
    return bezier_family(SkyFamily.of(physical, (2.0, 3.0, 4.0), (0.0, 1.0), W))


def test_the_family_is_within_four_per_cent_over_suns_and_turbidities(tables):
    assert tables.control.shape == (3, 2, 6, 2, 10)
    assert rms(tables.error) < 0.04
    assert (
        tables.error[:2].max() < 0.0405
    )  # turbidity 2 and 3, each albedo and wavelength: .0401 is what nine numbers miss
    own = SkyFamily.of(physical, (3.0,), (0.0, 1.0), W)
    np.testing.assert_allclose(np.sqrt((away(tables, own) ** 2).mean(axis=2))[0], tables.error[1], rtol=1e-6)


def test_suns_and_turbidities_between_those_fitted(tables):
    between = SkyFamily.of(physical, (2.5, 3.5), (0.0, 1.0), W, np.radians([7.7, 14.0, 33.0, 62.0]))
    errors = away(tables, between)
    assert rms(errors) < 0.04
    assert errors.max() < 0.09
    assert errors[:, :, 1].max() < 0.05  # 14 degrees
    assert errors[:, :, 3].max() < 0.035  # 62 degrees


def test_albedos_are_mixed_as_light_is():
    """All albedos share the numbers in which light is not linear."""
    tables = bezier_family(SkyFamily.of(sd.HosekWilkie, (3.0,), (0.0, 1.0), (560.0,)))
    views, sun = sd.direction(np.arange(9.0), np.linspace(0.1, 1.5, 9)), sd.direction(np.pi, 0.7)
    dark, grey, bright = (sd.HosekWilkie(sun, 3.0, a, tables=tables).radiance(views, [560.0]) for a in (0, 0.4, 1))
    np.testing.assert_allclose(grey, 0.6 * dark + 0.4 * bright, rtol=1e-12)


def test_hosek_and_wilkies_own_skies_are_given_back():
    nodes, bands = (2.0, 3.0, 4.0), (400.0, 680.0)
    tables = bezier_family(SkyFamily.of(sd.HosekWilkie, nodes, (0.0, 1.0), bands))
    assert rms(tables.error) < 0.01
    between = SkyFamily.of(sd.HosekWilkie, (2.5, 3.5), (0.0, 1.0), bands, np.radians([7.5, 14, 33, 60, 83]))
    assert rms(away(tables, between)) < 0.02


def test_the_published_tables_as_tables_of_ones_own(tmp_path):
    published_tables().save(tmp_path / "published.npz")
    views = sd.direction(np.arange(50) * 2.4 % 6.283, np.arcsin(np.linspace(0.01, 1, 50)))
    sun, w = sd.direction(1.0, 0.6), [320.0, 500.0, 700.0]
    own, theirs = (sd.HosekWilkie(sun, 3.3, 0.35, tables=t) for t in (tmp_path / "published.npz", None))
    np.testing.assert_allclose(own.radiance(views, w), theirs.radiance(views, w), rtol=1e-12)
    bands = theirs.radiance(views, BANDS) @ xyz_weights(BANDS)
    np.testing.assert_allclose(own.xyz(views), bands, rtol=1e-12)
    np.testing.assert_allclose(own.luminance(views), bands[:, 1], rtol=1e-12)
    fast = own.rgb(np.broadcast_to(views, (400, 50, 3)).astype(np.float32))
    np.testing.assert_allclose(fast[0], own.rgb(views.astype(np.float32).astype(float)), rtol=1e-4, atol=1e-2)
    assert own.coefficients().shape == (11, 10)
    torch = pytest.importorskip("torch")
    light = sd.HosekWilkie(torch.as_tensor(sun), torch.tensor(3.3, dtype=torch.float64), 0.35, tables=own.tables)
    np.testing.assert_allclose(light.radiance(torch.as_tensor(views), w).numpy(), own.radiance(views, w), rtol=1e-12)


def test_ranges_are_those_of_the_tables(tables):
    sun = sd.direction(np.pi, np.radians([3.0, 10.0]))[:, None, :]
    sky = sd.HosekWilkie(sun, 3.0, 0.2, tables=tables)
    assert sky.valid.ravel().tolist() == [False, True]
    with pytest.raises(ValueError, match=r"turbidity must lie in \[2, 4\], got 5"):
        sd.HosekWilkie(sun, 5.0, tables=tables)
    with pytest.raises(ValueError, match=r"wavelengths must lie in \[450, 650\] nm, got 700"):
        sky.radiance(sd.ZENITH, [700.0])
    views = sd.direction(0.0, np.array([0.3, 1.2]))
    lower, least = (sd.direction(np.pi, np.radians(e)) for e in (3.0, 5.0))
    coefficients = [sd.HosekWilkie(s, 3.0, tables=tables).coefficients() for s in (lower, least)]
    np.testing.assert_array_equal(*coefficients)
    assert np.isfinite(sky.radiance(views, W)).all()


def test_the_jacobian_is_the_slope():
    family = SkyFamily.of(physical, (3.0,), (0.0, 1.0), (550.0,), np.radians([6, 10, 20, 35, 55, 80]))
    problem = AllSuns.of(family, family.radiance[0, ..., 0])
    x = np.repeat([-1.2, -0.4, -2.4, 0.76], 6) + np.random.default_rng(0).normal(0, 0.05, 24)
    differences, linear, bases = problem.solved(x)

    def cost(x):
        return 0.5 * (problem.solved(x)[0] ** 2).sum()

    slope = problem.jacobian(x, linear, bases).reshape(-1, 24).T @ differences.ravel()
    expected = [(cost(x + 1e-6 * e) - cost(x - 1e-6 * e)) / 2e-6 for e in np.eye(24)]
    np.testing.assert_allclose(slope, expected, rtol=1e-4, atol=1e-7 * np.abs(expected).max())


def write_numbers(path, **changed):
    whole = {"sky_tables": 1, "turbidities": [3.0], "albedos": [0.1], "wavelengths": [550.0], "lowest": 0.1}
    whole |= {"control": np.ones((1, 1, 6, 1, 10)), "error": [[[0.01]]]}
    np.savez(path, **{k: v for k, v in (whole | changed).items() if v is not None})
    return path


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"lowest": None}, "is not sky tables: it lacks lowest"),
        ({"sky_tables": 7}, "of another form than 1"),
        ({"wavelengths": [[550.0]]}, "wavelengths of sky tables must be a row of rising numbers"),
        ({"turbidities": [np.nan]}, "turbidities of sky tables must be a row of rising numbers"),
        ({"control": np.ones((1, 1, 6, 2, 10))}, r"control points of shape \(1, 1, 6, 1, 10\)"),
        ({"control": np.full((1, 1, 6, 1, 10), np.nan)}, "control points must be finite"),
        ({"lowest": [0.1]}, "the lowest sun must be one number"),
        ({"albedos": ["dark"]}, "albedos must be numbers"),
        ({"control": np.array([{}], dtype=object)}, "damaged or not sky tables"),
    ],
)
def test_files_that_are_no_tables_are_refused(tmp_path, changed, message):
    with pytest.raises(ValueError, match=message):
        SkyTables.load(write_numbers(tmp_path / "wrong.npz", **changed))


def test_cut_and_swollen_files_are_refused(tmp_path, monkeypatch):
    path = write_numbers(tmp_path / "tables.npz")
    (tmp_path / "cut.npz").write_bytes(path.read_bytes()[:-40])
    with pytest.raises(ValueError, match=r"cut\.npz, which is damaged or not sky tables"):
        SkyTables.load(tmp_path / "cut.npz")
    with zipfile.ZipFile(tmp_path / "swollen.npz", "w", zipfile.ZIP_DEFLATED) as archive:
        for name in ("sky_tables", "turbidities", "albedos", "wavelengths", "lowest", "control", "error"):
            archive.writestr(f"{name}.npy", bytes(2**20))
    monkeypatch.setattr("skydome.skies.formula.sky_tables.MOST_BYTES", 2**19)
    with pytest.raises(ValueError, match=r"sky tables may take 0\.5 MB"):
        SkyTables.load(tmp_path / "swollen.npz")
    with pytest.raises(FileNotFoundError):
        sd.HosekWilkie(sd.ZENITH, 3.0, tables=tmp_path / "missing.npz")


def command(*arguments):
    return CliRunner().invoke(app, [*map(str, arguments)])


def test_from_a_simulated_store_to_a_map(tmp_path):
    suns = (5.0, 8.0, 14.0, 25.0, 40.0, 60.0, 85.0)
    zenith, azimuth = tuple(range(4, 87, 12)), tuple(range(0, 181, 20))
    store = tmp_path / "store.zarr"
    simulate(Grid((2.0, 3.0), (0.0, 1.0), suns, (400.0, 500.0, 600.0, 700.0), zenith, azimuth), store)
    done = command("fit", store, "-o", tmp_path / "own.npz", "--json")
    assert done.exit_code == 0, done.output
    facts = json.loads(done.stdout)
    assert facts["turbidities"] == [2, 3]
    assert facts["relative_rms_error"] < 0.035
    lit = command(
        "light",
        "--sun",
        "180,40",
        "--model",
        "hosek-wilkie",
        "--turbidity",
        "2.5",
        "--tables",
        tmp_path / "own.npz",
        "--json",
    )
    air = sd.Atmosphere.standard(1.5 * float(rayleigh_depth([550.0])[0]), albedo=0.2, aerosol_albedo=1.0)
    expected = sd.illuminance(sd.DiscreteOrdinates(sd.direction(np.pi, np.radians(40.0)), air))
    assert json.loads(lit.stdout)["illuminance_lx"]["diffuse"] == pytest.approx(expected, rel=0.04)
    wrong = command("light", "--sun", "180,40", "--model", "preetham", "--tables", tmp_path / "own.npz")
    assert wrong.exit_code == 2
    assert "preetham takes no --tables" in wrong.stderr
    (store / "radiance/c/1/0/0/0/0/0").unlink()
    unfinished = command("fit", store, "-o", tmp_path / "again.npz")
    assert unfinished.exit_code == 2
    assert "lacks 1 pieces" in unfinished.stderr


def test_bad_input_to_fitting(tmp_path):
    with pytest.raises(ValueError, match="six suns or more"):
        bezier_family(SkyFamily.of(sd.HosekWilkie, (3.0,), (0.0,), (560.0,), np.radians([10.0, 20.0])))
    with pytest.raises(FileNotFoundError, match="must be a folder"):
        SkyFamily.from_store(tmp_path / "none.zarr")
    with pytest.raises(ValueError, match="no store of simulated skies"):
        SkyFamily.from_store(tmp_path)
    assert "file of hosek-wilkie must end in .npz" in command("fit", tmp_path, "-o", tmp_path / "a.txt").stderr

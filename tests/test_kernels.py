"""Every compiled form beside the readable form that it stands for: a call that works on one must work on the other.

`KERNEL_PAIRS` has a row for each file of kernels: the readable formula, the compiled one, the shader where there is
one, and the test that compares them. A file without a row fails, and so does a row whose names are gone.
"""

from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

TESTS = Path(__file__).parent
SOURCE = TESTS.parent / "src" / "skydome"


class Pair(NamedTuple):
    """A kernel and its readable form as module:name, the shader's writer, and file::function of the comparison."""

    formula: str
    kernel: str
    compared: str
    shader: str | None = None


KERNEL_PAIRS = (
    Pair(
        "skies.clouds.fields.noise:gradient_by_numpy",
        "skies.clouds.fields.noise_kernel:gradient_noise",
        "skies/clouds/fields/test_cloud_fields.py::test_noise_is_the_same_compiled_and_repeats",
    ),
    Pair(
        "skies.clouds.fields.field:CloudField",
        "skies.clouds.fields.medium_kernel:extinctions",
        "skies/clouds/fields/test_cloud_fields.py::test_extinction_is_the_same_compiled",
    ),
    Pair(
        "skies.clouds.fields.transport.ordinates:Ordinates",
        "skies.clouds.fields.transport.ordinates_kernel:swept",
        "skies/clouds/fields/test_cloud_fields.py::test_ordinates_through_a_slab",
    ),
    Pair(
        "skies.clouds.fields.transport.diffusion:Diffusion",
        "skies.clouds.fields.transport.diffusion_kernel:relaxed",
        "skies/clouds/fields/test_cloud_fields.py::test_ordinates_through_a_slab",
    ),
    Pair(
        "skies.clouds.fields.lit_field:LitField",
        "skies.clouds.fields.march_kernel:marched",
        "skies/clouds/fields/test_cloud_fields.py::test_thin_slab_scatters_once",
    ),
    Pair(
        "skies.clouds.fields.incident:Incident",
        "skies.clouds.fields.air.before_kernel:put_together",
        "skies/clouds/fields/test_cloud_fields.py::test_air_before_the_cloud_is_the_same_compiled",
    ),
    Pair(
        "skies.clouds.fields.field:CloudField",
        "skies.clouds.fields.air.sunlight_kernel:reaches",
        "skies/clouds/fields/test_low_suns.py::test_rays_to_the_sun_are_let_through_as_by_the_field",
    ),
    Pair(
        "skies.clouds.fields.reference:CloudTracing",
        "skies.clouds.fields.tracing_kernel:traced",
        "skies/clouds/fields/test_cloud_fields.py::test_paths_through_a_slab_meet_discrete_ordinates",
    ),
    Pair("numpy:exp", "ground.elementary_kernel:exponential", "test_kernels.py::test_elementary_functions"),
    Pair(
        "skies.formula.perez_formula:evaluate",
        "skies.formula.kernel:many_skies",
        "skies/formula/test_kernel_parity.py::test_directions",
        "export.formula_shader:channel_function",
    ),
    Pair(
        "skies.formula.perez_formula:evaluate",
        "skies.formula.kernel:whole_map",
        "skies/formula/test_kernel_parity.py::test_maps",
    ),
    Pair(
        "skies.formula.perez_formula:indicatrix",
        "skies.formula.nine_numbers_kernel:indicatrix_row",
        "test_kernels.py::test_gradation_and_indicatrix",
        "export.formula_shader:channel_function",
    ),
    Pair(
        "skies.formula.quantity:Quantity",
        "skies.formula.quantity_kernel:finished",
        "skies/formula/test_kernel_parity.py::test_xyz_luminance_and_spectra",
    ),
    Pair(
        "skies.physical.held_fields:HeldFields",
        "skies.physical.held_kernel:shine",
        "skies/physical/test_held_fields.py::test_compiled",
    ),
    Pair(
        "skies.physical.held_rows:HeldRows",
        "skies.physical.held_rows_kernel:whole_map",
        "dome/test_held_rows.py::test_compiled_rows",
    ),
    Pair(
        "skies.neural.network:Network",
        "skies.neural.kernel:shine",
        "skies/neural/test_network_kernel.py::test_directions",
        "export.network_shader:network_code",
    ),
    Pair(
        "skies.neural.fast:light_by_numpy",
        "skies.neural.kernel:whole_map",
        "skies/neural/test_network_kernel.py::test_maps",
    ),
    Pair(
        "skies.neural.fast:through",
        "skies.neural.layers_kernel:layers",
        "skies/neural/test_network_kernel.py::test_directions",
    ),
    Pair(
        "years.skies.dome_means:by_numpy",
        "years.skies.dome_means_kernel:means_of_many_skies",
        "test_kernels.py::test_dome_means",
    ),
    Pair(
        "haze.integrals:FewNodes",
        "haze.kernel:veil",
        "haze/test_aerial_perspective.py::test_table_and_kernel_agree_with_the_plain_form",
    ),
    Pair(
        "land.picture:pyramid_of",
        "land.rays_kernel:march",
        "land/test_terrain.py::test_march_finds_the_first_ground_like_brute_force",
    ),
    Pair(
        "dome.integrals:illuminance",
        "land.picture_kernel:picture_rows",
        "land/test_terrain.py::test_flat_ground_is_lit_as_the_sky_says",
    ),
    Pair(
        "training.levenberg_marquardt:normal_equations",
        "training.backpropagation_kernel:epoch",
        "test_kernels.py::test_an_epoch_goes_down_the_gradient",
    ),
    Pair(
        "skies.physical.nishita:scattered_once",
        "skies.path_tracing.loop_kernel:trace_views",
        "skies/path_tracing/test_path_traced.py::test_one_bounce_is_single_scattering",
    ),
    Pair(
        "air.rays:columns_out",
        "skies.path_tracing.air_kernel:column_out",
        "test_kernels.py::test_columns_of_exponential_air",
    ),
    Pair(
        "air.rays:rays",
        "skies.path_tracing.flight_kernel:sunlight_at",
        "skies/path_tracing/test_path_traced.py::test_one_bounce_is_single_scattering",
    ),
    Pair(
        "skies.physical.nishita:scattered_once",
        "skies.path_tracing.event_kernel:next_event_in_air",
        "skies/path_tracing/test_path_traced.py::test_first_order_by_quadrature_or_by_paths_is_the_same",
    ),
    Pair(
        "numpy:histogram",
        "skies.path_tracing.guide_kernel:sample_cell",
        "skies/path_tracing/test_path_guide.py::test_distances_sampled_have_the_pdf_stated",
    ),
    Pair(
        "skies.path_tracing.guide:guide_for",
        "skies.path_tracing.guide_tables_kernel:fill_tables",
        "skies/path_tracing/test_path_guide.py::test_guided_or_not_the_mean_is_the_same",
    ),
    Pair(
        "skies.path_tracing.sky:PathTraced",
        "skies.path_tracing.many_suns_kernel:hits",
        "skies/path_tracing/test_many_suns.py::test_many_suns_agree_with_next_event_estimation",
    ),
    Pair(
        "skies.all_air.from_heights.views:Places",
        "skies.all_air.from_heights.views_kernel:given_off",
        "skies/all_air/test_from_heights.py::test_what_air_gives_off_is_the_same_compiled",
    ),
    Pair(
        "skies.physical.precomputed.grid:views",
        "skies.physical.precomputed.lookup_kernel:add_scattering",
        "skies/physical/precomputed/test_precomputed.py::test_a_table_gives_its_own_values_at_its_nodes",
    ),
    Pair(
        "skies.physical.nishita:scattered_once",
        "skies.physical.precomputed.orders_kernel:scatter_once",
        "skies/physical/precomputed/test_precomputed.py::test_light_scattered_once_is_that_by_quadrature",
    ),
    Pair(
        "skies.all_air.column_tables:ColumnTables",
        "skies.path_tracing.bent_kernel:bent_sunlight",
        "skies/path_tracing/test_bent_paths.py::test_sunlight_through_bent_air_is_that_of_the_tables",
    ),
    Pair(
        "skies.all_air.single_scattering:lit_rays",
        "skies.all_air.single_kernel:strengths",
        "skies/all_air/test_many_suns.py::test_compiled_rays",
    ),
    Pair(
        "skies.all_air.single_scattering:lit_rays",
        "own_air.all_air.solver_kernel:add_once",
        "own_air/all_air/test_teacher.py::test_light_scattered_once_is_that_of_the_sky",
    ),
)


def found(name):
    """What module:name of skydome, or of numpy, stands for."""
    module, attribute = name.split(":")
    return getattr(import_module(module if module == "numpy" else f"skydome.{module}"), attribute)


@pytest.mark.parametrize("pair", KERNEL_PAIRS, ids=lambda pair: pair.kernel)
def test_pairs_are_there_and_compared(pair):
    file, function = pair.compared.split("::")
    assert f"def {function}(" in (TESTS / file).read_text()
    for name in (pair.formula, pair.shader):
        assert name is None or callable(found(name))
    if find_spec("numba"):
        assert callable(found(pair.kernel))


def test_every_file_of_kernels_has_its_pair():
    files = {".".join(path.relative_to(SOURCE).with_suffix("").parts) for path in SOURCE.rglob("*kernel.py")}
    assert files == {pair.kernel.split(":")[0] for pair in KERNEL_PAIRS}


def test_kernels_are_typed_and_compiled_in_one_way():
    for path in SOURCE.rglob("*.py"):
        text = path.read_text()
        if path.name.endswith("kernel.py"):
            assert text.startswith("# mypy: allow-untyped-defs\n"), path.name
        assert "njit" not in text or path.name == "compiled.py", f"{path.name} has a compiler of its own"
        assert "parallel=True" not in text, f"{path.name} starts threads of Numba's, which end the process"


def test_elementary_functions():
    pytest.importorskip("numba")
    from skydome.ground.elementary_kernel import exponential, exponential_double, logarithm, stirred, uniform

    x = np.linspace(-80, 80, 801).astype(np.float32)
    np.testing.assert_allclose([exponential(v) for v in x], np.exp(x.astype(float)), rtol=3e-7)
    np.testing.assert_allclose([exponential_double(v) for v in x.astype(float)], np.exp(x.astype(float)), rtol=3e-10)
    y = np.geomspace(1e-30, 1e30, 601).astype(np.float32)
    np.testing.assert_allclose([logarithm(v) for v in y], np.log(y.astype(float)), rtol=2e-7, atol=1e-7)
    numbers = np.array([uniform(np.uint64(stirred(np.uint64(k))), p) for k in range(400) for p in range(25)])
    assert 0 < numbers.min() < numbers.max() < 1
    assert numbers.mean() == pytest.approx(0.5, abs=0.012)
    counts = np.histogram(numbers, 20, (0, 1))[0]
    assert ((counts - 500) ** 2 / 500).sum() < 44  # chi^2 of 19 degrees of freedom, 1 in 1000


@pytest.mark.parametrize("peak", [0.0, 0.7])
def test_gradation_and_indicatrix(peak):
    numba = pytest.importorskip("numba")
    from skydome.skies.formula import perez_formula
    from skydome.skies.formula.nine_numbers_kernel import gradation, indicatrix_row

    a, b, c, d, e, f, h = -0.9, -0.4, 1.2, 5.0, -2.5, 0.3, 0.6
    real, log2_e = np.float32, np.log2(np.e)
    coefficients = np.array([1.0, a, b, c, d, e, f, peak, h, 0.0])
    angle, cosine = np.linspace(0, np.pi, 200), np.linspace(0.02, 1, 200)
    row = numba.njit(lambda u, g, values, k: indicatrix_row(
        u.size, u, g, k[0], k[1], k[2], k[3], k[4], k[5], k[6], k[7], k[8], values))  # fmt: skip
    values = np.empty(200, real)
    numbers = np.array([c, d, e * log2_e, f, peak, (1 - h) ** 2, 2 * h, 0.0, -3e38], real)
    row((2 * np.sin(angle / 2) ** 2).astype(real), angle.astype(real), values, numbers)
    np.testing.assert_allclose(values, perez_formula.indicatrix(coefficients, cosine, angle), rtol=2e-6)
    graded = numba.njit(lambda over: gradation(over, real(1), real(a), real(b * log2_e), real(0)))
    got = [graded(real(1 / value)) for value in cosine]
    np.testing.assert_allclose(got, perez_formula.gradation(coefficients, cosine), rtol=2e-6)


def test_dome_means():
    pytest.importorskip("numba")
    import skydome as sd
    from skydome.dome.patches import reinhart
    from skydome.years.skies.dome_means import PerezSkies, by_numpy, dome_means, samples_of

    random, hours = np.random.default_rng(3), 40
    ends = [(-1, 0), (-0.6, -0.01), (0, 12), (-5, -1), (0, 0.5)]
    letters = np.stack([random.uniform(*span, hours) for span in ends])
    suns = sd.direction(random.uniform(0, 6, hours), random.uniform(0.05, 1.5, hours))
    skies, patches, targets = PerezSkies(letters, suns, 0.01), reinhart(2), np.full(hours, 1e4)
    for centres in (False, True):
        got = dome_means(skies, targets, patches, centres)
        plain, weights = np.zeros(got.shape), patches.horizontal_solid_angles
        by_numpy(skies, targets, samples_of(patches, centres), weights, np.arange(hours), plain)
        np.testing.assert_allclose(got, plain, rtol=2e-5, atol=1e-6 * plain.max())


def test_an_epoch_goes_down_the_gradient():
    """One sample, no momentum: every number changes by the rate times half the slope of the squared error."""
    pytest.importorskip("numba")
    from skydome.training.backpropagation_kernel import epoch

    random = np.random.default_rng(0)
    numbers = [random.normal(size=shape) for shape in ((4, 3), (4,), (2, 4), (2,))]
    x, wanted, rate = random.normal(size=3), random.random(2), 1e-3

    def error(w1, b1, w2, b2):
        signal = 1 / (1 + (w1 @ x + b1) ** 2)
        return float(((1 / (1 + (w2 @ signal + b2) ** 2) - wanted) ** 2).sum())

    trained = [part.copy() for part in numbers]
    moments = [np.zeros_like(part) for part in numbers]
    total = epoch(x[None], wanted[None], np.array([0]), *trained, *moments, rate, 0.0)
    assert total == pytest.approx(error(*numbers))
    for part, after in zip(numbers, trained, strict=True):
        for index in np.ndindex(part.shape):
            ends, own = [], part[index]
            for step in (-1e-6, 1e-6):
                part[index] = own + step
                ends.append(error(*numbers))
            part[index] = own
            slope = (ends[1] - ends[0]) / 2e-6
            assert after[index] - own == pytest.approx(-rate * slope / 2, rel=0.02, abs=1e-7)


def test_columns_of_exponential_air():
    pytest.importorskip("numba")
    import skydome as sd
    from skydome.air.rays import columns_out
    from skydome.skies.path_tracing.air_kernel import column_out, fade_at
    from skydome.skies.path_tracing.tables import shells

    atmosphere = sd.Atmosphere.standard()
    air = shells(atmosphere, np.array([550.0]))
    for height, cosine in ((0.0, 0.0), (0.0, 0.3), (1000.0, 1.0), (20_000.0, 0.05)):
        radius = air.radius + height
        plain = columns_out(atmosphere, np.array([radius]), np.array([cosine]))[:, 0]
        got = [column_out(k, radius, cosine, fade_at(k, height, air), air) for k in range(air.rates.size)]
        np.testing.assert_allclose(got, plain, rtol=4e-3, atol=1e-6)

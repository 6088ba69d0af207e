"""Skies inside torch.compile: one whole graph, the same light and gradients."""

import shutil

import numpy as np
import pytest

import skydome as sd
from skydome.ground.quadrature import hemisphere
from skydome.skies.neural.files import shipped_network
from skydome.skies.neural.sky import NeuralSpectralSky

torch = pytest.importorskip("torch")

pytestmark = [pytest.mark.slow, pytest.mark.filterwarnings("ignore")]  # torch's compiler warns about itself
SUN = torch.tensor(sd.direction(2.4, 0.7))
VIEWS = torch.tensor(hemisphere(4, 6)[0])
DEEP, SPECTRAL = (shipped_network(f"hosek-wilkie-{kind}")[0] for kind in ("deep", "spectral"))
CAPTURED = sd.CapturedSky(sd.render(sd.HosekWilkie(sd.direction(2.4, 0.7), 3.0), height=32))
MODELS = {
    "hosek-wilkie-rgb": lambda sun, one: sd.HosekWilkieRGB(sun, one * 3.2, one * 0.3),
    "perez-all-weather": lambda sun, one: sd.PerezAllWeather(sun, one * 700.0, one * 100.0),
    "sum": lambda sun, one: sd.Daylight(sd.CIE(sun, 12, zenith_luminance=one * 4e3)) + sd.SunDisc(sun, one * 3.2),
    "neural": lambda sun, one: sd.NeuralSky(sun, DEEP, one * 3.2),
    "neural-spectral": lambda sun, one: NeuralSpectralSky(sun, SPECTRAL, one * 3.2, one * 0.3),
    "captured": lambda sun, one: CAPTURED,
}


@pytest.mark.parametrize("made", MODELS.values(), ids=MODELS.keys())
def test_one_graph_without_breaks(made):
    torch._dynamo.reset()
    one = torch.tensor(1.0, dtype=torch.float64)

    def light(sun, one, views):
        return made(sun, one).luminance(views)

    compiled = torch.compile(light, backend="aot_eager", fullgraph=True)
    np.testing.assert_allclose(compiled(SUN, one, VIEWS), light(SUN, one, VIEWS), rtol=1e-12)
    np.testing.assert_allclose(compiled(SUN, one * 0.9, VIEWS), light(SUN, one * 0.9, VIEWS), rtol=1e-12)


@pytest.mark.skipif(not (shutil.which("g++") or shutil.which("c++")), reason="torch.compile needs a C++ compiler")
def test_generated_code_and_its_gradient():
    torch._dynamo.reset()

    def light(turbidity):
        return sd.Preetham(SUN, turbidity).luminance(VIEWS).sum()

    slopes = []
    for function in (light, torch.compile(light, fullgraph=True)):
        turbidity = torch.tensor(3.3, dtype=torch.float64, requires_grad=True)
        function(turbidity).backward()
        slopes.append(turbidity.grad.item())
    assert slopes[1] == pytest.approx(slopes[0], rel=1e-10)

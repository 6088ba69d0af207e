"""The last steps of training: all cases at once, by the curvature of the error (L-BFGS), shapes held.

With the shapes held, the squared error of the light's logarithm is a quadratic form of the coefficients, one for each
case: a step over all cases costs as much as the network alone.
"""

from dataclasses import replace
from typing import Any

import numpy as np

from skydome.own_air.all_air.lessons import Cases
from skydome.own_air.all_air.training import mean_coefficients, require_torch, unscaled, whole
from skydome.skies.all_air.rest import RestNetwork

TAMED, SMALL = 0.06**2, 3e-8
"""The squared error beyond which a case counts less, and what keeps weights small."""


def polished(network: RestNetwork, lessons: Cases, steps: int) -> RestNetwork:
    """The network after so many steps on the lessons."""
    torch = require_torch()
    read = lessons.inputs()[:, 0]
    middle, size = read.mean(axis=0), read.std(axis=0) + 1e-9
    net = scaled(torch, network, middle, size)
    given, wanted, form = (torch.tensor(part) for part in ((read - middle) / size, *quadratic(network, lessons)))
    optimiser = torch.optim.LBFGS(
        net.parameters(), max_iter=steps, history_size=40, line_search_fn="strong_wolfe", tolerance_change=1e-14
    )

    def error() -> Any:
        optimiser.zero_grad()
        off = net(given) - wanted
        square = torch.einsum("cs,cst,ct->c", off, form, off)
        tame = (torch.sqrt(square + TAMED) - TAMED**0.5).mean()
        loss = tame + SMALL * sum((part**2).sum() for part in net.parameters() if part.ndim == 2)
        loss.backward()
        return loss

    optimiser.step(error)
    return replace(network, layers=unscaled(net, middle, size))


def scaled(torch: Any, network: RestNetwork, middle: np.ndarray, size: np.ndarray) -> Any:
    """The network in torch, float64, reading inputs less their mean over their spread."""
    parts: list[Any] = []
    for number, (weights, biases) in enumerate(network.layers):
        first = number == 0
        own = (weights * size[:, None], biases + middle @ weights) if first else (weights, biases)
        layer = torch.nn.Linear(*weights.shape, dtype=torch.float64)
        layer.weight.data, layer.bias.data = torch.tensor(own[0].T.copy()), torch.tensor(own[1])
        parts += [layer] if number == len(network.layers) - 1 else [layer, torch.nn.SiLU()]
    return torch.nn.Sequential(*parts)


def quadratic(network: RestNetwork, lessons: Cases) -> tuple[np.ndarray, np.ndarray]:
    """The best coefficients of each case (N, S), and the form (N, S, S) that makes mean squared errors of others."""
    shapes = whole(network.shapes)
    count = len(network.layers[-1][1])
    mean, own = shapes[:-count], shapes[-count:]
    share = (lessons.rest / (lessons.rest + lessons.once)).astype(np.float64) ** 2
    left = np.log(lessons.rest.astype(np.float64)) - mean_coefficients(lessons.sines, network.places, len(mean)) @ mean
    form = np.einsum("sn,cn,tn->cst", own, share, own, optimize=True)
    right = np.einsum("sn,cn->cs", own, share * left)
    best = np.linalg.solve(form + 1e-9 * np.eye(count), right[..., None])[..., 0]
    return best, form / shapes.shape[1]

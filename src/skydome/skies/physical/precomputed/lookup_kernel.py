# mypy: allow-untyped-defs
"""Places in the tables of `grid` and what stands there, compiled; W wavelengths run in the innermost loops.

`air` is a `medium.Medium`; r are radii, m, mu and mu_s cosines of the zenith angles of view and sun, nu that of the
angle between.
"""

import math

from skydome.ground.compiled import ANY_ORDER, inlined
from skydome.ground.elementary_kernel import exponential_double

jit = inlined(ANY_ORDER)


@jit
def to_top(r, mu, air):
    """Length of a ray to the top of the air, m."""
    return max(-r * mu + math.sqrt(max(r * r * (mu * mu - 1.0) + air.top * air.top, 0.0)), 0.0)


@jit
def to_ground(r, mu, air):
    """Length of a ray to the ground, m."""
    return max(-r * mu - math.sqrt(max(r * r * (mu * mu - 1.0) + air.bottom * air.bottom, 0.0)), 0.0)


@jit
def horizon(r, air):
    """Distance to the horizon, m."""
    return math.sqrt(max(r * r - air.bottom * air.bottom, 0.0))


@jit
def cell(x, count):
    """Index below a place x in [0, 1] among `count` texels, and how far on."""
    place = min(max(x, 0.0), 1.0) * (count - 1)
    i = min(int(place), count - 2)
    return i, place - i


@jit
def view_place(r, mu, grounded, air, count):
    """Index and share of a view among `count`, which stay within its half."""
    half, rho = count // 2, horizon(r, air)
    if grounded:
        least = r - air.bottom
        x = (to_ground(r, mu, air) - least) / (rho - least) if rho > least else 0.0
        i, share = cell(1.0 - x, half)
        return i, share
    least = air.top - r
    i, share = cell((to_top(r, mu, air) - least) / (rho + air.H - least), half)
    return half + i, share


@jit
def sun_place(mu_s, air, count):
    """Index and share of a sun among `count`."""
    least = air.top - air.bottom
    a = (to_top(air.bottom, mu_s, air) - least) / (air.H - least)
    return cell(max(1.0 - a / air.lowest, 0.0) / (1.0 + a), count)


@jit
def add_scattering(table, r, mu, mu_s, nu, grounded, factor, air, out):
    """Add `factor` times the table (heights, views, suns, angles, W) at a place to `out` (W,)."""
    i, a = cell(horizon(r, air) / air.H, table.shape[0])
    j, b = view_place(r, mu, grounded, air, table.shape[1])
    k, c = sun_place(mu_s, air, table.shape[2])
    n, d = cell(0.5 * (nu + 1.0), table.shape[3])
    for p in range(2):
        for q in range(2):
            height_view = factor * (a if p else 1 - a) * (b if q else 1 - b)
            for s in range(2):
                weight = height_view * (c if s else 1 - c)
                low, high = table[i + p, j + q, k + s, n], table[i + p, j + q, k + s, n + 1]
                for w in range(out.size):
                    out[w] += weight * ((1 - d) * low[w] + d * high[w])


@jit
def depth_out(r, mu, air, out):
    """Optical depth (W,) from a radius out to space along a view that misses the ground, into `out`."""
    least, table = air.top - r, air.depth
    i, a = cell(horizon(r, air) / air.H, table.shape[0])
    j, b = cell((to_top(r, mu, air) - least) / (horizon(r, air) + air.H - least), table.shape[1])
    for w in range(out.size):
        near = (1 - b) * table[i, j, w] + b * table[i, j + 1, w]
        far = (1 - b) * table[i + 1, j, w] + b * table[i + 1, j + 1, w]
        out[w] = (1 - a) * near + a * far


@jit
def depth_between(r, mu, d, grounded, air, out, spare):
    """Optical depth (W,) of a ray's first d metres into `out`."""
    there = min(max(math.sqrt(d * d + 2 * r * mu * d + r * r), air.bottom), air.top)
    cosine = min(max((r * mu + d) / there, -1.0), 1.0)
    if grounded:
        depth_out(there, -cosine, air, out)
        depth_out(r, -mu, air, spare)
    else:
        depth_out(r, mu, air, out)
        depth_out(there, cosine, air, spare)
    for w in range(out.size):
        out[w] = max(out[w] - spare[w], 0.0)


@jit
def sun_seen(r, mu_s, air):
    """Share of the sun's disc above the horizon seen from a radius."""
    sine = air.bottom / r
    edge = sine * air.sun_radius
    t = min(max((mu_s + math.sqrt(max(1.0 - sine * sine, 0.0)) + edge) / (2.0 * edge), 0.0), 1.0)
    return t * t * (3.0 - 2.0 * t)


@jit
def sunlight(r, mu_s, air, out):
    """Sunlight (W,) at a radius, as a part of that above the air, into `out`; False where there is none."""
    share = sun_seen(r, mu_s, air)
    if share <= 0.0:
        return False
    sine = air.bottom / r
    depth_out(r, max(mu_s, -math.sqrt(max(1.0 - sine * sine, 0.0))), air, out)
    for w in range(out.size):
        out[w] = share * exponential_double(-out[w])
    return True


@jit
def phase_of(law, cosine, air, out):
    """A law's phase function (W,), sr-1, into `out`."""
    i, a = cell(0.5 * (cosine + 1.0), air.phases.shape[1])
    for w in range(out.size):
        out[w] = (1 - a) * air.phases[law, i, w] + a * air.phases[law, i + 1, w]

# mypy: allow-untyped-defs
"""Rays through a field of cloud, compiled: what is seen through it, and what it sends of sun, sky and ground.

`light` (north, east, up, 4), float32: scaled optical depth toward the sun, and the fluence of sun, sky and ground for
an irradiance of 1 each. `clear` (north, east): cells to the nearest column with cloud. `numbers`: share of the
extinction that stays after the forward peak is taken out, how far light is sought, the step, m, the mean cosine of the
scattering angle, and the transport extinction of empty air.
"""

import math

from skydome.ground.compiled import inlined, job
from skydome.ground.units import EARTH_RADIUS
from skydome.skies.clouds.fields.medium_kernel import extinction

compiled, part = job(), inlined()
GONE = 5e-3
"""Transmittance at which a ray ends."""
FOUR_PI = 4 * math.pi


@part
def lit(light, x, y, z, channel):
    """One channel of the light, linear between the middles of cells."""
    rows, columns, levels, _ = light.shape
    z = min(max(z, 0.0), levels - 1.000001)
    fx, fy, fz = math.floor(x), math.floor(y), math.floor(z)
    u, v, w = x - fx, y - fy, z - fz
    i, j, k = int(fx) % columns, int(fy) % rows, int(fz)
    i1, j1, k1 = (i + 1) % columns, (j + 1) % rows, k + 1
    low = (light[j, i, k, channel] * (1 - u) + light[j, i1, k, channel] * u) * (1 - v) + (
        light[j1, i, k, channel] * (1 - u) + light[j1, i1, k, channel] * u
    ) * v
    high = (light[j, i, k1, channel] * (1 - u) + light[j, i1, k1, channel] * u) * (1 - v) + (
        light[j1, i, k1, channel] * (1 - u) + light[j1, i1, k1, channel] * u
    ) * v
    return low + (high - low) * w


@part
def fluences(light, x, y, z):
    """The fluences of sun, sky and ground, linear between the middles of cells."""
    rows, columns, levels, _ = light.shape
    z = min(max(z, 0.0), levels - 1.000001)
    fx, fy, fz = math.floor(x), math.floor(y), math.floor(z)
    u, v, w = x - fx, y - fy, z - fz
    i, j, k = int(fx) % columns, int(fy) % rows, int(fz)
    i1, j1, k1 = (i + 1) % columns, (j + 1) % rows, k + 1
    sun, sky, ground = 0.0, 0.0, 0.0
    for n in range(8):
        a, b, c = i1 if n & 1 else i, j1 if n & 2 else j, k1 if n & 4 else k
        weight = (u if n & 1 else 1 - u) * (v if n & 2 else 1 - v) * (w if n & 4 else 1 - w)
        sun += weight * light[b, a, c, 1]
        sky += weight * light[b, a, c, 2]
        ground += weight * light[b, a, c, 3]
    return sun, sky, ground


@part
def onward(fluence, flux):
    """Diffuse light that is scattered toward the eye, from fluence and 3 g flux toward it, held to what is possible."""
    return (fluence + min(max(flux, -fluence), fluence)) / FOUR_PI


@part
def depth_to_sun(m, light, sun, x, y, z, dx, dz, near):
    """Scaled optical depth from a place to the sun: a few steps through the field itself, then the coarse grid."""
    total, t = 0.0, 0.0
    for n in range(3):
        ds = near * (0.5 + n)
        s = t + 0.5 * ds
        total += extinction(m, x + s * sun[0], y + s * sun[1], z + s * sun[2]) * ds
        t += ds
    z += t * sun[2]
    if z > m.thickness:
        return total, 0.0
    x, y = x + t * sun[0], y + t * sun[1]
    return total, lit(light, x / dx - 0.5, y / dx - 0.5, z / dz - 0.5, 0)


@part
def height_over(s, up):
    """Height of a ray over the round ground at distance s, m."""
    return s * up + s * s * (1.0 - up * up) / (2.0 * EARTH_RADIUS)


@part
def distance_to(height, up):
    """Distance at which a ray comes to a height over the round ground, m."""
    curve = (1.0 - up * up) / (2.0 * EARTH_RADIUS)
    return 2.0 * height / (up + math.sqrt(up * up + 4.0 * curve * height))


@compiled
def marched(first, last, m, directions, light, clear, period, sun, phase, numbers, out):
    """Fill out (D, 5): transmittance, radiance of sun, sky and ground for an irradiance of 1, distance of the cloud.

    `phase` (2, angles): the phase function at even angles from 0 to pi, as it is and blurred by many small turns.
    """
    kept, farthest, fine, asymmetry, open_air = numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]
    blur = numbers[5]
    left = asymmetry / (1.0 + asymmetry)
    dx, dz = period / light.shape[1], m.thickness / light.shape[2]
    for n in range(first, last):
        a, b, up = directions[n, 0], directions[n, 1], max(directions[n, 2], 1e-4)
        cosine = min(max(a * sun[0] + b * sun[1] + up * sun[2], -1.0), 1.0)
        place = math.acos(cosine) / math.pi * (phase.shape[1] - 1)
        at = min(int(place), phase.shape[1] - 2)
        once = (phase[0, at] + (phase[0, at + 1] - phase[0, at]) * (place - at)) / kept
        often = phase[1, at] + (phase[1, at + 1] - phase[1, at]) * (place - at)
        level = math.sqrt(max(a * a + b * b, 1e-12))
        s, end = distance_to(m.base, up), min(distance_to(m.base + m.thickness, up), farthest)
        through, from_sun, from_sky, from_ground, weight, far = 1.0, 0.0, 0.0, 0.0, 0.0, 0.0
        was_cloud, step = False, fine
        while s < end and through > GONE:
            step = max(fine * (1.0 + 1.5 * (1.0 - through)), 0.002 * s)
            middle = s + 0.5 * step
            x, y, z = middle * a + m.east, middle * b + m.north, height_over(middle, up) - m.base
            sigma = extinction(m, x, y, z) * kept
            if sigma <= 0.0:
                column = clear[math.floor(y / dx) % clear.shape[0], math.floor(x / dx) % clear.shape[1]]
                s += max(step if was_cloud else 1.5 * step, (column - 1.0) * dx / level)
                was_cloud = False
                continue
            if not was_cloud and step > fine:
                step = max(0.5 * step, fine)
            was_cloud = True
            near, beyond = depth_to_sun(m, light, sun, x, y, z, dx, dz, 2.0 * fine)
            u, v, w = x / dx - 0.5, y / dx - 0.5, z / dz - 0.5
            lost = 1.0 - math.exp(-sigma * step)
            share = through * lost
            beam = math.exp(-near * kept - beyond)
            sharp = (beam * through) ** blur
            scattered = often + (once - often) * sharp
            s1, k1, g1 = fluences(light, u + 0.5 * a, v + 0.5 * b, w + 0.5 * up * dx / dz)
            s0, k0, g0 = fluences(light, u - 0.5 * a, v - 0.5 * b, w - 0.5 * up * dx / dz)
            way = left / (max(sigma / kept * (1.0 - asymmetry), open_air) * dx)
            ahead = 3.0 * left * left / (1.0 - left) * beam * cosine
            from_sun += share * (scattered * beam + onward(0.5 * (s0 + s1), way * (s1 - s0) + ahead))
            from_sky += share * onward(0.5 * (k0 + k1), way * (k1 - k0))
            from_ground += share * onward(0.5 * (g0 + g1), way * (g1 - g0))
            far += share * middle
            weight += share
            through *= 1.0 - lost
            s += step
        out[n, 0], out[n, 1], out[n, 2], out[n, 3] = through, from_sun, from_sky, from_ground
        out[n, 4] = far / weight if weight > 0.0 else s

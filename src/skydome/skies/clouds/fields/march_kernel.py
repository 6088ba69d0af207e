# mypy: allow-untyped-defs
"""Rays through a field of cloud, compiled: what is seen through it, and what it sends of sun, sky and ground.

`light` (north, east, up, 4), float32: scaled optical depth toward the sun, and the fluence of sun, sky and ground for
an irradiance of 1 each. `gaps` (north, east, up): m around that are free of cloud. `numbers`: share of the extinction
that stays after the forward peak is taken out, how far light is sought, the step, m, the mean cosine of the scattering
angle, and the transport extinction of empty air.
"""

import math

from skydome.ground.compiled import inlined, job
from skydome.ground.units import EARTH_RADIUS
from skydome.skies.clouds.fields.medium_kernel import between, extinction, free
from skydome.skies.clouds.fields.scattering import FIRST, STEP

compiled, part = job(), inlined()
GONE = 0.02
"""Transmittance at which a ray ends, and what is left of it sees what it saw last."""
DENSE = 1.0
"""Scaled optical depth of a step at most; ordinary cloud has half of it."""
FOUR_PI = 4 * math.pi


@part
def fluences(light, x, y, z, lowest):
    """The fluences of sun, sky and ground, linear between the middles of cells and down to the base (Marshak's
    boundary), half a cell that is `lowest` transport free paths thick.
    """
    rows, columns, levels, _ = light.shape
    left = 1.0 - 2.0 * min(max(-z, 0.0), 0.5) * 1.5 * lowest / (1.0 + 1.5 * lowest)
    z = min(max(z, 0.0), levels - 1.000001)
    fx, fy, fz = math.floor(x), math.floor(y), math.floor(z)
    u, v, w = x - fx, y - fy, z - fz
    i, j, k = int(fx) & (columns - 1), int(fy) & (rows - 1), int(fz)
    i1, j1 = (i + 1) & (columns - 1), (j + 1) & (rows - 1)
    sun, sky, ground = 0.0, 0.0, 0.0
    for n in range(4):
        a, b = i1 if n & 1 else i, j1 if n & 2 else j
        weight = (u if n & 1 else 1 - u) * (v if n & 2 else 1 - v)
        sun += weight * (light[b, a, k, 1] * (1 - w) + light[b, a, k + 1, 1] * w)
        sky += weight * (light[b, a, k, 2] * (1 - w) + light[b, a, k + 1, 2] * w)
        ground += weight * (light[b, a, k, 3] * (1 - w) + light[b, a, k + 1, 3] * w)
    return sun * left, sky * left, ground + sky * (1.0 - left)  # under both lights it is even


@part
def onward(low, high, way, ahead):
    """Diffuse light scattered toward the eye, by the fluence somewhat before and behind: with 3 g flux toward it,
    held to what is possible.
    """
    fluence = 0.5 * (low + high)
    return (fluence + min(max(way * (high - low) + ahead, -fluence), fluence)) / FOUR_PI


@part
def depth_to_sun(m, light, sun, x, y, z, dx, dz, near):
    """Optical depth from a place to the sun: a few steps through the field itself, and the scaled one beyond them."""
    total, t = 0.0, 0.0
    for n in range(3):
        ds = near * (0.5 + n)
        s = t + 0.5 * ds
        total += extinction(m, x + s * sun[0], y + s * sun[1], z + s * sun[2]) * ds
        t += ds
    z += t * sun[2]
    if z > m.thickness:
        return total, 0.0
    return total, between(light[..., 0], (x + t * sun[0]) / dx - 0.5, (y + t * sun[1]) / dx - 0.5, z / dz - 0.5)


@part
def height_over(s, up):
    """Height of a ray over the round ground at distance s, m."""
    return s * up + s * s * (1.0 - up * up) / (2.0 * EARTH_RADIUS)


@part
def distance_to(height, up):
    """Distance at which a ray comes to a height over the round ground, m."""
    curve = (1.0 - up * up) / (2.0 * EARTH_RADIUS)
    return 2.0 * height / (up + math.sqrt(up * up + 4.0 * curve * height))


@part
def placed(depth, count):
    """Where a scaled depth lies among those of `scattering`, as a place and a share of the next."""
    place = min(math.log1p(depth / FIRST) / STEP, count - 1.000001)
    return int(place), place - int(place)


@part
def sources(m, light, sun, numbers, view, here, sigma):
    """The scaled depth to the sun from a place, and what it sends toward the eye of sun, sky and ground that the cloud
    had scattered before. `here` in m.
    """
    kept, near, asymmetry, open_air = numbers[0], numbers[2], numbers[3], numbers[4]
    x, y, z = here
    a, b, up, cosine, dx, dz = view
    close, beyond = depth_to_sun(m, light, sun, x, y, z, dx, dz, 2.0 * near)
    depth = close * kept + beyond
    turned = sigma * (1.0 - asymmetry)
    off, lowest = min(0.5 * dx, 0.5 / turned), 0.5 * turned * dz  # half a cell, half a free path in dense cloud
    u, v, w = x / dx - 0.5, y / dx - 0.5, z / dz - 0.5
    east, north, high = a * off / dx, b * off / dx, up * off / dz
    s1, k1, g1 = fluences(light, u + east, v + north, w + high, lowest)
    s0, k0, g0 = fluences(light, u - east, v - north, w - high, lowest)
    left = asymmetry / (1.0 + asymmetry)
    way = left / (max(turned, open_air) * 2.0 * off)
    ahead = 3.0 * left * left / (1.0 - left) * min(turned / open_air, 1.0) * math.exp(-depth) * cosine
    return depth, onward(s0, s1, way, ahead), onward(k0, k1, way, 0.0), onward(g0, g1, way, 0.0)


@compiled
def marched(first, last, m, directions, light, gaps, period, sun, numbers, out):
    """Fill out (D, 5 + DEPTHS) for irradiances of 1: transmittance, radiance of sunlight scattered more than once, of
    sky and ground, distance of the cloud, and sunlight scattered once over the phase function, by the depth it came.
    """
    kept, farthest, fine = numbers[0], numbers[1], numbers[2]
    dx, dz = period / light.shape[1], m.thickness / light.shape[2]
    for n in range(first, last):
        a, b, up = directions[n, 0], directions[n, 1], max(directions[n, 2], 1e-4)
        cosine = a * sun[0] + b * sun[1] + up * sun[2]
        view = (a, b, up, cosine, dx, dz)
        out[n] = 0.0
        s, end = distance_to(m.base, up), min(distance_to(m.base + m.thickness, up), farthest)
        through, from_sun, from_sky, from_ground, weight, far, was_cloud = 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, False
        while s < end and through > 0.0:
            gap = free(gaps, (s * a + m.east) / dx, (s * b + m.north) / dx, (height_over(s, up) - m.base) / dz)
            if gap > 0.0:
                s, was_cloud = s + gap, False
                continue
            step = max(fine * (1.0 + 1.5 * (1.0 - through)), 0.002 * s)
            middle = s + 0.5 * step
            here = (middle * a + m.east, middle * b + m.north, height_over(middle, up) - m.base)
            sigma = extinction(m, here[0], here[1], here[2])
            if sigma <= 0.0:
                s, was_cloud = s + (step if was_cloud else 1.5 * step), False
                continue
            step = step if was_cloud else max(0.5 * step, fine)
            if sigma * kept * step > DENSE:
                step = DENSE / (sigma * kept)
                middle = s + 0.5 * step
                here = (middle * a + m.east, middle * b + m.north, height_over(middle, up) - m.base)
            depth, by_sun, by_sky, by_ground = sources(m, light, sun, numbers, view, here, sigma)
            share = through * (1.0 - math.exp(-sigma * kept * step))
            share = through if through - share < GONE else share
            k, rest = placed(depth - math.log(through), out.shape[1] - 5)
            out[n, 5 + k] += share * math.exp(-depth) * (1.0 - rest)
            out[n, 6 + k] += share * math.exp(-depth) * rest
            from_sun += share * by_sun
            from_sky += share * by_sky
            from_ground += share * by_ground
            far += share * middle
            weight += share
            through -= share
            s, was_cloud = s + step, True
        out[n, 0], out[n, 1], out[n, 2], out[n, 3] = through, from_sun, from_sky, from_ground
        out[n, 4] = far / weight if weight > 0.0 else s

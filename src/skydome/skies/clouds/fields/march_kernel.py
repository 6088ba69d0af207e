# mypy: allow-untyped-defs
"""Rays through a field of cloud, compiled: what is seen through it, and what it sends of sun, sky and ground.

`light` (north, east, up, 8), float32: fluence and flux to east, north and up of scattered sunlight, and of skylight,
for an irradiance of 1 each. `depths`: toward the sun, as `medium_kernel.beams` has them. `gaps` (north, east, up): m
around that are free of cloud. `numbers`: share of the extinction that stays after the forward peak is taken out, how
far light is sought, the step, m, and the mean cosine of the scattering angle.
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
def radiances(light, x, y, z, a, b, up, forward, lowest):
    """Diffuse light of sun, sky and ground that is scattered toward the eye, seen along (a, b, up): fluence and flux
    linear between the middles of cells, and down to the base (Marshak's boundary), half a cell that is `lowest`
    transport free paths thick.
    """
    rows, columns, levels, _ = light.shape
    left = 1.0 - 2.0 * min(max(-z, 0.0), 0.5) * 1.5 * lowest / (1.0 + 1.5 * lowest)
    z = min(max(z, 0.0), levels - 1.000001)
    fx, fy, fz = math.floor(x), math.floor(y), math.floor(z)
    u, v, w = x - fx, y - fy, z - fz
    i, j, k = int(fx) & (columns - 1), int(fy) & (rows - 1), int(fz)
    i1, j1 = (i + 1) & (columns - 1), (j + 1) & (rows - 1)
    sun, along_sun, sky, along_sky = 0.0, 0.0, 0.0, 0.0
    for n in range(8):
        q, r, s = i1 if n & 1 else i, j1 if n & 2 else j, k + (n >> 2)
        weight = (u if n & 1 else 1 - u) * (v if n & 2 else 1 - v) * (w if n & 4 else 1 - w)
        sun += weight * light[r, q, s, 0]
        along_sun += weight * (a * light[r, q, s, 1] + b * light[r, q, s, 2] + up * light[r, q, s, 3])
        sky += weight * light[r, q, s, 4]
        along_sky += weight * (a * light[r, q, s, 5] + b * light[r, q, s, 6] + up * light[r, q, s, 7])
    ground = 4.0 - sky * left  # under both lights it is even
    sun, sky = sun * left, sky * left
    along_sun, along_sky = forward * along_sun, forward * along_sky
    return (
        max(sun - along_sun, 0.0) / FOUR_PI,
        max(sky - along_sky, 0.0) / FOUR_PI,
        max(ground + along_sky, 0.0) / FOUR_PI,
    )


@part
def depth_to_sun(m, depths, sun, x, y, z, period, kept, near):
    """Scaled optical depth from a place to the sun: a few steps through the field itself, and along the sun's rays
    (`beams`) beyond them.
    """
    total, t = 0.0, 0.0
    for n in range(3):
        ds = near * (0.5 + n)
        s = t + 0.5 * ds
        total += extinction(m, x + s * sun[0], y + s * sun[1], z + s * sun[2]) * ds
        t += ds
    high = z + t * sun[2]
    if high > m.thickness or high < 0.0:
        return total * kept
    step, lean = period / depths.shape[1], z / sun[2]
    place = high / m.thickness * (depths.shape[2] - 1)
    return total * kept + between(depths, (x - lean * sun[0]) / step, (y - lean * sun[1]) / step, place)


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
def sources(m, light, depths, sun, numbers, view, here, sigma):
    """The scaled depth to the sun from a place, and what it sends toward the eye of sun, sky and ground that the cloud
    had scattered before. `here` in m.
    """
    kept, near, asymmetry = numbers[0], numbers[2], numbers[3]
    x, y, z = here
    a, b, up, dx, dz = view
    depth = depth_to_sun(m, depths, sun, x, y, z, dx * light.shape[1], kept, 2.0 * near)
    lowest = 0.5 * sigma * (1.0 - asymmetry) * dz
    forward = 3.0 * asymmetry / (1.0 + asymmetry)
    by_sun, by_sky, by_ground = radiances(light, x / dx - 0.5, y / dx - 0.5, z / dz - 0.5, a, b, up, forward, lowest)
    return depth, by_sun, by_sky, by_ground


@compiled
def marched(first, last, m, directions, light, depths, gaps, period, sun, numbers, out):
    """Fill out (D, 5 + DEPTHS) for irradiances of 1: transmittance, radiance of sunlight scattered more than once, of
    sky and ground, distance of the cloud, and sunlight scattered once over the phase function, by the depth it came.
    """
    kept, farthest, fine = numbers[0], numbers[1], numbers[2]
    dx, dz = period / light.shape[1], m.thickness / light.shape[2]
    for n in range(first, last):
        a, b, up = directions[n, 0], directions[n, 1], max(directions[n, 2], 1e-4)
        view = (a, b, up, dx, dz)
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
            depth, by_sun, by_sky, by_ground = sources(m, light, depths, sun, numbers, view, here, sigma)
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

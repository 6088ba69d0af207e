# mypy: allow-untyped-defs
"""Paths of light through a field of cloud, compiled: delta tracking (Woodcock et al. 1965), all orders.

`m` is a `field.Medium`; `gaps` (north, east, up) m around that are free of cloud, in cells of width `dx`; `laws`: the
phase function (ANGLES, C), the same evened about its peak, narrowly and widely, angles at even shares of its integral,
and the shares that are scattered (C,). `lights`: toward the sun as it is seen in the field; its light there (heights,
ways, C), from base to top and, along its azimuth, from FARTHEST m away from the sun to as far toward it; toward the sun
as it is seen from the ground, its light there and the ground's albedo, (C,). A path's state `p` (6,): place over the
field, m, z above the base, and direction. Random numbers are a hash of path and event.
"""

import math

import numpy as np

from skydome.ground.compiled import inlined, job
from skydome.ground.elementary_kernel import GOLDEN, stirred, uniform
from skydome.ground.units import EARTH_RADIUS
from skydome.skies.clouds.fields.air.sunlight_kernel import MOST, light_at, place_of, reaches
from skydome.skies.clouds.fields.march_kernel import distance_to, height_over
from skydome.skies.clouds.fields.medium_kernel import extinction, free

compiled, part = job(), inlined()
WIDE = 3
"""Turns of a path after which the law that looks for the sun is the widely evened one."""
BRIGHT = 0.1
"""Of that law, sr-1: where it is less, only so large a share of the rays to the sun is followed, and counts for all."""


@part
def flown(m, gaps, dx, p, key, count):
    """Move `p` to its next collision or out of the layer; events so far, negative where it is out."""
    dz = m.thickness / gaps.shape[2]
    while count < MOST:
        gap = free(gaps, p[0] / dx, p[1] / dx, p[2] / dz)
        t = gap if gap > 0.0 else -math.log(uniform(key, count)) / m.extinction
        count += 1
        z = p[2] + t * p[5]
        if z < 0.0 or z > m.thickness:
            out = ((m.thickness if p[5] > 0.0 else 0.0) - p[2]) / p[5]
            p[0], p[1], p[2] = p[0] + out * p[3], p[1] + out * p[4], m.thickness if p[5] > 0.0 else 0.0
            return -count
        p[0], p[1], p[2] = p[0] + t * p[3], p[1] + t * p[4], z
        if gap <= 0.0 and uniform(key, count) * m.extinction < extinction(m, p[0], p[1], p[2]):
            return count + 1
        count += 1
    return -MOST


@part
def turn(p, cosine, around):
    """Turn the direction of `p` by an angle, in place."""
    x, y, z = p[3], p[4], p[5]
    sine = math.sqrt(max(1.0 - cosine * cosine, 0.0))
    u, v = sine * math.cos(around), sine * math.sin(around)
    sign = 1.0 if z >= 0.0 else -1.0  # a frame without a pole (Duff et al. 2017)
    a = -1.0 / (sign + z)
    b = x * y * a
    p[3] = u * (1.0 + sign * x * x * a) + v * b + cosine * x
    p[4] = u * sign * b + v * (sign + y * y * a) + cosine * y
    p[5] = -u * sign * x + -v * y + cosine * z


@part
def angle_drawn(angles, share):
    """The scattering angle of a share of the phase function's integral."""
    place = share * (angles.size - 1)
    at = min(int(place), angles.size - 2)
    return angles[at] + (angles[at + 1] - angles[at]) * (place - at)


@part
def from_sun(m, gaps, dx, p, law, sun, there, key, seldom, light, worth):
    """Add the sun's light, by its table (heights, ways, C), turned by a law (ANGLES, C) at pi t^2 for even t; `seldom`
    where that is dim.
    """
    cosine = p[3] * sun[0] + p[4] * sun[1] + p[5] * sun[2]
    place = math.sqrt(math.acos(min(max(cosine, -1.0), 1.0)) / math.pi) * (law.shape[0] - 1)
    at = min(int(place), law.shape[0] - 2)
    share = place - at
    followed = min(law[at, 0] / BRIGHT, 1.0) if seldom else 1.0
    if uniform(key, 0) >= followed:
        return
    left = reaches(m, gaps, dx, p[0], p[1], p[2], sun, stirred(key)) / followed
    row, column = place_of(m, p, sun, there)
    for c in range(light.size):
        law_here = law[at, c] * (1 - share) + law[at + 1, c] * share
        light[c] += worth[c] * left * law_here * light_at(there, row, column, c)


@part
def from_sky(sky, p, light, worth):
    """Add the light of the sky, a table (elevations, azimuths, C), toward the direction of `p`."""
    row = math.asin(min(max(p[5], 0.0), 1.0)) / (0.5 * math.pi) * (sky.shape[0] - 1)
    column = (math.atan2(p[3], p[4]) / (2 * math.pi) + 1.0) % 1.0 * sky.shape[1]
    j, i = min(int(row), sky.shape[0] - 2), int(column) % sky.shape[1]
    i1, u, v = (i + 1) % sky.shape[1], column - int(column), row - j
    for c in range(light.size):
        low = sky[j, i, c] * (1 - u) + sky[j, i1, c] * u
        high = sky[j + 1, i, c] * (1 - u) + sky[j + 1, i1, c] * u
        light[c] += worth[c] * (low + (high - low) * v)


@part
def off_ground(m, gaps, dx, p, lights, key, light, worth):
    """Follow `p` down to the ground, add the sun that shines there, and send it up again."""
    _, _, sun, sun_below, albedo = lights
    t = (p[2] + m.base) / -p[5]
    x, y = p[0] + t * p[3], p[1] + t * p[4]
    left = 0.0
    if sun[2] > 0.0:
        up = distance_to(m.base, sun[2])
        sine = sun[2] + up * (1.0 - sun[2] * sun[2]) / EARTH_RADIUS
        flat = math.sqrt(max(1.0 - sine * sine, 0.0) / max(1.0 - sun[2] * sun[2], 1e-12))
        toward = (sun[0] * flat, sun[1] * flat, sine)
        left = sun[2] * reaches(m, gaps, dx, x + up * sun[0], y + up * sun[1], 0.0, toward, stirred(key + GOLDEN))
    for c in range(light.size):
        worth[c] *= albedo[c]
        light[c] += worth[c] * left * sun_below[c] / math.pi
    p[5] = math.sqrt(uniform(key, 0))
    level, around = math.sqrt(max(1.0 - p[5] * p[5], 0.0)), 2 * math.pi * uniform(key, 1)
    p[3], p[4] = level * math.cos(around), level * math.sin(around)
    t = m.base / p[5]
    p[0], p[1], p[2] = x + t * p[3], y + t * p[4], 0.0


@part
def followed(m, gaps, dx, p, laws, lights, sky, key, count, light, worth):
    """Follow a path from its first collision on and gather its light, (C,)."""
    law, evened, widely, angles, share = laws
    sun, there, _, _, _ = lights
    turns = 0
    while True:
        if count > 0:
            total = 0.0
            for c in range(light.size):
                worth[c] *= share[c]
                total = max(total, worth[c])
            looks = law if turns == 0 else evened if turns < WIDE else widely
            ray = stirred(key + np.uint64(count) * GOLDEN)
            from_sun(m, gaps, dx, p, looks, sun, there, ray, turns > 0, light, worth)
            turns += 1
            if total < 0.05:
                if uniform(key, count) > 0.5:
                    return
                for c in range(light.size):
                    worth[c] *= 2.0
            turn(p, math.cos(angle_drawn(angles, uniform(key, count + 1))), 2 * math.pi * uniform(key, count + 2))
            count += 3
        elif p[5] > 0.0:
            from_sky(sky, p, light, worth)
            return
        else:
            count = -count
            if count >= MOST:
                return
            off_ground(m, gaps, dx, p, lights, stirred(key + np.uint64(count) * GOLDEN), light, worth)
            total = 0.0
            for c in range(light.size):
                total = max(total, worth[c])
            if total <= 0.0:
                return
        count = flown(m, gaps, dx, p, key, count)


@compiled
def traced(first, last, m, directions, gaps, dx, laws, lights, sky, paths, seed, number, out):
    """Fill out (D, C + 2): light of the cloud by paths from the eye, share that passes, mean distance of collisions."""
    channels = sky.shape[2]
    p, light, worth = np.empty(6), np.empty(channels), np.empty(channels)
    for n in range(first, last):
        up = max(directions[n, 2], 1e-4)
        start, passed, far = distance_to(m.base, up), 0, 0.0
        curved = (height_over(start + 1.0, up) - height_over(start, up)) / 1.0
        flat = math.sqrt(max(1.0 - curved * curved, 0.0) / max(1.0 - up * up, 1e-12))
        light[:] = 0.0
        for k in range(paths):
            key = stirred(np.uint64(n * paths + k) + stirred(np.uint64(seed) * GOLDEN + np.uint64(number)))
            p[0], p[1], p[2] = start * directions[n, 0] + m.east, start * directions[n, 1] + m.north, 0.0
            p[3], p[4], p[5] = directions[n, 0] * flat, directions[n, 1] * flat, curved
            worth[:] = 1.0
            count = flown(m, gaps, dx, p, key, 1)
            if count < 0:
                passed += 1
                continue
            far += start + p[2] / curved
            followed(m, gaps, dx, p, laws, lights, sky, key, count, light, worth)
        for c in range(channels):
            out[n, c] = light[c] / paths
        out[n, channels] = passed / paths
        out[n, channels + 1] = far / (paths - passed) if passed < paths else start


@compiled
def photons(first, last, m, gaps, dx, laws, sun, period, seed, out):
    """Count of photons from the sun: sent up, sent down after scattering, straight through, absorbed, into out (4,)."""
    angles, share = laws[3], laws[4][0]
    p = np.empty(6)
    for n in range(first, last):
        key = stirred(np.uint64(n) + stirred(np.uint64(seed) * GOLDEN))
        p[0], p[1], p[2] = uniform(key, 0) * period, uniform(key, 1) * period, m.thickness if sun[2] > 0.0 else 0.0
        p[3], p[4], p[5] = -sun[0], -sun[1], -sun[2]
        count, hits = flown(m, gaps, dx, p, key, 2), 0
        while count > 0:
            hits += 1
            if uniform(key, count) >= share:
                break
            turn(p, math.cos(angle_drawn(angles, uniform(key, count + 1))), 2 * math.pi * uniform(key, count + 2))
            count = flown(m, gaps, dx, p, key, count + 3)
        out[3 if count > 0 else 2 if hits == 0 else 0 if p[5] > 0.0 else 1] += 1.0

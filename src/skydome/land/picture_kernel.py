# mypy: allow-untyped-defs
"""Rows of a terrain picture: rays, sun and shadows, skylight, and the air before them, compiled.

Tuples that functions share: `ground` is heights, pyramid, levels, dx, dy, and of the ground beyond the map its height
under the camera and how much it bends down, per m of squared distance; `camera` u, v, z, forward, right, up (scaled to
half the frame), width, height; `sunlight` the direction to the sun, two tangents there as long as the disc's radius,
and irradiance, each (3,), then what clouds leave of it (`cloud_shade.Shade`); `surface` the albedo image, its texels a
cell along rows and columns, and the mean (3,), that of the ground beyond the map; `lit` how skylight depends on the
normal (rows, columns, 9), their stride and what is bounced (3,); `air` the kind, the fog (6,), densities (2,),
`haze.fast.FastTables`, and factors of scattered light around the horizon, then toward the zenith (K + 2, 3). Places are
u, v in cells and z in metres, directions x, y (east, north), z.
"""

import math

import numpy as np

from skydome.ground.compiled import inlined, job
from skydome.ground.elementary_kernel import GOLDEN, stirred, uniform
from skydome.haze.kernel import along, read_light
from skydome.land.rays_kernel import lerped, march, normal_at
from skydome.skies.clouds.fields.low_sun import LOWEST

FARTHEST = 1e9
"""How far flat ground beyond the map is followed, m."""
NOTHING, CLEAR, FOG = 0, 1, 2
"""What the air does: nothing, aerial perspective, or a fog that looks the same from everywhere."""
LIFT = 0.02
"""How far above the ground, in cells, a ray to the sun starts."""
real = np.float32
compiled, part = job(), inlined()


@part
def view(camera, row, column, sample, side, key):
    """The ray through one of side x side jittered places in a pixel, a unit vector x, y, z."""
    _, _, _, forward, right, up, width, height = camera
    px = (column + (sample % side + uniform(key, 0)) / side) / width * 2 - 1
    py = 1 - (row + (sample // side + uniform(key, 1)) / side) / height * 2
    x = forward[0] + px * right[0] + py * up[0]
    y = forward[1] + px * right[1] + py * up[1]
    z = forward[2] + px * right[2] + py * up[2]
    scale = 1.0 / math.sqrt(x * x + y * y + z * z)
    return x * scale, y * scale, z * scale


@part
def reached(ground, camera, x, y, z):
    """Metres to the ground, negative for the sky, and whether it is on the map."""
    heights, pyramid, levels, dx, dy, beyond = ground
    t = march(heights, pyramid, levels, camera[0], camera[1], camera[2], x / dx, -y / dy, z, FARTHEST)
    if t >= 0.0 or z >= -1e-9:
        return t, t >= 0.0
    return to_ground_beyond(camera[2] - beyond[0], beyond[1], z), False


@part
def to_ground_beyond(above, bend, z):
    """Metres along a ray to the ground beyond the map, `above` m below the eye; -1 where that curves away.

    The first root of above + z t + bend (1 - z^2) t^2 = 0.
    """
    curve = bend * (1.0 - z * z)
    inner = z * z - 4.0 * curve * above
    if inner < 0.0:
        return -1.0
    return min(2.0 * above / (-z + math.sqrt(inner)), FARTHEST)


@part
def point_on_sun(sunlight, key):
    """A direction to a point of the sun's disc, even over it: x, y, z, not scaled to length 1."""
    sun, across, upward = sunlight[0], sunlight[1], sunlight[2]
    radius, turn = math.sqrt(uniform(key, 2)), 2 * math.pi * uniform(key, 3)
    a, b = radius * math.cos(turn), radius * math.sin(turn)
    return (
        sun[0] + a * across[0] + b * upward[0],
        sun[1] + a * across[1] + b * upward[1],
        sun[2] + a * across[2] + b * upward[2],
    )


@part
def sun_cosine(ground, u, v, z, normal, sunlight, key):
    """Cosine between the slope's normal at a place on the map and the sun; 0 in shadow, or turned away."""
    heights, pyramid, levels, dx, dy, _ = ground
    sun = sunlight[0]
    cosine = normal[0] * sun[0] + normal[1] * sun[1] + normal[2] * sun[2]
    if cosine <= 0.0:
        return 0.0
    x, y, up = point_on_sun(sunlight, key)
    blocked = march(heights, pyramid, levels, u, v, z + LIFT * min(dx, dy), x / dx, -y / dy, up, FARTHEST)
    return 0.0 if blocked >= 0.0 else cosine


@part
def cloud_share(sunlight, x, y, z):
    """Share of the sun's light that clouds leave at x, y (m east and north of the camera) and height z, 0-1."""
    sun, shade = sunlight[0], sunlight[4]
    if shade.share.size == 1:
        return shade.share[0, 0]
    down = (z - shade.foot) / max(sun[2], LOWEST)
    u, v = (x - down * sun[0]) / shade.spacing, (y - down * sun[1]) / shade.spacing
    fu, fv = math.floor(u), math.floor(v)
    a, b = u - fu, v - fv
    rows, columns = shade.share.shape
    i, j = int(fv) % rows, int(fu) % columns
    k, m = (i + 1) % rows, (j + 1) % columns
    low = shade.share[i, j] * (1 - a) + shade.share[i, m] * a
    return low * (1 - b) + (shade.share[k, j] * (1 - a) + shade.share[k, m] * a) * b


@part
def ground_light(ground, camera, sunlight, lit, surface, x, y, z, t, on_map, key, colour, skyward, light):
    """The light of the ground that a ray x, y, z meets at t, before the air dims it, into `light` (3,).

    `colour` (3,), `skyward` (9,): scratch.
    """
    u, v = camera[0] + x / ground[3] * t, camera[1] - y / ground[4] * t
    cosine, normal = max(sunlight[0][2], 0.0), (0.0, 0.0, 1.0)
    colour[0], colour[1], colour[2] = surface[3][0], surface[3][1], surface[3][2]
    if on_map:
        lerped(surface[0], v * surface[1], u * surface[2], colour)
        normal = normal_at(ground[0], u, v, ground[3], ground[4])
        cosine = sun_cosine(ground, u, v, camera[2] + z * t, normal, sunlight, key)
    if cosine > 0.0:
        cosine *= cloud_share(sunlight, x * t, y * t, camera[2] + z * t)
    lerped(lit[0], v / lit[1], u / lit[1], skyward)
    for c in range(3):
        part = normal[0] * skyward[3 * c] + normal[1] * skyward[3 * c + 1] + normal[2] * skyward[3 * c + 2]
        light[c] = colour[c] / math.pi * (sunlight[3][c] * cosine + max(lit[2][c] + part, 0.0))


@part
def horizon_factor(factors, x, y, z, c):
    """By what the air's scattered light in channel c is multiplied along a ray."""
    last = factors.shape[0] - 2
    place = (math.atan2(x, y) / (2 * math.pi) + 1.0) % 1.0 * last
    k = min(int(place), last - 1)
    around = factors[k, c] + (place - k) * (factors[k + 1, c] - factors[k, c])
    return factors[last + 1, c] + (around - factors[last + 1, c]) * (1.0 - z * z)


@part
def through_air(air, x, y, z, t, scattered, light):
    """Dim and veil `light` (3,), in place, by t metres of air along a ray. `scattered` (6,): scratch."""
    kind, fog, densities, tables, factors = air
    if kind == CLEAR:
        coefficients, nodes, table, suns, peak = tables
        read_light(table, suns, peak, real(x), real(y), real(z), scattered)
        t0, t1, t2, h0, h1, h2, g0, g1, g2 = along(real(t), real(z), densities[0], densities[1], coefficients, nodes)
        f0, f1, f2 = 1.0, 1.0, 1.0
        if factors.shape[0] > 2:
            f0, f1, f2 = (horizon_factor(factors, x, y, z, 0), horizon_factor(factors, x, y, z, 1),
                          horizon_factor(factors, x, y, z, 2))  # fmt: skip
        light[0] = light[0] * t0 + (scattered[0] * h0 + scattered[3] * g0) * f0
        light[1] = light[1] * t1 + (scattered[1] * h1 + scattered[4] * g1) * f1
        light[2] = light[2] * t2 + (scattered[2] * h2 + scattered[5] * g2) * f2
    elif kind == FOG:
        for c in range(3):
            seen = math.exp(-fog[c] * t)
            light[c] = light[c] * real(seen) + real((1 - seen) * fog[3 + c])


@compiled
def picture_rows(first, last, ground, camera, samples, seed, sky, sunlight, lit, surface, air, out, depth):
    """Fill rows first...last of RGB `out` (H, W, 3) and mean `depth` (H, W), m, infinite where only sky is seen.

    `sky` (H, W, 3). `samples` a pixel, a square number; the random numbers are those of (seed, pixel, sample).
    """
    side, width = int(math.sqrt(samples)), out.shape[1]
    scattered = np.zeros(6, np.float32)
    colour, skyward, light, total = np.zeros(3), np.zeros(9), np.zeros(3), np.zeros(3)
    for row in range(first, last):
        for column in range(width):
            total[:] = 0.0
            far, hits = 0.0, 0
            for s in range(samples):
                key = stirred(np.uint64((row * width + column) * samples + s) + np.uint64(seed) * GOLDEN)
                x, y, z = view(camera, row, column, s, side, key)
                t, on_map = reached(ground, camera, x, y, z)
                if t < 0.0:
                    light[:] = sky[row, column]
                else:
                    hits += 1
                    far += t
                    ground_light(
                        ground, camera, sunlight, lit, surface, x, y, z, t, on_map, key, colour, skyward, light
                    )
                    through_air(air, x, y, z, t, scattered, light)
                for c in range(3):
                    total[c] += light[c]
            for c in range(3):
                out[row, column, c] = total[c] / samples
            depth[row, column] = far / hits if hits > 0 else np.inf

# mypy: disable-error-code="no-untyped-def,untyped-decorator,misc"
"""Rows of a terrain picture: rays, sun and shadows, skylight, and the air before them, compiled."""

import math

import numba
import numpy as np

from skydome.haze.kernel import along, read_light
from skydome.land.rays_kernel import lerp3, march, noise, normal_at

FARTHEST = 1e9
"""How far flat ground beyond the map is followed, m."""
NOTHING, CLEAR, FOG = 0, 1, 2
"""What the air does: nothing, aerial perspective, or a fog that looks the same from everywhere."""


@numba.njit(cache=True, error_model="numpy", parallel=True)
def picture_rows(
    ground, camera, first_row, samples, seed, sky, sunlight, lit, surface, air_kind, fog, densities, tables, out, depth
):
    """Fill rows `first_row`.. of RGB `out` (R, W, 3) and mean `depth` (R, W), m, infinite where only sky is seen.

    `ground`: heights, pyramid, levels, dx, dy, base. `camera`: u, v, z, forward, right, up scaled to half the frame.
    `sky` (R, W, 3). `sunlight`: direction, irradiance (3,), sine of the disc's radius. `lit`: skylight and stride.
    `surface`: albedo image, texels a cell, and the mean, which the ground beyond the map has. `fog` (6,): extinction
    m-1 and ambient light.
    """
    heights, pyramid, levels, dx, dy, base = ground
    u0, v0, z0, forward, right, up, width, height = camera
    sun, sun_rgb, sun_radius = sunlight
    skylit, stride = lit
    albedo, texel_rows, texel_columns, mean_albedo = surface
    air, nodes, table, suns, peak = tables
    side = int(math.sqrt(samples))
    for row in numba.prange(out.shape[0]):
        scattered = np.zeros(6, np.float32)
        colour, skyward, total = np.zeros(3), np.zeros(3), np.zeros(3)
        for column in range(out.shape[1]):
            total[:] = 0.0
            far, hits = 0.0, 0
            for s in range(samples):
                key = (((first_row + row) * width + column) * samples + s) * 4 + seed * 7919
                px = (column + (s % side + noise(key)) / side) / width * 2 - 1
                py = 1 - (first_row + row + (s // side + noise(key + 1)) / side) / height * 2
                x = forward[0] + px * right[0] + py * up[0]
                y = forward[1] + px * right[1] + py * up[1]
                z = forward[2] + px * right[2] + py * up[2]
                scale = 1.0 / math.sqrt(x * x + y * y + z * z)
                x, y, z = x * scale, y * scale, z * scale
                t = march(heights, pyramid, levels, u0, v0, z0, x / dx, -y / dy, z, 1e9)
                on_map = t >= 0.0
                if not on_map and z < -1e-9:
                    t = min((z0 - base) / -z, FARTHEST)
                if t < 0.0:
                    for c in range(3):
                        total[c] += sky[row, column, c]
                    continue
                hits += 1
                far += t
                u, v = u0 + x / dx * t, v0 - y / dy * t
                if on_map:
                    lerp3(albedo, v * texel_rows, u * texel_columns, colour)
                else:
                    colour[0], colour[1], colour[2] = mean_albedo[0], mean_albedo[1], mean_albedo[2]
                lerp3(skylit, v / stride, u / stride, skyward)
                nx, ny, nz = 0.0, 0.0, 1.0
                if on_map:
                    nx, ny, nz = normal_at(heights, u, v, dx, dy)
                sx, sy, sz = sun[0], sun[1], sun[2]
                cosine = nx * sx + ny * sy + nz * sz
                if cosine > 0.0 and on_map:
                    sx += sun_radius * (noise(key + 2) * 2 - 1)
                    sz += sun_radius * (noise(key + 3) * 2 - 1)
                    lift = 0.02 * min(dx, dy)
                    zs = z0 + z * t + lift
                    if march(heights, pyramid, levels, u, v, zs, sx / dx, -sy / dy, sz, 1e9) >= 0.0:
                        cosine = 0.0
                if air_kind == CLEAR:
                    read_light(table, suns, peak, np.float32(x), np.float32(y), np.float32(z), scattered)
                    t0, t1, t2, h0, h1, h2, g0, g1, g2 = along(
                        np.float32(t), np.float32(z), densities[0], densities[1], air, nodes
                    )
                    seen = (t0, t1, t2)
                    veil = (
                        scattered[0] * h0 + scattered[3] * g0,
                        scattered[1] * h1 + scattered[4] * g1,
                        scattered[2] * h2 + scattered[5] * g2,
                    )
                elif air_kind == FOG:
                    f0, f1, f2 = math.exp(-fog[0] * t), math.exp(-fog[1] * t), math.exp(-fog[2] * t)
                    seen = (np.float32(f0), np.float32(f1), np.float32(f2))
                    veil = (
                        np.float32((1 - f0) * fog[3]), np.float32((1 - f1) * fog[4]), np.float32((1 - f2) * fog[5]),
                    )  # fmt: skip
                else:
                    seen = (np.float32(1), np.float32(1), np.float32(1))
                    veil = (np.float32(0), np.float32(0), np.float32(0))
                for c in range(3):
                    light = colour[c] / math.pi * (sun_rgb[c] * max(cosine, 0.0) + skyward[c])
                    total[c] += light * seen[c] + veil[c]
            for c in range(3):
                out[row, column, c] = total[c] / samples
            depth[row, column] = far / hits if hits > 0 else np.inf

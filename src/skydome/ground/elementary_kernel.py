# mypy: allow-untyped-defs
"""What kernels share: exponentials, the logarithm, and random numbers that are a hash of where they are used."""

import math

import numpy as np

from skydome.ground.compiled import ANY_ORDER, IN_ORDER, inlined, piece

real = np.float32
ZERO, HALF, ONE, TWO = real(0.0), real(0.5), real(1.0), real(2.0)
ROUNDING = real(1.5 * 2**23)
"""Added and taken away again it rounds to a whole number, which stands in the low bits of the sum."""
LEAST_POWER = real(1.5 * 2**23 - 126)
MANTISSA_BITS, BITS_OF_ONE = np.int32(23), np.int32(127 << 23)
HALF_BITS = np.int32(0x3F3504F3)  # float32 sqrt(1/2)
LOG2, LOG2_E = real(np.log(2.0)), real(np.log2(np.e))
# Through Chebyshev nodes, 2^r for |r| <= 1/2: error 2e-9.
P1, P2, P3, P4, P5, P6 = (real(np.log(2.0) ** k * c) for k, c in enumerate(
    (1.0000000377388714, 0.5000000047146057, 0.16666415414041177, 0.04166635277111221, 0.008375134774624326,
     0.0013941118895837), start=1))  # fmt: skip
L1, L2, L3, L4 = (real(2 / k) for k in (3, 5, 7, 9))
GOLDEN = np.uint64(0x9E3779B97F4A7C15)


@piece(IN_ORDER)
def power_less(x, base):
    """2^x - base in float32 for -1000 < x < 127, base 0 or 1; with base 1 it keeps its digits near x = 0."""
    shifted = x + ROUNDING
    shifted = shifted if shifted > LEAST_POWER else LEAST_POWER
    r = x - (shifted - ROUNDING)
    series = r * (((((P6 * r + P5) * r + P4) * r + P3) * r + P2) * r + P1)
    whole = np.int32(np.int32(real(shifted).view(np.int32) << MANTISSA_BITS) + BITS_OF_ONE).view(np.float32)
    return whole * series + (whole - base)


@inlined(ANY_ORDER | {"afn"})
def exponential(x):
    """exp(x) in float32, relative error 3e-7 (Cephes), for x up to 87; exp(-87) below. No branch: loops vectorise."""
    x = max(x, real(-87.0))
    whole = np.int32(x * real(1.44269504) + real(1000.5)) - np.int32(1000)
    r = x - real(whole) * real(0.693359375) + real(whole) * real(2.12194440e-4)
    p = real(1.9875691500e-4)
    p = p * r + real(1.3981999507e-3)
    p = p * r + real(8.3334519073e-3)
    p = p * r + real(4.1665795894e-2)
    p = p * r + real(1.6666665459e-1)
    p = p * r + real(5.0000001201e-1)
    p = p * r * r + r + ONE
    return p * np.int32((np.int32(whole) + np.int32(127)) << np.int32(23)).view(np.float32)


@inlined(ANY_ORDER)
def exponential_double(x):
    """exp(x) in float64 for x in (-700, 700) within 2e-10, exp(-700) below. No branch: loops vectorise."""
    bounded = max(x, -700.0)
    n = math.floor(bounded * 1.4426950408889634 + 0.5)
    r = (bounded - n * 0.6931471803691238) - n * 1.9082149292705877e-10
    p = 1 / 24 + r * (1 / 120 + r * (1 / 720 + r * (1 / 5040 + r * (1 / 40320))))
    p = 1.0 + r * (1.0 + r * (0.5 + r * (1 / 6 + r * p)))
    return p * np.int64((np.int64(n) + np.int64(1023)) << np.int64(52)).view(np.float64)


@inlined(ANY_ORDER | {"afn"})
def logarithm(x):
    """The natural logarithm in float32 of a normal x > 0: x = 2^k m, and the series of ln m in (m - 1) / (m + 1)."""
    bits = real(x).view(np.int32)
    power = np.int32(np.int32(bits - HALF_BITS) >> MANTISSA_BITS)
    m = np.int32(bits - np.int32(power << MANTISSA_BITS)).view(np.float32)
    t = (m - ONE) / (m + ONE)
    s = t * t
    return real(power) * LOG2 + t * (TWO + s * (L1 + s * (L2 + s * (L3 + s * L4))))


@inlined(ANY_ORDER)
def stirred(x):
    """64 bits, uint64, stirred (Steele et al. 2014, splitmix64)."""
    x = (x ^ (x >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    x = (x ^ (x >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return x ^ (x >> np.uint64(31))


@inlined(ANY_ORDER)
def uniform(key, place):
    """A number in (0, 1), float64, of the stream `key` (uint64) at a place (int): the same whatever the threads."""
    return (float(stirred(key + GOLDEN * np.uint64(place + 1)) >> np.uint64(11)) + 0.5) * (1.0 / 9007199254740992.0)

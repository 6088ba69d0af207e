"""Where the stars and the planets stand.

- directions  Fixed stars over a place: proper motion, parallax, aberration, the earth's axis and turning
- catalogue   The stars of Hipparcos, from the extra `night`: where, how bright, of what colour
- planets     The planets over a place, and how bright they are
"""

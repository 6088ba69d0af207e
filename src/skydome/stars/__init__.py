"""Where the stars and the planets stand.

- directions  Fixed stars over a place: proper motion, parallax, aberration, the earth's axis and turning
- planets     The planets over a place, and how bright they are
"""

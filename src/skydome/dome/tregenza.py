"""Tregenza's rows of patches, apart from all that is made of them: `skydome-mtx` starts the sooner."""

TREGENZA_COUNTS = (30, 30, 24, 24, 18, 12, 6)
"""Patches in each row from the horizon up; one more sits at the zenith (Tregenza 1987; Radiance's reinhart.cal)."""

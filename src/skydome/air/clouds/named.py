"""What clouds are made of, by the words of the command line."""

from skydome.air.clouds.crystals.hexagonal_ice import HexagonalIce
from skydome.air.clouds.particles import CloudParticles, Ice, Water

PARTICLES: dict[str, CloudParticles] = {"water": Water(), "ice": Ice(), "hexagonal": HexagonalIce()}
"""The usual particles of each word."""

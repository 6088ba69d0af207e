"""Clouds as a constituent of the air: what their droplets and crystals do to light.

- cloud      A layer of cloud, so deep at 550 nm, so high, of so large particles
- particles  What clouds are made of, water or ice: extinction, single scattering albedo, asymmetry by size
- phases     Their phase functions
"""

"""Clouds as a constituent of the air: what their droplets and crystals do to light.

- cloud      A layer of cloud, so deep at 550 nm, so high, of so large particles
- particles  What clouds are made of, water or ice: extinction, single scattering albedo, asymmetry by size
- phases     Phase functions of droplets, and of crystals as one lobe
- crystals/  Crystals as hexagonal prisms: halos
- tabulated  A phase function known by its logarithms at angles
- angles     Those angles
- named      Water, ice and hexagonal ice by the words of the command line
"""

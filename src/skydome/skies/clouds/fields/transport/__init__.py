"""Light that a field scatters more than once: transport along some directions through a coarse grid of cloud.

- ordinates         Fluence and flux of discrete ordinates, in steps hastened by diffusion
- ordinates_kernel  Light along the directions, level by level, compiled
- diffusion         What diffusion makes of a source: the hastening
- diffusion_kernel  The same compiled
"""

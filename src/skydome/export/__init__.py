"""Skies as source code for renderers.

- shaders           Skies as shader source, one function from a direction to linear RGB, or bands, in GLSL, WGSL
- shader_languages  The shading languages that skies are written in, how each spells a function
- formula_shader    The nine-number formula as shader code
- network_shader    A neural sky as shader code, the network under one sky
"""

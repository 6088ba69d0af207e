"""Neural skies: small networks from sun and view to light (Satilmis et al. 2017).

- sky            The neural sky of Satilmis et al.: a sky in 492 bytes, and wider and spectral ones
- network        Small neural networks of the sky: inputs from sun and view, layers of 1 /, light out
- files          Networks in files: safetensors with provenance in its header; nothing is executed on reading
- folding        A network under one sky: what does not change with the view goes into the biases
- fast           Light of one neural sky toward many float32 directions, in blocks
- kernel         Small networks in float32, compiled: the fast form of `network.Network.light`, tested against it
- layers_kernel  The compiled step of `kernel`: blocks of views through all layers
"""

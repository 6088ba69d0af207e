"""The conditions behind an observed sky.

- fit            The conditions behind an observed sky: a model's parameters by least squares
- samples        Observed light made ready for a fit: from arrays or an environment map to directions
- unknowns       What a fit may change: a model's parameters by name, where they start, how far they may go
- starting       Where a fit begins: a coarse grid over suns and turbidities
- determination  What the samples of a fit can tell: flat directions, rival answers, standard errors
"""

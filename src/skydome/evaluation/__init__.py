"""Models held against a measured sky.

- evaluation    Models against a measured sky: the light of each in every direction measured, and how far it is off
- measured_sky  A measured sky: spectral radiance in many directions, scan after scan, with the sun's place in each
- models        The models that can be held against a measured sky, by name
- model_fit     The numbers of a model that fit a measured sky best: from several starts, with a warning at a limit
- pointing      Where each scan's instrument really looked: a turn and a lean, fitted apart from any air
- runs          A list of models, fitted or not, against a measured sky
- figures       Figures of an evaluation: maps of measurement, model and signed error; the sun's meridian; the day
"""

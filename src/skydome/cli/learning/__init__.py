"""The commands that measure, simulate and learn, one a file; the sky's own commands are in `cli/commands`.

- evaluate     `skydome evaluate`: sky models against a measured sky
- simulate     `skydome simulate`: a grid of simulated skies in a Zarr store, or the physical sky's lessons
- fit          `skydome fit`: from a store of simulated skies to the tables of a sky model of one's own
- train        `skydome train`: a small neural network that learns a sky model, or a day
- train_day    A network that learns a day, from captured maps or a scanner's samples, for `skydome train`
- physical_networks  The physical sky's lessons and networks made anew, for `simulate` and `train`
- animate      `skydome animate`: smooth frames between captured skies
"""

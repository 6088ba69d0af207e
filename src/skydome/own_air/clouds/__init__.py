"""The overcast sky's network made anew, by `skydome train --model overcast`.

- layers     Random layers of cloud in random air, some of them hard
- lessons    What the network learns from: layers solved by discrete ordinates in a folder
- training   The network in a file, and its error
- shapes     Shapes of the dome, and how far from the best each case's coefficients are
- fitting    The network of their coefficients
"""

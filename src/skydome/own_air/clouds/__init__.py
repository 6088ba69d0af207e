"""The overcast sky's network made anew, by `skydome train --model overcast`.

- layers     Random layers of cloud in random air
- lessons    What the network learns from: layers solved by discrete ordinates in a folder
- training   The network
- polishing  The last steps of its training, over all cases at once
"""

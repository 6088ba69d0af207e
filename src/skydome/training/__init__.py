"""How small networks learn a sky: recipes, ways of training, measures.

- recipes                 Recipes by name: sizes from 492 bytes to 20 kB
- lessons                 Samples of a sky model for networks to learn: as the paper drew them, and richer ones
- train                   Training of neural skies: a teacher and a recipe give a network
- method                  What a recipe, a task and a way of training are: from samples and a recipe to layers
- halving                 Many random starts by Levenberg-Marquardt, the better part kept in each round
- levenberg_marquardt     Levenberg-Marquardt for small networks of 1 / neurons, with an exact Jacobian, in chunks
- losses                  What a network's training makes small: residuals of its sums against light, with their slopes
- pruning                 Neurons added and taken away again, the network trained in between
- variable_projection     Gauss-Newton for sums that should equal given ones, with the last layer eliminated
- backpropagation         Back-propagation as published: one sample at a time, momentum 0.9, learning rate 0.01
- backpropagation_kernel  One epoch of back-propagation, sample by sample, compiled
- journal                 A training that can be interrupted: what is done so far, in a file
- validation              How wrong a neural sky is: the paper's measures and honest ones beside them
"""

"""The Prague sky model from the files that its authors publish (Wilkie et al. 2021, Vevoda et al. 2022).

- file           The numbers of a Prague file: which skies it holds, and blocks that are read as they are asked for
- geometry       The angles in which the model is written, for an observer at any height
- transmittance  What the air lets through, from a file that has it
- sky            The sky: radiance, transmittance, polarisation
"""

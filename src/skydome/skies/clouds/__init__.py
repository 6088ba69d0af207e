"""Skies with clouds.

- fields/  Fields of cloud in three dimensions before the clear sky: cumulus, stratocumulus, altocumulus, cirrus

Heights in metres above the ground, extinction in inverse metres.
"""

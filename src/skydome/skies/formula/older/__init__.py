"""Older skies that the papers name, each by its own formula.

- matsuura_iwata  Matsuura and Iwata's sky between clear and overcast, the third model of Radiance's gensky
- brunger_hooper  Brunger and Hooper's sky, three terms fitted to measured radiance, by clearness and diffuse share

The papers name more: Pokrowski's of 1929 and Takagi's colour by luminance, whose numbers no open source gives.
"""

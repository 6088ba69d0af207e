"""What the light of sun and sky carries beside what eyes see.

- weighted         The light of sun and sky on the horizontal, weighted by what each wavelength does
- broadband        Broadband irradiance of sun and sky
- measured_air     Clear air for measured light: how hazy
- measured_clouds  Clouds whose sky carries measured direct and diffuse irradiance
- nearest_clouds   The nearest sky with clouds where none carries what was measured
- doses            What it does to skin and to plants: the UV index, photons
"""

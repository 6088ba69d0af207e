"""What the light of sun and sky carries beside what eyes see.

- weighted         The light of sun and sky on the horizontal, weighted by what each wavelength does
- broadband        Broadband irradiance of sun and sky
- dark_air         Air of less diffuse light: aerosol that absorbs, soot over dark ground
- measured_air     Clear air for measured light: how hazy
- cloud_course     Fields from a few clouds to a dark cover, and what stands before the sun
- cloud_search     The search along them for a diffuse irradiance
- measured_clouds  Clouds whose sky carries measured direct and diffuse irradiance
- nearest_clouds   The nearest sky with clouds where none carries what was measured
- drifting_clouds  The same field through a day of measured light, moved by the wind
- doses            What it does to skin and to plants: the UV index, photons
"""

"""The nine numbers: the extended Perez formula (Hosek and Wilkie 2012, eq. 8), and everything that speaks it.

- perez_formula        The nine numbers: the extended Perez formula from which nearly every analytic sky is made
- perez_table          Perez's table: clearness, brightness, bins and letters
- formula_sky          Skies that are nothing but coefficients of the nine-number formula
- igawa                Igawa's all-sky model: five letters from how bright and how cloudless a sky is
- quantity             From a formula's channels to the light asked for: luminance, XYZ, RGB or a spectrum
- shaped_sky           Skies of a shape of their own, brought to a level
- measured_level       The level of a sky that is made from irradiances, by Perez's efficacies
- level                The absolute level of skies that are known only up to a factor
- sky_tables           Tables of a sky model in Hosek and Wilkie's form
- older/               Older skies that the papers name, each by its own formula
- fast                 The choice between the readable formula and its compiled float32 form
- kernel               The nine numbers in float32, compiled: the fast second form of `perez_formula.evaluate`
- nine_numbers_kernel  The compiled gradation and indicatrix, at one place and in rows
- quantity_kernel      The compiled way from channels to the quantity asked for
"""

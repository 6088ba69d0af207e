"""The command line's own parts: options, doors, printing; the commands are in `commands/`.

- main              The command `skydome`. Commands import what they need when they run, so that help is quick
- options           What the commands ask for, each option written once
- quantities        Quantities as people write them: 20km, 0.5%
- moment            The place, time and sun that the options ask for
- models            The sky models by name, which class, which options it takes, its usual level
- scene             The light that the options ask for: sky, sun's disc, and what was decided for the user
- numbers_of_light  The numbers of a sky, luminance, illuminance and colour temperature
- sums_of_planes    The numbers of a year on planes, sums of each plane, as JSON and as rows for people
- map_file          The file of a map, what the options ask of it, its writing, and what is said of it
- map_order         What one map is to be, with the scene beside it; its making, and what is said of it
- spectral_map      A map of spectra: what it may be asked, its making, and what is said of it
- frames            A sequence of maps: its times, its files' names, the record by which it is taken up again
- doors             Which files may be written, and what is shown on stderr while one waits
- endings           How a command ends: every error becomes one line on stderr and an exit code
- printing          Tables and JSON on stdout
- daylight_matrix   `skydome-mtx tape.wea > sky.mtx`: what `gendaymtx` prints, several times as fast, by NumPy alone
- clouds/           Clouds by the options
- commands/         One command a file
- night/            What the commands say of the night
- many_sites/       Many sites from a table of them, computed by Dask
- learning/         Commands that measure, simulate and learn, one a file
"""

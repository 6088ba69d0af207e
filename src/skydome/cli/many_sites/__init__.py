"""Many sites at once, from a table of them (sites.csv: name,file), computed by Dask.

- table   Whether a file is a table of sites
- years   `skydome year sites.csv`: the years of all of them in one store
- planes  `skydome illuminance --weather sites.csv`: planes at each of them
"""

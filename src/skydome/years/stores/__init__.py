"""A year out: stores and files that appear whole or not at all.

- stores          A Dataset to a Zarr store or a netCDF file that appears whole or not at all
- sites           Many sites, one Zarr store, computed by Dask workers, each site written whole
- sites_store     The Zarr store of many site-years, one chunk a site and variable
- radiance_files  A year for Radiance: daylight matrices, the sky of one hour, lists of suns
- spectral_matrix  A year of spectra for Radiance 6, a daylight matrix of N bands
- cluster         Dask's workers: those of a scheduler, reached within a time limit, or processes of this machine
"""

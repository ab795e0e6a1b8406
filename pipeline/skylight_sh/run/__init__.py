"""Runs: plan, cache, Dask, progress. The only place where all meet."""

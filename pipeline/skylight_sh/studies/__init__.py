"""Studies: what is measured of the pipeline itself, as pages of sections, each a table, a CSV and a picture."""

"""Precomputed transfer (Sloan, Kautz and Snyder 2002): what the vertices of a mesh make of the light around it, in SH."""

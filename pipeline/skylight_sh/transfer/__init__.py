"""Precomputed transfer: what the vertices of a mesh make of the light around it, in SH."""

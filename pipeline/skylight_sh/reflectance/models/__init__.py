"""Analytic reflectance models, a file each; ``reflectance.MODELS`` names them."""

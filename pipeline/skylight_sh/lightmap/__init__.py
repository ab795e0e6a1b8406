"""Baked irradiance: SH of the light that falls on the texels of a lightmap, evaluated with a normal map."""

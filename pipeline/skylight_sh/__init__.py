"""Skylight-SH: parametric lights on the sphere as tiny tables of spherical-harmonics weights."""

__version__ = "0.1.0"

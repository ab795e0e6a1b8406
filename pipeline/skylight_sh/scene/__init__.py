"""Scenes: what a scene wants of a light's weights, folded in before the fit or applied once the sun is turned."""

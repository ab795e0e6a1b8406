"""Fit: axes, bases, solvers, errors, selection. Pure numerics."""

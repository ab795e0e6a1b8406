"""Formulas of an evaluation, each written once: computed with arrays, or traced into programs that any language prints."""

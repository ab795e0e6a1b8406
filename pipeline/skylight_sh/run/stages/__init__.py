"""Stages: thin functions around the numerics, one file a stage."""

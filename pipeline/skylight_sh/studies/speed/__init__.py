"""Benchmarks and stability tests."""

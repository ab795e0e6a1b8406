"""Configs: schema, loading, checks."""

from pipeline.config.loading import ConfigError, load, parse
from pipeline.config.names import table_names, winner_names
from pipeline.config.schema import Config

__all__ = ["Config", "ConfigError", "load", "parse", "table_names", "winner_names"]

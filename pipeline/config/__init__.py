"""Configs: schema, loading, checks."""

from pipeline.config.loading import ConfigError, load, parse
from pipeline.config.names import Wanted, table_names, wanted
from pipeline.config.schema import Config

__all__ = ["Config", "ConfigError", "Wanted", "load", "parse", "table_names", "wanted"]

"""Configs: schema, loading, checks."""

from skylight_sh.config.loading import ConfigError, load, parse
from skylight_sh.config.schema import Config
from skylight_sh.config.wanted import table_names, wanted

__all__ = ["Config", "ConfigError", "load", "parse", "table_names", "wanted"]

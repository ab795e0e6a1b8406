"""Configs: schema, loading, checks."""

from skylight_sh.config.loading import load, parse
from skylight_sh.config.problem import ConfigError
from skylight_sh.config.schema import Config
from skylight_sh.config.wanted import table_names, wanted

__all__ = ["Config", "ConfigError", "load", "parse", "table_names", "wanted"]

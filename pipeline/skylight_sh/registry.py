"""Registries: names, and the places of what stands behind them, which is loaded once it is asked for.

A thing is added by one file and one line: the file holds it, and the registry's line names the file. Whatever takes a name,
the config's schema among them, takes its choices from the registry, and what they are from the files' first lines.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator, Mapping
from importlib import import_module
from importlib.util import find_spec
from typing import Any, Generic, TypeVar

T = TypeVar("T")


class Registry(Mapping[str, T], Generic[T]):
    """Things by name, in the order given, from places such as ``package.module:ATTRIBUTE``.

    Only a look-up imports a module, so that names cost nothing. Raises KeyError, telling the known ones, for another name.

    >>> constants = Registry({"pi": "math:pi", "tau": "math:tau"})
    >>> list(constants), "e" in constants, round(constants["tau"], 3)
    (['pi', 'tau'], False, 6.283)
    >>> list(constants | Registry({"e": "math:e"})), constants.beside("inf")["pi"]
    (['pi', 'tau', 'e'], inf)
    """

    def __init__(self, places: Mapping[str, str]) -> None:
        self._places = dict(places)

    def __getitem__(self, name: str) -> T:
        if name not in self._places:
            raise KeyError(f"{name!r} is none of {', '.join(self._places)}")
        module, _, attribute = self._places[name].partition(":")
        found: T = getattr(import_module(module), attribute)
        return found

    def __iter__(self) -> Iterator[str]:
        return iter(self._places)

    def __len__(self) -> int:
        return len(self._places)

    def __contains__(self, name: object) -> bool:
        return name in self._places

    def __or__(self, other: Registry[T]) -> Registry[T]:
        return Registry({**self._places, **other._places})

    def beside(self, attribute: str) -> Registry[Any]:
        """Return what the modules of the same names hold as another ``attribute``."""
        return Registry({name: f"{place.partition(':')[0]}:{attribute}" for name, place in self._places.items()})

    def about(self, name: str) -> str:
        """Return the first line of the text that opens the module of ``name``, without its full stop; nothing is run."""
        module = self._places[name].partition(":")[0]
        spec = find_spec(module)
        source = getattr(spec.loader, "get_source", lambda _: None)(module) if spec else None
        text = ast.get_docstring(ast.parse(source)) if source else import_module(module).__doc__
        return (text or "").partition("\n")[0].removesuffix(".")

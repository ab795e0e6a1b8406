"""Types of a config's keys whose values are names in a registry: what is allowed, and what each name means."""

from __future__ import annotations

import ast
import inspect
import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache, reduce
from itertools import pairwise
from operator import or_
from textwrap import dedent
from typing import Annotated, Any

from pydantic import Field, GetCoreSchemaHandler, GetJsonSchemaHandler, TypeAdapter
from pydantic_core import CoreSchema, PydanticCustomError, core_schema

from skylight_sh.registry import Registry


@dataclass(frozen=True)
class OneOf:
    """In ``Annotated[str, OneOf(names, "what it is")]``: a name of ``names``, or one of ``others`` (name to meaning).

    What a registry's names mean is told by the registry, and read where a schema is asked for.
    """

    names: Mapping[str, object]
    about: str
    others: tuple[tuple[str, str], ...] = ()

    def __get_pydantic_core_schema__(self, _: object, __: GetCoreSchemaHandler) -> CoreSchema:
        return core_schema.literal_schema([*(name for name, _ in self.others), *self.names])

    def __get_pydantic_json_schema__(self, schema: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        return {**handler(schema), "description": f"{self.about}, one of {described(self.names, self.others)}"}


@dataclass(frozen=True)
class AnyOf:
    """In ``Annotated[T, AnyOf(types, "model", "what it is")]``: one of the ``types``, told apart by their key ``tag``.

    Only the type that a value names is loaded.
    """

    types: Mapping[str, Any]
    tag: str
    about: str

    def __get_pydantic_core_schema__(self, _: object, __: GetCoreSchemaHandler) -> CoreSchema:
        dump = core_schema.plain_serializer_function_ser_schema(_dump, info_arg=True)
        return core_schema.no_info_plain_validator_function(self._make, serialization=dump)

    def __get_pydantic_json_schema__(self, _: CoreSchema, handler: GetJsonSchemaHandler) -> dict[str, Any]:
        union: Any = reduce(or_, self.types.values())
        types: TypeAdapter[Any] = TypeAdapter(Annotated[union, Field(discriminator=self.tag)])
        about = f"{self.about}: {self.tag} = {', '.join(self.types)}, and that one's options"
        found = handler(types.core_schema)
        for branch, kind in zip(found["oneOf"], self.types.values(), strict=True):
            keys = handler.resolve_ref_schema(branch)["properties"]
            for name, text in _said_of_fields(kind).items():
                keys[name]["description"] = text
        return {**found, "description": about}

    def _make(self, value: object) -> object:
        name = value.get(self.tag) if isinstance(value, dict) else None
        if name is None:
            raise PydanticCustomError("union_tag_not_found", f"Input should be a table with the key '{self.tag}'")
        if name not in self.types:
            known = ", ".join(f"'{known}'" for known in self.types)
            told = f"Input tag '{name}' found using '{self.tag}' does not match any of the expected tags: {known}"
            raise PydanticCustomError("union_tag_invalid", "{told}", {"told": told})
        # JSON mode is strict about types but takes arrays for tuples; what is wrong inside keeps its place.
        return _adapter(self.types[name]).validate_json(json.dumps(value))


@lru_cache(maxsize=32)
def _adapter(kind: type) -> TypeAdapter[Any]:
    return TypeAdapter(kind)


def _dump(value: object, info: core_schema.SerializationInfo) -> object:
    kind: Any = type(value)
    return _adapter(kind).dump_python(value, mode="json" if info.mode_is_json() else "python")


def _said_of_fields(kind: type) -> dict[str, str]:
    """Return the texts that stand below the fields of a class, by name."""
    (body,) = (node.body for node in ast.parse(dedent(inspect.getsource(kind))).body if isinstance(node, ast.ClassDef))
    return {
        field.target.id: inspect.cleandoc(text.value.value)
        for field, text in pairwise(body)
        if isinstance(field, ast.AnnAssign)
        and isinstance(field.target, ast.Name)
        and isinstance(text, ast.Expr)
        and isinstance(text.value, ast.Constant)
        and isinstance(text.value.value, str)
    }


def described(names: Mapping[str, object], others: tuple[tuple[str, str], ...] = ()) -> str:
    """Return ``name: meaning; name: meaning``; a name alone where nothing tells what it means."""
    told = [*others, *((name, _meaning(names, name)) for name in names)]
    return "; ".join(f"{name}: {meaning}" if meaning else name for name, meaning in told)


def _meaning(names: Mapping[str, object], name: str) -> str:
    if isinstance(names, Registry):
        return names.about(name)
    entry = names[name]
    if isinstance(entry, str):
        return entry
    text = getattr(entry, "about", (entry.__doc__ or "") if callable(entry) else "")
    return str(text).partition("\n")[0].removesuffix(".")

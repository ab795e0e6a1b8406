"""A static class of C#, for Unity and .NET."""

from __future__ import annotations

from skylight_sh.export import csharp
from skylight_sh.export.target import Target

TARGET = Target(lambda table, facts, prefix: {"skylight_sh.cs": csharp.write(table, facts, prefix).encode()})

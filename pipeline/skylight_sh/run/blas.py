"""One thread for the linear algebra: the order of its sums, and so the last bits, would hang on how many there are."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from threadpoolctl import threadpool_limits


def one_thread() -> threadpool_limits:
    """Limit every BLAS to one thread, from now on, or within a ``with`` block.

    A limit reaches only what is loaded, and SciPy, which has a BLAS of its own, is imported late by what needs it: so it is
    loaded first.
    """
    from threadpoolctl import threadpool_limits

    import_module("scipy.linalg")
    return threadpool_limits(1)

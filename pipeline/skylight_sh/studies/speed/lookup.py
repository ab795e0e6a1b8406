"""The paper's "naive tabulation": weights on a regular grid of the axes, interpolated, as a header with the tables' API."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from skylight_sh.fit.axis import Axis

Array = NDArray[np.float64]

POINTS = {"linear": 2, "cubic": 4}

_HEADER = """\
#include <math.h>
#include <string.h>
#define BENCH_SH_BANDS {bands}
#define BENCH_SH_WEIGHTS {weights}
#define BENCH_SH_CHANNELS {channels}
static const float bench_sh_grid[] = {{ {numbers} }};
static const float bench_sh_low[] = {{ {low} }};
static const float bench_sh_step[] = {{ {step} }};
static const int bench_sh_size[] = {{ {size} }};
static inline int bench_sh_weights({parameters}, float weights[{channels}][{weights}])
{{
    float at[{axes}], part[{axes}][{points}], sum[{outputs}], wave_cos[{bands}], wave_sin[{bands}];
    int first[{axes}], axis, i, k, l, m, channel, corner;
    {inputs}
    for (axis = 0; axis < {axes}; ++axis) {{
        float x = (at[axis] - bench_sh_low[axis]) * bench_sh_step[axis], t;
        const int last = bench_sh_size[axis] - {points};
        int start;
        if (x < 0.0f) x = 0.0f;
        if (x > (float)(bench_sh_size[axis] - 1)) x = (float)(bench_sh_size[axis] - 1);
        start = (int)x - {before};
        if (start < 0) start = 0;
        if (start > last) start = last;
        first[axis] = start;
        t = x - (float)start;
        {stencil}
    }}
    memset(sum, 0, sizeof sum);
    for (corner = 0; corner < {corners}; ++corner) {{
        float w = 1.0f;
        int place = 0, rest = corner;
        for (axis = 0; axis < {axes}; ++axis) {{
            k = rest % {points};
            rest /= {points};
            w *= part[axis][k];
            place = place * bench_sh_size[axis] + first[axis] + k;
        }}
        for (i = 0; i < {outputs}; ++i) sum[i] += w * bench_sh_grid[place * {outputs} + i];
    }}
    wave_cos[0] = 1.0f; wave_sin[0] = 0.0f;
    if ({bands} > 1) {{ wave_cos[1] = cosf(sun_azimuth); wave_sin[1] = sinf(sun_azimuth); }}
    for (m = 2; m < {bands}; ++m) {{
        wave_cos[m] = wave_cos[m - 1] * wave_cos[1] - wave_sin[m - 1] * wave_sin[1];
        wave_sin[m] = wave_sin[m - 1] * wave_cos[1] + wave_cos[m - 1] * wave_sin[1];
    }}
    for (channel = 0, i = 0; channel < {channels}; ++channel)
        for (l = 0; l < {bands}; ++l)
            for (m = 0; m <= l; ++m, ++i) {{
                weights[channel][l * (l + 1) - m] = sum[i] * wave_sin[m];
                weights[channel][l * (l + 1) + m] = sum[i] * wave_cos[m];
            }}
    return 0;
}}
"""
# Weights of the grid points that t, counted from the first of them, lies among.
_STENCILS = {
    "linear": "part[axis][0] = 1.0f - t; part[axis][1] = t;",
    "cubic": "{ const float a = t, b = t - 1.0f, c = t - 2.0f, d = t - 3.0f; part[axis][0] = b * c * d / -6.0f; "
    "part[axis][1] = a * c * d / 2.0f; part[axis][2] = a * b * d / -2.0f; part[axis][3] = a * b * c / 6.0f; }",
}


def header(axes: Sequence[Axis], sizes: Sequence[int], values: Array, bands: int, kind: str) -> str:
    """Return C for ``values`` ``(n_1, .., n_D, channels, count)`` on evenly spaced nodes of the axes, m >= 0 alone.

    ``kind`` is ``linear`` or ``cubic`` (four-point Lagrange); azimuth turns as in the tables' own headers.
    """
    channels, count = values.shape[-2:]
    names = [axis.name for axis in axes]
    points = POINTS[kind]
    return _HEADER.format(
        bands=bands,
        weights=bands * bands,
        channels=channels,
        outputs=channels * count,
        numbers=", ".join(f"{float(v):.9e}f" for v in values.astype(np.float32).ravel()),
        low=", ".join(f"{axis.low:.9e}f" for axis in axes),
        step=", ".join(f"{(n - 1) / (axis.high - axis.low):.9e}f" for axis, n in zip(axes, sizes, strict=True)),
        size=", ".join(map(str, sizes)),
        parameters=", ".join(f"float {name}" for name in (names[0], "sun_azimuth", *names[1:])),
        inputs=" ".join(f"at[{i}] = {name};" for i, name in enumerate(names)),
        axes=len(names),
        points=points,
        corners=points ** len(names),
        before=points // 2 - 1,
        stencil=_STENCILS[kind],
    )

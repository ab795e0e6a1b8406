"""What the 2008 paper's error may be made of."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from skylight_sh.report import style
from skylight_sh.report.figures.picture import Picture
from skylight_sh.report.origins import QUOTED, RELEASED
from skylight_sh.report.report_data import ReportData

SEE = "Bars below the dashed line do better than the paper quotes; where blue and red part, samples mislead their author."
CAPTION = (
    "The paper's scheme on this run's grid. Top: the same converged weights fitted by raw monomials with three solvers, "
    "kept in double and in single precision; what the normal equations leave is rounding noise, this machine's: another "
    "CPU's bar may differ by most of itself. Middle: the scheme fitted (by SVD) to stratified Monte Carlo weights instead "
    "of converged ones; its distance from its own samples, which is what an author without a converged truth can see, and "
    "from the truth. Bottom: what so few samples leave behind: weights of orders m < 0, which symmetry makes zero, and the "
    "distance from the truth, as shares of a set's norm (medians); dotted, the authors' released table."
)
_SOLVERS = {"svd": "SVD", "qr": "QR", "normal": "normal equations\n(this machine's)"}


def draw(data: ReportData) -> Figure | None:
    """Draw solvers, samples and symmetry below each other; None where the run did not ask for it."""
    found = data.origins
    if found is None:
        return None
    figure = style.figure(style.WIDTH, 11.5)
    top, middle, bottom = figure.subplots(3, 1)
    x = np.arange(len(found["solver"]))
    for i, name in enumerate(("float64", "float32")):
        top.bar(x + 0.38 * (i - 0.5), found["solver_e_mean"][:, i], 0.36, color=style.SERIES[i], label=name)
    top.set_yscale("log")
    top.set_xticks(x, [_SOLVERS.get(str(s), str(s)) for s in found["solver"]])
    top.set_title("E_mean of converged weights, raw monomials", fontsize=11)
    samples = found["samples"]
    middle.loglog(samples, found["own"], label="from its own samples", **style.look(0))
    middle.loglog(samples, found["truth"], label="from the truth", **style.look(1))
    middle.set_title("E_mean of undersampled weights, by SVD", fontsize=11)
    for i, (key, label) in enumerate((("m_below_0", "orders m < 0"), ("rel_l2", "distance from the truth"))):
        look = style.look(i)
        bottom.loglog(samples, found[key], label=label, **look)
        bottom.axhline(RELEASED[key], linestyle=":", color=look["color"])
    bottom.set_title("what undersampling leaves, of a set's norm", fontsize=11)
    for panel in (top, middle):
        panel.axhline(QUOTED, linestyle="--", color=style.BLACK, linewidth=1, label="the paper's 1.5 %")
        panel.axhline(data.best.headline[0], linestyle="-.", color=style.GREEN, label=data.best.name)
    for panel in (middle, bottom):
        panel.set_xlabel("samples a parameter set")
        panel.set_xticks(samples, [f"{s:,}" for s in samples])
        panel.set_xticks([], minor=True)
    for panel in (top, middle, bottom):
        panel.yaxis.set_major_formatter(style.percent_ticks())
        style.steps(panel.yaxis)
        panel.grid(True, which="major", alpha=0.3)
        panel.legend(fontsize=11, loc="upper center", bbox_to_anchor=(0.5, -0.2), ncols=2, frameon=False)
    return figure


PICTURE = Picture("The 2008 result explained", CAPTION, draw, see=SEE)

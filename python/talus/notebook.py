"""How results show in a notebook: a table of figures, and a picture if matplotlib is there."""

from __future__ import annotations

import base64
from html import escape
import io
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .results import Results


def html_of(result: Results) -> str:
    summary = result.summary
    rows = [("rocks", f"{result.rocks_done} of {result.rocks}")]
    rows += [(f"ended: {reason}", f"{count}") for reason, count in summary["end_reasons"].items()]
    for key, label, scale, unit in (("runout_xy_m", "runout on plan", 1, "m"), ("max_ke_J", "maximum energy", 1000, "kJ"),
                                    ("max_bounce_m", "maximum bounce height", 1, "m")):
        figures = summary["statistics"][key]
        if figures["count"] > 0:
            mean, high = figures["mean"] / scale, figures["percentiles"]["95"] / scale
            rows.append((label, f"mean {mean:.3g} {unit}, 95 % below {high:.3g} {unit}"))
    rows += [(f"hits on {barrier['name']}", f"{barrier['hits']}") for barrier in summary["barriers"]]
    table = "".join(f"<tr><td>{escape(label)}</td><td>{escape(text)}</td></tr>" for label, text in rows)
    warnings = "".join(f"<p>{escape(text)}</p>" for text in result.warnings)
    return f"<b>{escape(result.name)}</b>{_picture(result)}<table>{table}</table>{warnings}"


def _picture(result: Results) -> str:
    try:
        from matplotlib.backends.backend_agg import FigureCanvasAgg
        from matplotlib.figure import Figure
    except ImportError:
        return ""
    from . import plots

    figure = Figure(figsize=(6, 3.5), layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    if result.summary["terrain"]["kind"] == "section":
        plots.section(result, axes=axes)
    else:
        plots.plan(result, axes=axes)
    picture = io.BytesIO()
    figure.savefig(picture, format="png", dpi=100)
    data = base64.b64encode(picture.getvalue()).decode()
    return f'<br><img alt="{escape(result.name)}" src="data:image/png;base64,{data}">'

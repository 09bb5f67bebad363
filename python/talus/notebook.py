"""How results show in a notebook: a table of figures, and a picture if matplotlib is there."""

from __future__ import annotations

import base64
from html import escape
import io
from typing import TYPE_CHECKING

from .texts import value_text

if TYPE_CHECKING:
    from .results import Results

# Of the end points: the quantity, what it is, and the figure in which it is shown, with its unit.
main_statistics = (("runout_xy_m", "runout on plan", "runout_m", 1), ("max_ke_J", "maximum energy", "energy_kJ", 1000),
                   ("max_bounce_m", "maximum bounce height", "height_m", 1))


def html_of(result: Results) -> str:
    summary = result.summary
    rows = [("rocks", f"{result.rocks_done} of {result.rocks}")]
    rows += [(f"ended: {reason}", f"{count}") for reason, count in summary["end_reasons"].items()]
    for key, label, figure, scale in main_statistics:
        figures = summary["statistics"][key]
        if figures["count"] > 0:
            mean, high = (value_text(figure, each / scale) for each in (figures["mean"], figures["percentiles"]["95"]))
            rows.append((label, f"mean {mean}, 95 % below {high}"))
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
    figure = Figure(figsize=(6, 3.5), layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    result.plot(axes=axes)
    picture = io.BytesIO()
    figure.savefig(picture, format="png", dpi=100)
    data = base64.b64encode(picture.getvalue()).decode()
    return f'<br><img alt="{escape(result.name)}" src="data:image/png;base64,{data}">'

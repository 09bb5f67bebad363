"""Figures with matplotlib. Each function draws into ``axes``, or into a new figure, and returns the axes."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

import numpy as np

from .problems import BadInput
from .results import Results, columns
from .spoken import meant
from .texts import count_text, model_name, unit_of, value_text

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .answers import LineAnswer, PolygonAnswer
    from .comparison import Comparison
    from .maps import Map
    from .variations import Variation, WhatIf

__all__ = ["barrier_curves", "changes", "distributions", "histogram", "map", "plan", "profile", "section", "sources"]

# The colours of the report (report/page/style.css).
_path = {"color": "#1f5fa8", "linewidth": 0.6, "alpha": 0.5}
_ground = "#6d5f4b"
_barrier = {"color": "#7a1fa2", "linewidth": 2}
_more = "#c4161c"


def section(result: Results, *, rocks: int = 50, axes: Axes | None = None) -> Axes:
    """The slope of a section, the trajectories of some rocks, and the barriers."""
    terrain = result.summary["terrain"]
    if terrain["kind"] != "section":
        raise BadInput("this run is not one of a section. plots.plan shows runs in 3D")
    axes = _axes(axes)
    vertices = np.array(terrain["section"])
    axes.plot(vertices[:, 0], vertices[:, 1], color=_ground, linewidth=1.5)
    for path in _paths(result, rocks):
        axes.plot(path[:, 0], path[:, 2], **_path)
    for barrier, (height, inclination) in zip(result.summary["barriers"], _faces(result)):
        x, _, z = barrier["line_xyz"][0]
        axes.plot([x, x + height * np.sin(inclination)], [z, z + height * np.cos(inclination)], **_barrier)
    axes.set(xlabel="x [m]", ylabel="z [m]", aspect="equal", title=result.name)
    return axes


def plan(result: Results, *, rocks: int = 100, axes: Axes | None = None) -> Axes:
    """The terrain around the rocks from above as a hillshade, the trajectories of some, end points and barriers."""
    if result.summary["terrain"]["kind"] == "section":
        raise BadInput("this run is one of a section, which has no plan. plots.section shows it")
    axes = _axes(axes)
    paths = [path[:, :2] for path in _paths(result, rocks)]
    feet = _feet(result)
    ends = np.stack([result.end_points["x_m"], result.end_points["y_m"]], axis=1)
    _terrain(result, axes, np.concatenate([ends, *paths, *feet]))
    for path in paths:
        axes.plot(*path.T, **_path)
    axes.plot(*ends.T, ".", color="black", markersize=1.5)
    for foot in feet:
        axes.plot(*foot.T, **_barrier)
    return axes


def map(result: Results, name: str, *, axes: Axes | None = None, **options: Any) -> Axes:  # noqa: A001
    """A map of the run in its classes, over the hillshade, with the barriers. Shares are in percent. ``options`` go to
    imshow: ``cmap``, ``norm``, ``vmin`` or ``vmax`` replace the classes."""
    values = result.maps[name]
    axes = _axes(axes)
    west, east, south, north = values.extent
    _terrain(result, axes, np.array([[west, south], [east, north]]))
    unit, per = ("%", 0.01) if values.dtype.kind == "f" and not values.unit else (values.unit, 1)
    own_colours = not {"cmap", "norm", "vmin", "vmax"}.isdisjoint(options)
    colours = {"cmap": "inferno_r"} if own_colours else _classes(values)
    image = axes.imshow(values, extent=values.extent, **{"alpha": 0.84, "interpolation": "nearest", **colours, **options})
    for foot in _feet(result):
        axes.plot(*foot.T, **_barrier)
    bar = axes.figure.colorbar(image, ax=axes, label=f"{_titled(values.meaning)} [{unit}]" if unit else _titled(values.meaning),
                               shrink=0.8)
    if own_colours:
        bar.ax.yaxis.set_major_formatter(lambda value, _: f"{value / per:,g}")
    else:
        bar.set_ticks([0, *values.limits], labels=[f"{limit / per:,g}" for limit in (0, *values.limits)])
    return axes


def histogram(result: Results, column: str, *, table: str = "end_points", bins: int = 40,
              axes: Axes | None = None) -> Axes:
    """The distribution of a column of a table."""
    values, title = _numbers(result, column, table)
    axes = _axes(axes)
    axes.hist(values, bins=bins, color=_path["color"])
    axes.set(xlabel=title, title=result.name, ylabel=_counted.get(table, "rows"))
    return axes


def _numbers(result: Results, column: str, table: str) -> tuple[np.ndarray, str]:
    """The known values of a column in the unit in which engineers read it, and what they are."""
    known = {each.name: each for each in columns(table)}
    rows = getattr(result, table)
    numeric = [name for name in rows.dtype.names if name not in known or rows.dtype[name].kind != "U"]
    if column not in numeric:
        why = "it has words" if column in known else f"its columns of numbers are {', '.join(numeric)}"
        raise BadInput(f"{table} has no column of numbers {column!r} ({why}){meant(column, numeric)}")
    values = rows[column]
    values = values[values != -1] if values.dtype.kind == "i" else values[np.isfinite(values)]
    meaning, unit = (known[column].meaning, known[column].unit) if column in known else (column, "")
    unit, per = _shown(unit)
    meaning = re.split("[;:]", re.sub("^with `[^`]*`: ", "", meaning))[0].replace("`", "")  # without its condition
    return values / per, f"{meaning} [{unit}]" if unit else meaning


def barrier_curves(result: Results, barrier: str, *, axes: Axes | None = None) -> Axes:
    """The share of the hits on a barrier or collector below each energy and each height of the block's top: what a barrier
    there must be."""
    hits = result.barrier_hits
    hits = hits[hits["barrier"] == barrier]
    if len(hits) == 0:
        names = [each["name"] for each in result.summary["barriers"]]
        if barrier in names:
            raise BadInput(f"no rock arrives at {barrier!r}")
        raise BadInput(f"there is no barrier {barrier!r} (there are {', '.join(names) or 'none'}){meant(barrier, names)}")
    axes = _axes(axes)
    share = 100 * np.arange(1, len(hits) + 1) / len(hits)
    axes.step(np.sort(hits["ke_total_J"]) / 1000, share, where="post", color=_path["color"], label="energy")
    axes.set(xlabel="total kinetic energy [kJ]", ylabel="share of hits below [%]", xlim=(0, None), ylim=(0, 100),
             title=barrier)
    above = axes.twiny()
    above.step(np.sort(hits["top_height_m"]), share, where="post", color=_barrier["color"])
    above.set_xlim(0, 1.05 * hits["top_height_m"].max())
    above.set_xlabel("height of the block's top [m]", color=_barrier["color"])
    above.tick_params(axis="x", colors=_barrier["color"])
    axes.axhline(95, color="grey", linewidth=0.5, linestyle=":")
    axes.xaxis.label.set_color(_path["color"])
    return axes


def profile(answer: LineAnswer, figure: str = "energy", *, axes: Axes | None = None) -> Axes:
    """``"energy"``, ``"height"`` or ``"velocity"`` along a line, stretch by stretch, with its intervals."""
    titles = {"energy": (f"{answer.energy_kind} energy", "kJ", "kJ"), "height": ("height of the block's top", "m", "m"),
              "velocity": ("velocity", "m_s", "m/s")}
    if figure not in titles:
        raise BadInput(f"figure={figure!r}: expected {', '.join(titles)}{meant(figure, titles)}")
    title, ending, unit = titles[figure]
    rows = answer.profile
    if len(rows) == 0:
        raise BadInput("the line has no stretches: in a section it is a place")
    axes = _axes(axes)
    middle, half = (rows["from_m"] + rows["to_m"]) / 2, (rows["to_m"] - rows["from_m"]) / 2
    value, low, high = (rows[f"{figure}{end}_{ending}"] for end in ("", "_low", "_high"))
    axes.bar(middle, np.nan_to_num(value), width=2 * half, color=_path["color"], alpha=0.35, edgecolor="white")
    spread = [np.nan_to_num(value - low), np.nan_to_num(high - value)]
    known = np.isfinite(value)
    axes.errorbar(middle[known], value[known], yerr=[each[known] for each in spread], fmt="_", color=_path["color"],
                  capsize=3)
    axes.set(xlabel="along the line [m]", ylabel=f"{title}, {answer.percentile:g} % [{unit}]", ylim=(0, None),
             title=f"{answer.crossing} of {answer.rocks} rocks cross")
    return axes


def changes(what_if: WhatIf, figure: str = "energy_kJ", *, axes: Axes | None = None) -> Axes:
    """How a figure changes with each factor and with each other rock model, what moves it most on top: ``"share"``,
    ``"energy_kJ"`` (which the check takes), ``"energy_translational_kJ"``, ``"energy_total_kJ"``, ``"height_m"`` or
    ``"velocity_m_s"``."""
    titles = {"share": "share of the rocks", "energy_kJ": f"{what_if.energy_kind} energy",
              "energy_translational_kJ": "translational energy", "energy_total_kJ": "total energy", "height_m": "height",
              "velocity_m_s": "velocity"}
    if figure not in titles:
        raise BadInput(f"figure={figure!r}: expected {', '.join(titles)}{meant(figure, titles)}")
    top, unit = "" if figure == "share" else f"{what_if.percentile:g} % ", unit_of(figure)
    per = 0.01 if unit == "%" else 1
    size: dict[str, float] = {}
    for each in what_if.variations:
        change = abs(getattr(each.change, figure).value)
        size[_row(each)] = max(size.get(_row(each), 0), change if np.isfinite(change) else 0)
    order = sorted(size, key=size.__getitem__)
    axes = _axes(axes)
    for each in what_if.variations:
        value, low, high = (number / per for number in getattr(each.change, figure))
        step = each.step or 0
        place = order.index(_row(each)) + 0.2 * np.sign(step)
        colour = _barrier["color"] if each.step is None else _more if step > 0 else _path["color"]
        axes.barh(place, np.nan_to_num(value), height=0.35, color=colour, alpha=0.5)
        axes.plot([low, high], [place, place], color=colour, linewidth=1)
        label = "none crosses" if not np.isfinite(value) else f"{100 * step:+g} %" if step else ""
        ends = [0, *(end for end in (low, high) if np.isfinite(end))]  # beside the interval
        beside, aside = (max(ends), "left") if value < 0 else (min(ends), "right")
        axes.annotate(label, (beside, place), xytext=(3 if value < 0 else -3, 0), textcoords="offset points",
                      ha=aside, va="center", fontsize=7)
    axes.axvline(0, color="black", linewidth=0.8)
    axes.set_yticks(range(len(order)), order)
    own = value_text(figure, getattr(what_if.base, figure).value)
    axes.set(xlabel=f"change of the {top}{titles[figure]} [{'% points' if unit == '%' else unit}]",
             title=f"own values: {own}, rock model {model_name(what_if.model)}")
    return axes


def _row(variation: Variation) -> str:
    return f"model: {variation.name}" if variation.step is None else variation.factor.replace("_", " ")


def sources(answer: LineAnswer | PolygonAnswer, *, axes: Axes | None = None) -> Axes:
    """The places of release on plan from which rocks get to a line or into a polygon, by the share of their own rocks that
    do."""
    rows = answer.sources
    axes = _axes(axes)
    outline = answer.foot if hasattr(answer, "foot") else np.concatenate([answer.outline, answer.outline[:1]])
    axes.plot(*outline[:, :2].T, **_barrier, marker="o" if len(outline) == 1 else None)
    points = axes.scatter(rows["x_m"], rows["y_m"], c=100 * rows["share"], s=9, cmap="inferno_r", vmin=0, vmax=100)
    axes.figure.colorbar(points, ax=axes, label="share of a place's rocks [%]", shrink=0.8)
    axes.ticklabel_format(useOffset=False, style="plain")
    axes.locator_params(axis="x", nbins=5)
    axes.set(xlabel="x [m]", ylabel="y [m]", aspect="equal", title=f"{count_text(len(rows), 'place')} of release")
    return axes


def distributions(both: Comparison, column: str = "runout_xy_m", *, axes: Axes | None = None) -> Axes:
    """The share of the rocks of two runs that are at or below each value of a column of the end points."""
    axes = _axes(axes)
    for result, label, style in ((both.first, "first", {"color": _path["color"]}),
                                 (both.second, "second", {"color": _more, "linestyle": "--"})):
        values, title = _numbers(result, column, "end_points")
        share = 100 * np.arange(1, len(values) + 1) / max(len(values), 1)
        axes.step(np.sort(values), share, where="post", **style, label=f"{label}, {count_text(len(values), 'rock')}")
    axes.set(xlabel=title, ylabel="share of the rocks at or below [%]", ylim=(0, 100))
    axes.legend()
    return axes


def _axes(axes: Axes | None) -> Axes:
    if axes is not None:
        return axes
    from matplotlib import pyplot

    return pyplot.subplots(layout="constrained")[1]


_counted = {"end_points": "rocks", "barrier_hits": "hits", "impacts": "impacts", "events": "events"}


def _shown(unit: str) -> tuple[str, float]:
    """The unit in which engineers read it, and what it is of the given one."""
    return ("kJ", 1000) if unit == "J" else (unit, 1)


def _titled(meaning: str) -> str:
    """What a map shows, as the report says it."""
    words = re.sub(": percentile ([0-9.]+) of the rocks", r", \1 %", meaning)
    words = re.sub(": (maximum|mean) over (all|the) rocks", r", \1", words)
    return words[:1].upper() + words[1:]


def _feet(result: Results) -> list[np.ndarray]:
    """The feet of the barriers and collectors on plan, (n, 2) [m]."""
    return [np.array(barrier["line_xyz"])[:, :2] for barrier in result.summary["barriers"]]


def _classes(values: Map) -> dict[str, Any]:
    """Options of imshow for the classes of a map."""
    from matplotlib.colors import BoundaryNorm, ListedColormap

    colours = [each.colour for each in values.classes]
    return {"cmap": ListedColormap(colours), "norm": BoundaryNorm([0, *values.limits], len(colours), extend="max")}


def _paths(result: Results, rocks: int) -> list[np.ndarray]:
    """Points along the trajectories of some rocks, evenly chosen: (n, 3) [m]."""
    events = result.events
    if len(events) == 0:
        return []
    firsts = np.flatnonzero(np.diff(events["rock"], prepend=events["rock"][:1] + 1))
    paths = np.split(events, firsts[1:])
    chosen = np.unique(np.linspace(0, len(paths) - 1, min(rocks, len(paths))).astype(int))
    return [_curve(paths[k]) for k in chosen]


def _curve(events: np.ndarray, points: int = 12) -> np.ndarray:
    """Between two events the cubic that has their positions and velocities: of a flight without drag the parabola."""
    place, velocity = (np.stack([events[name] for name in names], axis=1)
                       for names in (("x_m", "y_m", "z_m"), ("vx_m_s", "vy_m_s", "vz_m_s")))
    duration = np.diff(events["time_s"])[:, np.newaxis, np.newaxis]
    s = np.linspace(0, 1, points)[np.newaxis, :, np.newaxis]
    p0, p1, v0, v1 = (each[:, np.newaxis, :] for each in (place[:-1], place[1:], velocity[:-1], velocity[1:]))
    curve = ((2 * s**3 - 3 * s**2 + 1) * p0 + (s**3 - 2 * s**2 + s) * duration * v0 + (3 * s**2 - 2 * s**3) * p1
             + (s**3 - s**2) * duration * v1)
    return curve.reshape(-1, 3)


def _faces(result: Results) -> list[tuple[float, float]]:
    """Height [m] and inclination [rad] of each barrier and collector, in the order of the summary."""
    project = result.summary["project"]
    rows = project.get("barrier", []) + project.get("collector", [])
    return [(row["height_m"], np.radians(row.get("inclination_deg", 0))) for row in rows]


def _terrain(result: Results, axes: Axes, places: np.ndarray) -> None:
    """Shows the surroundings of places, (n, 2) [m], with the hillshade if the results have their terrain."""
    axes.set(xlabel="x [m]", ylabel="y [m]", aspect="equal", title=result.name)
    axes.ticklabel_format(useOffset=False, style="plain")
    axes.locator_params(axis="x", nbins=5)
    places = places[np.isfinite(places).all(axis=1)]
    if len(places) == 0:
        return
    low, high = places.min(axis=0), places.max(axis=0)
    margin = max(0.15 * (high - low).max(), 5)
    low, high = low - margin, high + margin
    if result.surface is not None:
        west, east, south, north, _, _ = result.surface.bounds
        low, high = np.maximum(low, (west, south)), np.minimum(high, (east, north))
        _hillshade(result, axes, low, high)
    # Pictures that are drawn later do not change the limits that are set.
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]))


def _hillshade(result: Results, axes: Axes, low: np.ndarray, high: np.ndarray) -> None:
    """As in the report: lit from the north-west at 45 degrees, in light greys."""
    if not (high > low).all():
        return
    cell = (high - low).max() / 400
    x, y = np.arange(low[0] + cell / 2, high[0], cell), np.arange(high[1] - cell / 2, low[1], -cell)
    if len(x) < 2 or len(y) < 2:
        return
    z = np.ma.masked_invalid(result.surface.elevation(x[np.newaxis, :], y[:, np.newaxis]))
    south, east = np.nan_to_num(np.gradient(z.filled(np.nan), cell))  # at holes: level
    lit = (0.5 * east + 0.5 * south + np.sqrt(0.5)) / np.sqrt(east**2 + south**2 + 1)
    axes.imshow(np.ma.array(150 + 100 * np.clip(lit, 0, 1), mask=z.mask),
                extent=(low[0], low[0] + cell * len(x), high[1] - cell * len(y), high[1]), cmap="gray", vmin=0, vmax=255)

"""Figures with matplotlib. Each function draws into ``axes``, or into a new figure, and returns the axes."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING, Any

import numpy as np

from .problems import BadInput
from .results import Results, columns

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["barrier_curves", "histogram", "map", "plan", "section"]

_path = {"color": "#1f5f8b", "linewidth": 0.6, "alpha": 0.5}
_ground = "#6b5b4b"
_barrier = {"color": "#b3261e", "linewidth": 2}


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
    axes = _axes(axes)
    paths = [path[:, :2] for path in _paths(result, rocks)]
    feet = [np.array(barrier["line_xyz"])[:, :2] for barrier in result.summary["barriers"]]
    ends = np.stack([result.end_points["x_m"], result.end_points["y_m"]], axis=1)
    _terrain(result, axes, np.concatenate([ends, *paths, *feet]))
    for path in paths:
        axes.plot(*path.T, **_path)
    axes.plot(*ends.T, ".", color="black", markersize=1.5)
    for foot in feet:
        axes.plot(*foot.T, **_barrier)
    return axes


def map(result: Results, name: str, *, axes: Axes | None = None, **options: Any) -> Axes:  # noqa: A001
    """A map of the run with its scale, over the hillshade. ``options`` go to imshow."""
    axes = _axes(axes)
    values = result.maps[name]
    west, east, south, north = values.extent
    _terrain(result, axes, np.array([[west, south], [east, north]]))
    image = axes.imshow(values, extent=values.extent, **{"cmap": "inferno_r", "alpha": 0.8, **options})
    axes.figure.colorbar(image, ax=axes, label=f"{values.meaning} [{values.unit or '-'}]", shrink=0.8)
    return axes


def histogram(result: Results, column: str, *, table: str = "end_points", bins: int = 40,
              axes: Axes | None = None) -> Axes:
    """The distribution of a column of a table."""
    found = next((each for each in columns(table) if each.name == column), None)
    if found is None or getattr(result, table)[column].dtype.kind == "U":
        raise BadInput(f"{table} has no column of numbers {column!r}")
    axes = _axes(axes)
    values = getattr(result, table)[column]
    values = values[values != -1] if values.dtype.kind == "i" else values[np.isfinite(values)]
    axes.hist(values, bins=bins, color=_path["color"])
    meaning = re.sub("^with `[^`]*`: ", "", found.meaning)  # its condition
    axes.set(xlabel=f"{re.split('[;:]', meaning)[0]} [{found.unit or '-'}]",
             ylabel="rocks" if table == "end_points" else "rows")
    return axes


def barrier_curves(result: Results, barrier: str, *, axes: Axes | None = None) -> Axes:
    """The share of the hits on a barrier or collector below each energy and each height: what a barrier there must be."""
    hits = result.barrier_hits
    hits = hits[hits["barrier"] == barrier]
    if len(hits) == 0:
        names = ", ".join(each["name"] for each in result.summary["barriers"]) or "none"
        raise BadInput(f"no rock arrives at a barrier {barrier!r} (there are {names})")
    axes = _axes(axes)
    share = 100 * np.arange(1, len(hits) + 1) / len(hits)
    axes.step(np.sort(hits["ke_total_J"]) / 1000, share, where="post", color=_path["color"], label="energy")
    axes.set(xlabel="total kinetic energy [kJ]", ylabel="share of hits below [%]", ylim=(0, 100), title=barrier)
    above = axes.twiny()
    above.step(np.sort(hits["impact_height_m"]), share, where="post", color=_barrier["color"])
    above.set_xlabel("impact height [m]", color=_barrier["color"])
    above.tick_params(axis="x", colors=_barrier["color"])
    axes.axhline(95, color="grey", linewidth=0.5, linestyle=":")
    return axes


def _axes(axes: Axes | None) -> Axes:
    if axes is not None:
        return axes
    from matplotlib import pyplot

    return pyplot.subplots(layout="constrained")[1]


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
    from matplotlib.colors import LightSource

    if not (high > low).all():
        return
    cell = (high - low).max() / 400
    x, y = np.arange(low[0] + cell / 2, high[0], cell), np.arange(high[1] - cell / 2, low[1], -cell)
    z = np.ma.masked_invalid(result.surface.elevation(x[np.newaxis, :], y[:, np.newaxis]))
    shade = LightSource(azdeg=315, altdeg=45).hillshade(z.filled(z.mean()), dx=cell, dy=cell)
    axes.imshow(np.ma.array(shade, mask=z.mask),
                extent=(low[0], low[0] + cell * len(x), high[1] - cell * len(y), high[1]), cmap="gray", vmin=-0.4, vmax=1)

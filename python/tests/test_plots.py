"""Figures, notebooks' pictures, frames and maps."""

import pickle

import numpy as np
import pytest

import talus

from conftest import SOURCE

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")


@pytest.fixture(scope="module")
def crater():
    return talus.run(SOURCE / "examples/maungawhau/maungawhau.toml", rocks=50)


def test_each_figure_returns_its_axes(slope, crater):
    from matplotlib import pyplot

    result = talus.run(slope)
    axes = talus.plots.section(result, rocks=10)
    assert len(axes.lines) == 1 + 10 + 1  # slope, rocks, barrier
    flight = axes.lines[1].get_xydata()
    assert (np.diff(flight[:, 0]) > -1e-9).all() and np.isfinite(flight).all()
    assert talus.plots.histogram(result, "max_ke_J").get_xlabel().endswith("[J]")
    assert talus.plots.barrier_curves(result, "Fence").get_title() == "Fence"
    plan = talus.plots.plan(crater, rocks=5)
    assert len(plan.images) == 1
    bounds, (west, east), (south, north) = crater.surface.bounds, plan.get_xlim(), plan.get_ylim()
    assert bounds.west <= west < crater.end_points["x_m"].min() and crater.end_points["x_m"].max() < east <= bounds.east
    assert bounds.south <= south < north <= bounds.north and east - west < bounds.east - bounds.west
    own = pyplot.figure().add_subplot()
    assert talus.plots.map(crater, "velocity_max", axes=own) is own
    with pytest.raises(talus.BadInput, match="not one of a section"):
        talus.plots.section(crater)
    pyplot.close("all")


def test_a_notebook_shows_table_and_picture(slope, crater):
    for result in (talus.run(slope, name="<A & B>"), crater):
        html = result._repr_html_()
        assert "<table>" in html and "data:image/png;base64," in html
        assert "<A" not in html


def test_frames_have_categories_and_missing_numbers(slope):
    pytest.importorskip("pandas")
    result = talus.run(slope)
    frame = result.frame("end_points")
    assert list(frame.columns) == list(result.end_points.dtype.names)
    assert str(frame["end_reason"].dtype) == "category" and frame["ensemble"].isna().all()
    assert frame.groupby("end_reason", observed=True).size().sum() == 200
    assert (frame["end_reason"].to_numpy() == result.end_points["end_reason"]).all()


def test_maps_have_their_place(crater):
    energy = crater.maps["kinetic_energy_p95"]
    assert isinstance(energy, np.ma.MaskedArray) and energy.name == "energy_total_p95_kJ" and energy.unit == "kJ"
    west, east, south, north = energy.extent
    assert (east - west, north - south) == (5 * energy.shape[1], 5 * energy.shape[0])
    passages = crater.maps["passages"]
    ends, (a, _, c, _, e, f) = crater.end_points, passages.transform
    column, row = ((ends["x_m"] - c) / a).astype(int), ((ends["y_m"] - f) / e).astype(int)
    inside = ends["end_reason"] != "left the model"
    assert (passages[row[inside], column[inside]] > 0).all()
    assert (2 * passages).transform == passages.transform and passages[1:].transform is None
    assert passages.max() <= 50
    for flipped in (passages[::-1], np.flipud(passages), passages[:9, :9].T):
        assert flipped.transform is None
        with pytest.raises(ValueError, match="has no transform"):
            flipped.extent
    again = pickle.loads(pickle.dumps(energy))
    assert (again == energy).all() and again.mask.sum() == energy.mask.sum()
    assert (again.transform, again.unit, again.crs_wkt) == (energy.transform, energy.unit, energy.crs_wkt)
    xarray = pytest.importorskip("xarray")
    array = energy.to_xarray()
    assert isinstance(array, xarray.DataArray) and array.attrs["units"] == "kJ" and float(array.y[0]) == north - 2.5
    assert np.isnan(array.values).sum() == energy.mask.sum()

"""Figures, notebooks' pictures, frames and maps."""

import pickle
import re

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
    energies = talus.plots.histogram(result, "max_ke_J")
    assert energies.get_xlabel().endswith("[kJ]") and energies.dataLim.x1 == pytest.approx(
        result.end_points["max_ke_J"].max() / 1000)
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


def test_maps_are_drawn_in_their_classes(crater):
    from matplotlib import pyplot
    from matplotlib.colors import to_hex

    velocity = crater.maps["velocity_max"]
    assert [each.low for each in velocity.classes] == [0, 5, 10, 15, 20, 30] and velocity.classes[-1].high == np.inf
    image = talus.plots.map(crater, "velocity_max").images[-1]
    for each in velocity.classes:
        assert to_hex(image.cmap(image.norm(each.low + 0.1))) == each.colour
        assert to_hex(image.cmap(image.norm(each.low))) == each.colour
    plain = talus.plots.map(crater, "velocity_max", cmap="viridis", vmax=40).images[-1]
    assert plain.cmap.name == "viridis" and plain.norm.vmax == 40
    for name, label, ticks in (("energy_total_p95", "Total kinetic energy, 95 % [kJ]", "0 30 100 300 1,000 3,000"),
                               ("velocity_max", "Velocity, maximum [m/s]", "0 5 10 15 20 30"),
                               ("bounce_height_p95", "Bounce height of the lowest point, 95 % [m]", "0 0.5 1 2 5 10"),
                               ("reach_share", "Share of all rocks that were in the cell [%]", "0 0.001 0.01 0.1 1 10"),
                               ("passages", "Rocks that were in the cell", "0 10 100 1,000 10,000 100,000")):
        bar = talus.plots.map(crater, name).images[-1].colorbar.ax
        assert bar.get_ylabel() == label
        assert [tick.get_text() for tick in bar.get_yticklabels()] == ticks.split()
    pyplot.close("all")


def test_answers_are_drawn(slope, crater):
    from matplotlib import pyplot

    answer = crater.line([[300, 70], [400, 60]])
    assert talus.plots.profile(answer, "height").get_ylabel().endswith("[m]")
    changed = talus.what_if(slope, 35, steps={"mass": 0.5, "normal_restitution": 0.1}, rocks=100)
    axes = talus.plots.changes(changed)
    assert [label.get_text() for label in axes.get_yticklabels()][-1] in ("mass", "normal restitution")
    with_models = talus.what_if(slope, 30, steps={"mass": 0.5}, models=True, rocks=100)
    axes = with_models.plot("energy_total_kJ")
    labels = [label.get_text() for label in axes.get_yticklabels()]
    assert sorted(labels) == ["mass", "model: rigid body (rectangle 5 6)", "model: rigid sphere"]
    sphere = with_models.variations[0].change.energy_total_kJ.value
    assert any(bar.get_width() == pytest.approx(sphere) and round(bar.get_y() + bar.get_height() / 2) ==
               labels.index("model: rigid sphere") for bar in axes.patches)
    assert axes.get_xlabel() == "change of the 95 % total energy [kJ]"
    inside = crater.polygon([[300, 20], [400, 20], [400, 60], [300, 60]])
    shares = inside.plot().collections[0].get_array()
    assert shares == pytest.approx(100 * inside.sources["share"]) and answer.plot("sources").get_title() == "1 place of release"
    first, second = talus.run(slope), talus.run(slope, material={"Rock": {"normal_restitution": 0.2}}, rocks=150)
    drawn = talus.compare(first, second).plot("max_ke_J")
    for line, result in zip(drawn.lines, (first, second)):
        assert line.get_xdata() == pytest.approx(np.sort(result.end_points["max_ke_J"]) / 1000) and line.get_ydata()[-1] == 100
    assert len(first.plot(rocks=10).lines) == 12 and len(crater.plot(rocks=5).images) == 1
    assert list(talus.follow(slope, 3).frame()["time_s"]) == list(talus.follow(slope, 3).events["time_s"])
    with pytest.raises(talus.BadInput, match="^figure='hight': expected energy, height, velocity. Did you mean"):
        talus.plots.profile(answer, "hight")
    with pytest.raises(talus.BadInput, match="^figure='energy': expected share, energy_kJ"):
        talus.plots.changes(changed, "energy")
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
    assert energy.crs is None and energy.classes == again.classes
    with pytest.raises(KeyError, match='Did you mean .*velocity_max_m_s'):
        crater.maps["velocity_maxx_m_s"]
    xarray = pytest.importorskip("xarray")
    array = energy.to_xarray()
    assert isinstance(array, xarray.DataArray) and array.attrs["units"] == "kJ" and float(array.y[0]) == north - 2.5
    assert np.isnan(array.values).sum() == energy.mask.sum()


def test_maps_are_written_as_geotiffs(tmp_path):
    """The files have the contents and the styles of those that a run writes."""
    gdal = pytest.importorskip("osgeo.gdal")
    result = talus.run(SOURCE / "examples/first-gis-run/first-gis-run.toml", rocks=60)
    folder = result.save(tmp_path / "out")
    assert result.maps["passages"].crs == "EPSG:25832"
    for name in ("passages", "energy_total_p95_kJ"):
        result.maps[name].to_geotiff(tmp_path / f"{name}.tif")
        ours, theirs = gdal.Open(str(tmp_path / f"{name}.tif")), gdal.Open(str(folder / f"maps/{name}.tif"))
        ours_band, theirs_band = ours.GetRasterBand(1), theirs.GetRasterBand(1)
        assert (ours.ReadAsArray() == theirs.ReadAsArray()).all()
        assert ours.GetGeoTransform() == theirs.GetGeoTransform() and ours.GetProjection() == theirs.GetProjection()
        assert ours_band.GetNoDataValue() == theirs_band.GetNoDataValue() and ours_band.DataType == theirs_band.DataType
        assert (ours_band.GetDescription(), ours_band.GetUnitType()) == (theirs_band.GetDescription(), theirs_band.GetUnitType())
        styles = [file.with_suffix(".qml").read_text() for file in (tmp_path / f"{name}.tif", folder / f"maps/{name}.tif")]
        # The range is that of the numbers before they were rounded for the file.
        assert len({re.sub('(least|greatest)Value="[^"]*"', "", style) for style in styles}) == 1
    (2 * result.maps["velocity_max"]).to_geotiff(tmp_path / "twice.tif")
    opened = talus.open_results(folder).maps["passages"]
    assert opened.crs == "EPSG:25832" and opened.classes == result.maps["passages"].classes
    for wrong, match in ((lambda: opened[1:].to_geotiff(tmp_path / "a.tif"), "has no transform"),
                         (lambda: opened.to_geotiff(tmp_path / "a.png"), "ends with .tif"),
                         (lambda: opened.to_geotiff(tmp_path / "none/a.tif"), "cannot write this map")):
        with pytest.raises(talus.BadInput, match=match):
            wrong()


def test_a_geotiff_opens_in_rasterio(tmp_path):
    rasterio = pytest.importorskip("rasterio")
    energy = talus.run(SOURCE / "examples/first-gis-run/first-gis-run.toml", rocks=60).maps["energy_total_p95"]
    energy.to_geotiff(tmp_path / "energy.tif")
    with rasterio.open(tmp_path / "energy.tif") as file:
        assert file.transform == rasterio.Affine(*energy.transform) and file.crs == rasterio.CRS.from_string(energy.crs)
        read = file.read(1, masked=True)
    assert (read.mask == energy.mask).all() and (read == energy).all()

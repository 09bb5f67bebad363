"""Two runs side by side."""

import numpy as np
import pytest

import talus


def test_statistics_barriers_and_settings(slope):
    first = talus.run(slope)
    second = talus.run(slope, material={"Scree": {"normal_restitution": 0.2}})
    both = talus.compare(first, second)
    rows = both.statistics
    mean = rows[(rows["quantity"] == "runout_xy_m") & (rows["figure"] == "mean")][0]
    assert mean["first"] == pytest.approx(first.end_points["runout_xy_m"].mean())
    assert mean["second"] == pytest.approx(second.end_points["runout_xy_m"].mean())
    assert mean["difference"] == mean["second"] - mean["first"]
    hits = both.barriers
    assert hits[hits["outcome"] == "hits"]["first"][0] == len(first.barrier_hits)
    stopped = hits[hits["outcome"] == "stopped"][0]
    assert stopped["second"] == (second.barrier_hits["outcome"] == "stopped").sum()
    assert [each.setting for each in both.settings] == ["material.Scree.normal_restitution.mean"]
    assert both.settings[0].first != both.settings[0].second == 0.2
    assert both.answers is None and len(both.at_place) == 0
    lines = repr(both).splitlines()
    change = mean["second"] - mean["first"]
    assert lines[1].split()[:7] == ["runout", "on", "plan,", "mean", f"{mean['first']:.1f}", "m", f"{mean['second']:.1f}"]
    assert float(lines[1].split()[-2]) == pytest.approx(change, abs=0.05 * abs(change)) and lines[1].endswith(" m")
    assert "1 setting differs." in repr(both) and lines[-1] == "material.Scree.normal_restitution.mean: 0.35, then 0.2"
    pytest.importorskip("pandas")
    frame = both.frame()
    assert both.to_pandas().equals(frame)
    assert list(frame["difference"]) == list(rows["difference"]) and "<th" in both._repr_html_()
    assert list(both.frame("barriers")["first"]) == list(hits["first"])
    with pytest.raises(talus.BadInput, match="^there is no table 'barrier' .expected statistics, barriers, at_place"):
        both.frame("barrier")


def test_at_a_line(slope, tmp_path):
    first, second = talus.run(slope), talus.run(slope, material={"Rock": {"normal_restitution": 0.2}})
    both = talus.compare(first, second, line=60)
    assert list(both.at_place["figure"]) == ["share", "energy_kJ", "height_m", "velocity_m_s"]
    share = both.at_place[0]
    assert (share["first"], share["second"]) == (first.line(60).share.value, second.line(60).share.value)
    at_fence = talus.compare(first, second, barrier="Fence")
    assert at_fence.answers[0].name == "Fence"
    one, other = (answer.needs for answer in at_fence.answers)
    assert f"class {one.kit_class}, {one.energy_kJ:.0f} kJ, {one.height_m:.3f} m" in repr(at_fence)
    assert "Passes Fence" in repr(at_fence) and f"{other.energy_kJ:.0f} kJ" in repr(at_fence)
    bare = [talus.run(slope, design={"standard": "none"}) for _ in range(2)]
    unclassed = repr(talus.compare(*bare, barrier="Fence"))
    assert "Fence needed" in unclassed and "class" not in unclassed
    same = talus.compare(first, talus.run(slope), line=60)
    assert (np.nan_to_num(same.at_place["difference"]) == 0).all() and same.settings == []
    folder = first.save(tmp_path / "out")
    opened = talus.compare(first, talus.open_results(folder), line=60)
    assert (np.nan_to_num(opened.at_place["difference"]) == 0).all()
    with pytest.raises(TypeError, match="^second is int"):
        talus.compare(first, 3)
    with pytest.raises(talus.BadInput, match="one of line, barrier and polygon"):
        talus.compare(first, second, line=60, barrier="Fence")

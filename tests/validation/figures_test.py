"""The series of figures: what they show holds at their smallest sizes, and the page says what is stored."""
import importlib
import importlib.machinery
import importlib.util
import os
import sys

import numpy as np
import pytest

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
sys.path[:0] = [os.path.join(ROOT, "validation"), os.path.join(ROOT, "bindings")]
import stored  # noqa: E402
from series import body, connection, defects, sphere  # noqa: E402


def program():
    loader = importlib.machinery.SourceFileLoader("figures", os.path.join(ROOT, "validation", "figures"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("figures", loader))
    loader.exec_module(module)
    return module


FIGURES = program()


def kept(name, folder=os.path.join(FIGURES.DOCS, "figures")):
    return stored.Stored(os.path.join(folder, name + ".json"), is_kept=True)


def test_errors_on_the_sphere_fall_by_the_order_of_the_elements(tmp_path):
    found = sphere.compute(stored.Stored(str(tmp_path / "sphere.json")), (100, 300), ("quads",))
    assert len(found) == 2
    for (_, order), cases in found.items():
        assert order + 0.6 < sphere.power(cases) < order + 2.2
    assert sphere.at(found["quads", 2], 300) < sphere.at(found["quads", 1], 300) / 4
    again = sphere.compute(kept("sphere", str(tmp_path)), (100, 300), ("quads",))
    assert again == found


@pytest.mark.parametrize("number, sizes", [(0, (20, 13)), (3, (14, 9))])
def test_sheets_that_touch_without_common_nodes_are_wrong_at_every_size(number, sizes, tmp_path):
    subject = connection.SUBJECTS[number]._replace(sizes=sizes)
    found = connection.compute(stored.Stored(str(tmp_path / "connection.json")), [subject])[subject.title]
    fine = found["imprint", "fine"]
    by_size = body.differences(found["imprint", "coarse"], fine)[0]
    for fineness in ("coarse", "fine"):
        assert body.differences(found["none", fineness], fine)[0] > max(1, 4 * by_size)


def test_a_seam_left_open_costs_more_than_nodes_moved_by_a_fifth():
    mesh = sphere.unit_sphere("quads", 2, 192)
    good, moved, open_ = (sphere.solved(m)["rms"] for m in (mesh, defects.shifted(mesh, 0.2), defects.cut(mesh)))
    assert good < moved < open_ / 4


def test_the_grid_of_a_cube_is_closed_and_regular_but_for_eight_nodes():
    grid = defects.grid(4)
    valence = np.bincount(grid.quads[:, :4].ravel())
    assert np.allclose(np.linalg.norm(grid.nodes, axis=1), 1)
    assert len(grid.quads) == 96
    assert sorted(valence[valence > 0])[:8] == [3] * 8 and (valence > 0).sum() - 8 == (valence == 4).sum()
    assert body.scattering.surface(grid).is_closed


@pytest.mark.parametrize("name", FIGURES.SERIES + FIGURES.LONG)
def test_pictures_and_tables_come_of_what_is_stored(name, tmp_path):
    module = importlib.import_module(f"series.{name}")
    results = module.compute(kept(name))
    module.draw(results, str(tmp_path))
    assert (tmp_path / (name + ".svg")).stat().st_size > 10_000
    with open(os.path.join(FIGURES.DOCS, "figures.md"), encoding="utf-8") as f:
        page = f.read()
    assert FIGURES.with_tables(page, module.tables(results)) == page


def test_long_series_are_solved_only_where_asked_for(monkeypatch):
    monkeypatch.setattr(sys, "argv", ["figures"])
    assert not set(FIGURES.arguments().series or FIGURES.SERIES) & set(FIGURES.LONG)
    monkeypatch.setattr(sys, "argv", ["figures", *FIGURES.LONG])
    assert tuple(FIGURES.arguments().series) == FIGURES.LONG


def test_a_page_without_a_place_for_a_table_is_refused():
    with pytest.raises(ValueError, match="no place for the table sphere"):
        FIGURES.with_tables("nothing here", {"sphere": "| a |"})


def test_what_is_not_stored_is_named(tmp_path):
    with pytest.raises(stored.Missing, match="lacks grid"):
        kept("sphere", str(tmp_path)).get("grid", dict)

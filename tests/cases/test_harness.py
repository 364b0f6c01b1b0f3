# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""The fixture `clone` and the pictures that tutorials make."""

from time import perf_counter

import grainplot
import h5py
import numpy as np
import pytest


@pytest.fixture
def box(clone):
    case = clone("box2D")
    case.run("blockMesh")
    return case


def write_grains(case, time):
    with h5py.File(case.path / time / "grains.h5", "w") as file:
        file["id"] = [2, 1]
        file["position"] = [[0.5, 0.5], [1.5, 0.3]]
        file["velocity"] = [[0.0, 1.0], [3.0, 4.0]]
        file["radius"] = [0.2, 0.1]


def test_program_is_run_and_logged(box):
    assert "nCells: 32" in box.log
    assert (box.path / "log.blockMesh").read_text() == box.log
    assert box.times == ["0"]


def test_failure_shows_the_end_of_the_output(box):
    assert box.run("blockMesh -dict system/none", check=False) != 0
    with pytest.raises(pytest.fail.Exception, match="exit code"):
        box.run("blockMesh -dict system/none")


def test_entries_are_set_and_read(box):
    box.dict_set("system/controlDict", "endTime", 3)
    assert box.dict_get("system/controlDict", "endTime") == "3"
    box.dict_set("0/T", "boundaryField/walls/type", "calculated")
    assert box.dict_get("0/T", "boundaryField/walls/type") == "calculated"


@pytest.mark.parametrize("form", ["ascii", "binary"])
@pytest.mark.parametrize("compression", ["off", "on"])
def test_mesh_is_read_in_every_format(clone, form, compression):
    case = clone("box2D")
    case.dict_set("system/controlDict", "writeFormat", form)
    case.dict_set("system/controlDict", "writeCompression", compression)
    case.run("blockMesh")
    mesh = case.mesh()
    assert mesh.axes == (0, 1)
    assert len(mesh.polygons) == 32
    assert mesh.areas.sum() == pytest.approx(2, rel=1e-12)
    assert mesh.areas[-1] / mesh.areas[0] == pytest.approx(2, rel=1e-6)
    np.testing.assert_allclose(mesh.bounds, [[0, 0], [2, 1]])


def test_uniform_and_written_fields_have_a_value_per_cell(box):
    assert np.array_equal(box.field("T"), np.full(32, 300.0))
    box.run("postProcess -func writeCellCentres -time 0")
    x = box.field("C")[:, 0]
    assert x.shape == (32,)
    assert x.mean() == pytest.approx(1)


def test_tables_of_conditions_do_not_slow_reading_down(box):
    """foamlib takes 100 s for one of 250 vectors."""
    path = box.path / "0/T"
    table = " ".join(f"({i} ({i} 0 0))" for i in range(1000))
    text = path.read_text()
    condition = f"boundaryField\n{{\n    inlet {{ uniformValue table ({table}); }}"
    path.write_text(text.replace("boundaryField\n{", condition))
    start = perf_counter()
    assert np.array_equal(box.field("T"), np.full(32, 300.0))
    assert perf_counter() - start < 5


def test_grains_come_sorted_by_id(box):
    write_grains(box, "0")
    assert list(box.grains()["id"]) == [1, 2]
    assert box.grains()["radius"] == pytest.approx([0.1, 0.2])


def test_tables_and_logs_are_read(box):
    (box.path / "a.csv").write_text("time,kinetic\n0,1\n# note\n0.5,2e-3\n")
    (box.path / "b.dat").write_text("# time kinetic\n0 1\n0.5 2e-3\n")
    for file in ("a.csv", "b.dat"):
        assert box.table(file)["kinetic"] == pytest.approx([1, 2e-3])
    box.log = "Co = 0.25\nCo = 1.5e-3\n"
    assert box.logged("Co = ") == pytest.approx([0.25, 1.5e-3])


def test_picture_has_a_column_for_each_time(box):
    write_grains(box, "0")
    figure = grainplot.columns(box.path, ["0", "0"], field="T")
    assert len([ax for ax in figure.axes if ax.get_title()]) == 2
    figure.savefig(box.path / "columns.png")
    assert (box.path / "columns.png").stat().st_size > 1000


def test_three_dimensional_mesh_is_refused(box):
    text = (box.path / "system/blockMeshDict").read_text()
    (box.path / "system/blockMeshDict").write_text(text.replace("type empty", "type patch"))
    box.run("blockMesh")
    with pytest.raises(ValueError, match="empty"):
        box.mesh()

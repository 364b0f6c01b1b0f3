# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Flow through a bed of spheres in cells that are refined and unrefined anywhere, step by step."""

import numpy as np
import pytest
from grain_box import control, ledger, replace, run_whole_and_parts, tracks
from moving_mesh import write
from sphere_box import decompose, field, refine, sphere_box

SPEED = 0.05
STEPS = 100
N = 8
SIDE = 0.1

# Cells with 'mark' between the levels are split, those below the last are merged again
REFINEMENT = """
dynamicFvMesh dynamicRefineFvMesh;
dynamicRefineFvMeshCoeffs
{
    refineInterval  1;
    field           mark;
    lowerRefineLevel 0.6;
    upperRefineLevel 2;
    unrefineLevel   0.5;
    nBufferLayers   1;
    maxRefinement   1;
    maxCells        100000;
    correctFluxes   ((phi none) (phiU none) (phiFluid none));
    dumpLevel       true;
}
"""

# The inlet's, as the outlet's is zero
DROP = """
    drop
    {
        type            surfaceFieldValue;
        libs            ("libfieldFunctionObjects.so");
        regionType      patch;
        name            back;
        operation       areaAverage;
        fields          (p_rgh);
        writeFields     false;
        writePrecision  16;
        writeControl    timeStep;
        writeInterval   1;
    }
"""


def scalar(case, name, values, inlet):
    """A scalar that the fluid carries, with random values."""
    text = "\n".join(repr(float(v)) for v in values)
    write(
        case,
        f"0/{name}",
        "volScalarField",
        "dimensions [0 0 0 0 0 0 0];\n"
        f"internalField nonuniform List<scalar> {len(values)}\n({text});\n"
        f"boundaryField {{ back {{ {inlet} }} front {{ type zeroGradient; }}\n"
        '"left|right|bottom|top" { type zeroGradient; } }\n',
    )


def fixed_in_a_stream(case):
    """Fixed grains without weight, fluid from the back to the front, other sides slip."""
    blocks = case.path / "system/blockMeshDict"
    text = blocks.read_text()
    for patch in ("back", "front"):
        text = text.replace(f"{patch}\n    {{\n        type    wall", f"{patch} {{ type patch")
    blocks.write_text(text)
    case.run("blockMesh")
    replace(case, "constant/g", "-9.81", "0")
    replace(case, "constant/grainProperties", "coupling\n{", "coupling\n{\n    motion fixed;")
    replace(
        case,
        "0/U",
        '".*"\n    {\n        type    noSlip;\n    }',
        f"back {{ type fixedValue; value uniform (0 0 {SPEED}); }}\n"
        'front { type zeroGradient; } "left|right|bottom|top" { type slip; }',
    )
    replace(case, "0/p_rgh", '".*"', 'front { type fixedValue; value uniform 0; } ".*"')


def bed(clone, n=N, refined=True, name=None, draw=7):
    """Spheres near the sites of a lattice, fluid from the back to the front."""
    rng = np.random.default_rng(draw)
    sites = np.stack(np.meshgrid(*3 * [np.arange(N) + 0.5], indexing="ij"), -1).reshape(-1, 3)
    sites = SIDE / N * sites[(sites[:, 2] > 2) & (sites[:, 2] < N - 2)]
    centres = sites + rng.uniform(-0.002, 0.002, sites.shape)
    case = sphere_box(clone, centres, 0.004, n=n, name=name)
    fixed_in_a_stream(case)
    replace(
        case,
        "constant/grainProperties",
        "type    exactOverlap;",
        "type    diffused;\n        length  0.025;",
    )

    file = case.path / "constant/transportProperties"
    file.write_text(file.read_text() + "scalars { mark { D 0; } dye { D 0; } }\n")
    # A new value comes in every second step
    times = np.arange(0, 2 * STEPS) * 4e-3
    random = zip(times, rng.random(len(times)), strict=True)
    table = " ".join(f"({t:.4f} {v:.4f})" for t, v in random)
    scalar(case, "mark", rng.random(n**3), f"type uniformFixedValue; uniformValue table ({table});")
    scalar(case, "dye", rng.random(n**3), "type fixedValue; value uniform 0.5;")
    entries = "".join(f"div(phiFluid,{s}) Gauss upwind;\n" for s in ("mark", "dye"))
    replace(case, "system/fvSchemes", "divSchemes\n{", "divSchemes\n{\n" + entries)
    solver = '"mark|dye" { solver PBiCGStab; preconditioner DILU; tolerance 1e-15; relTol 0; }'
    replace(case, "system/fvSolution", "solvers\n{", "solvers\n{\n" + solver)
    replace(case, "system/controlDict", "functions\n{", "functions\n{" + DROP)
    if refined:
        refine(case, REFINEMENT)
    control(case, deltaT=2e-3, endTime=2e-3 * STEPS, writeInterval=STEPS // 2, writeFormat="binary")
    return case


def sphere_in_stream(clone, refined, name):
    """A fixed resolved sphere; cells in a corner of the channel are split and merged in passing."""
    n = 10
    case = sphere_box(clone, [(0.05, 0.05, 0.05)], 0.022, n=n, name=name)
    fixed_in_a_stream(case)
    replace(case, "constant/transportProperties", "1e-4", "2e-5")
    replace(case, "0/U", "uniform (0 0 0)", f"uniform (0 0 {SPEED})")
    file = case.path / "constant/transportProperties"
    file.write_text(file.read_text() + "scalars { mark { D 0; } }\n")
    mark = np.zeros((n, n, n))
    mark[::3, 0, 0] = 1
    scalar(case, "mark", mark.ravel(), "type fixedValue; value uniform 0;")
    scheme = "div(phiFluid,mark) Gauss upwind;\n"
    replace(case, "system/fvSchemes", "divSchemes\n{", "divSchemes\n{\n" + scheme)
    solver = "mark { solver PBiCGStab; preconditioner DILU; tolerance 1e-15; relTol 0; }"
    replace(case, "system/fvSolution", "solvers\n{", "solvers\n{\n" + solver)
    if refined:
        refine(case, REFINEMENT)
    control(case, deltaT=4e-3, endTime=0.2, writeInterval=1000)
    case.run("grainFoam")
    return case


def test_cells_that_change_elsewhere_leave_the_drag(clone):
    """All fluxes were made anew from cells, which took up to a quarter of a resolved sphere's."""
    still, refined = (
        sphere_in_stream(clone, refined, name)
        for refined, name in ((False, "still"), (True, "refined"))
    )
    assert refined.log.count("efined from") >= 5
    one, other = (tracks(case)[5:, 13] for case in (still, refined))
    assert other.mean() == pytest.approx(one.mean(), rel=0.01)
    # Faces that do change are as far as two cells from the sphere
    np.testing.assert_allclose(other, one, rtol=0.1)


def drop(case, start="0"):
    """Pressure drop of every step [Pa]."""
    return np.loadtxt(case.path / f"postProcessing/drop/{start}/surfaceFieldValue.dat")[:, 1]


def test_random_refinement_keeps_volume_content_and_pressure_drop(clone):
    fine = bed(clone, n=2 * N, refined=False, name="fine")
    fine.run("grainFoam")
    case = bed(clone, name="refined")
    case.run("grainFoam")
    changes = case.log.count("Refined from") + case.log.count("Unrefined from")
    assert changes >= 0.95 * STEPS

    book = ledger(case)
    assert book["mappingError"].max() <= 1e-12
    assert book["transportDefect"].max() <= 1e-12
    assert book["carriedUnaccounted"].max() <= 1e-12
    assert book["momentumError"].max() <= 1e-10
    last = field(case, "dye")
    assert -1e-12 <= last.min() and last.max() <= 1 + 1e-12

    # Cells that are split or merged accelerate the fluid: the drop scatters from step to step
    half = slice(STEPS // 2, None)
    force, expected = (ledger(c)["received_z"][half] for c in (case, fine))
    assert drop(case)[half].mean() == pytest.approx(drop(fine)[half].mean(), rel=0.01)
    # Grains do not feel it
    np.testing.assert_allclose(force, expected, rtol=0.01)


def test_stop_and_restart(clone):
    whole, parts = (bed(clone, name=name) for name in ("whole", "parts"))
    control(whole, endTime=0.04, writeInterval=10)
    control(parts, writeInterval=10)
    run_whole_and_parts(whole, parts, "grainFoam", stop=0.02, end=0.04)
    np.testing.assert_array_equal(field(whole, "eps"), field(parts, "eps"))
    # What comes in is a function of time, which has another round-off after a restart
    for name, scale in (("U", SPEED), ("p_rgh", 20), ("dye", 1), ("mark", 1)):
        one, other = (field(case, name) for case in (whole, parts))
        np.testing.assert_allclose(one, other, rtol=0, atol=1e-12 * scale, err_msg=name)


@pytest.mark.parallel
def test_ranks_agree(clone):
    """OpenFOAM chooses some other cells beside the boundaries of ranks: 1 % of them."""
    serial = bed(clone, name="serial")
    control(serial, endTime=0.06)
    serial.run("grainFoam")
    developed = slice(10, None)
    expected = ledger(serial)["received_z"][developed].mean()
    for number in (2, 4):
        ranks = bed(clone, name=f"ranks{number}")
        control(ranks, endTime=0.06)
        decompose(ranks, number)
        ranks.parallel("grainFoam", number)
        book = ledger(ranks)
        assert book["mappingError"].max() <= 1e-12
        assert book["transportDefect"].max() <= 1e-12
        assert book["carriedUnaccounted"].max() <= 1e-12
        assert book["momentumError"].max() <= 1e-10
        assert book["received_z"][developed].mean() == pytest.approx(expected, rel=0.005)
        drops = [drop(case)[developed].mean() for case in (ranks, serial)]
        assert drops[0] == pytest.approx(drops[1], rel=0.01)

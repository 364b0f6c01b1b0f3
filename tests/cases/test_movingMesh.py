# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains in a fluid on meshes that move."""

import numpy as np
import pytest
from grain_box import control, grain_box, lattice, ledger, open_ends, replace
from sphere_box import decompose

SPEED = 0.1
HEADER = "FoamFile {{ version 2.0; format ascii; class {kind}; object {name}; }}\n"


def write(case, path, kind, text):
    name = path.rpartition("/")[2]
    (case.path / path).write_text(HEADER.format(kind=kind, name=name) + text)


def add_motion(case, patches):
    """Displacements of the patches (name: entry), between which the mesh stretches."""
    write(
        case,
        "constant/dynamicMeshDict",
        "dictionary",
        "dynamicFvMesh dynamicMotionSolverFvMesh; motionSolverLibs (fvMotionSolvers);\n"
        "solver displacementLaplacian; displacementLaplacianCoeffs { diffusivity uniform; }\n",
    )
    entries = "".join(f"{name} {{ {entry} }}\n" for name, entry in patches.items())
    write(
        case,
        "0/pointDisplacement",
        "pointVectorField",
        "dimensions [0 1 0 0 0 0 0]; internalField uniform (0 0 0);\n"
        f"boundaryField {{ {entries} frontAndBack {{ type empty; }} }}\n",
    )
    solver = "cellDisplacement { solver PCG; preconditioner DIC; tolerance 1e-10; relTol 0; }"
    replace(case, "system/fvSolution", "solvers\n{", f"solvers\n{{\n{solver}")


def translate(case, velocity):
    """The whole mesh moves."""
    write(
        case,
        "constant/dynamicMeshDict",
        "dictionary",
        "dynamicFvMesh dynamicMotionSolverFvMesh; motionSolverLibs (fvMotionSolvers);\n"
        "solver solidBody; solidBodyMotionFunction linearMotion;\n"
        f"linearMotionCoeffs {{ velocity ({' '.join(map(str, velocity))}); }}\n",
    )


def shaken_stream(clone, centres, radius, shaken=True):
    """A stream of SPEED with grains that move with it, in a mesh whose bottom swings."""
    case = grain_box(clone, centres, radius, velocity=np.tile((0, SPEED), (len(centres), 1)))
    open_ends(case, SPEED)
    replace(case, "0/U", "uniform (0 0 0)", f"uniform (0 {SPEED} 0)")
    case.run("blockMesh")
    if shaken:
        swing = "type oscillatingDisplacement; amplitude (0 0.02 0); omega 40;"
        add_motion(
            case,
            {
                "bottom": f"{swing} value uniform (0 0 0);",
                "top": "type fixedValue; value uniform (0 0 0);",
                '"left|right"': "type slip;",
            },
        )
    control(case, deltaT=5e-3, endTime=0.2, writeInterval=40)
    return case


@pytest.mark.parametrize("radius", [1e-4, 0.022], ids=["unresolved", "resolved"])
@pytest.mark.parametrize("scheme", ["Euler", "backward"])
def test_a_uniform_stream_does_not_see_that_the_mesh_is_shaken(clone, radius, scheme):
    case = shaken_stream(clone, [(0.05, 0.045)], radius)
    if scheme != "Euler":
        replace(case, "system/fvSchemes", "Euler", scheme)
    case.run("grainFoam")
    U = case.field("U", case.times[-1])
    np.testing.assert_allclose(U[:, 1], SPEED, rtol=1e-10)
    np.testing.assert_allclose(U[:, 0], 0, atol=1e-10 * SPEED)
    book = ledger(case)
    assert book["mappingError"].max() <= 1e-12
    assert book["divergence"].max() <= 1e-10


def test_grains_that_cross_cells_disturb_a_shaken_mesh_as_they_do_one_at_rest(clone):
    """Sums of overlaps do not move as interpolated velocities do: 1.5 % of the speed at rest."""
    grains = lattice(4, 3, 0.015, (0.03, 0.03))
    disturbed = []
    for shaken in (False, True):
        case = shaken_stream(clone, grains, 0.004, shaken)
        case.path = case.path.rename(case.path.with_name(f"shaken{shaken}"))
        case.run("grainFoam")
        disturbed.append(np.abs(case.field("U", case.times[-1])[:, 1] - SPEED).max())
    # Cells are up to a third smaller than at rest
    assert disturbed[1] <= 2 * disturbed[0]

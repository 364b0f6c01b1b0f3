# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of the case grainBox that move."""

from grain_box import replace

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

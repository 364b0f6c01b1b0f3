# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Two fluids: bad input is answered with file, keyword, value and what is allowed."""

import pytest
from moving_mesh import write
from test_movingSurface import REFINEMENT
from water_box import level, water_box

TRANSPORT = "constant/transportProperties"
SOLUTION = "system/fvSolution"
SCHEMES = "system/fvSchemes"
GRAINS = "constant/grainProperties"


def swap(file, old, new):
    def change(case):
        path = case.path / file
        text = path.read_text()
        assert old in text, old
        path.write_text(text.replace(old, new, 1))

    return change


def turbulent(case):
    (case.path / "constant/turbulenceProperties").write_text(
        "FoamFile { version 2.0; format ascii; class dictionary; object turbulenceProperties; }\n"
        "simulationType RAS; RAS { RASModel kEpsilon; turbulence on; }\n"
    )


def waves(case):
    swap("0/U", '"left|', 'left { type waveVelocity; value uniform (0 0 0); } "')(case)
    swap("system/controlDict", "functions", 'libs ("libwaveModels.so");\nfunctions')(case)


def refined(case):
    write(case, "constant/dynamicMeshDict", "dictionary", REFINEMENT)


INPUTS = {
    "one phase": (
        swap(TRANSPORT, "(water air)", "(water)"),
        [TRANSPORT, "'phases'", "value ( water )", "two names"],
    ),
    "a phase twice": (
        swap(TRANSPORT, "(water air)", "(water water)"),
        [TRANSPORT, "'phases'", "two names"],
    ),
    "no phases": (
        swap(TRANSPORT, "phases (water air);", ""),
        [TRANSPORT, "'phases'", "missing", "two names"],
    ),
    "unknown phase": (swap(TRANSPORT, "(water air)", "(water oil)"), [TRANSPORT, "oil"]),
    "negative sigma": (
        swap(TRANSPORT, "sigma 0", "sigma -0.07"),
        [TRANSPORT, "'sigma'", "value -0.07", "0"],
    ),
    "sigma of a temperature": (
        swap(TRANSPORT, "sigma 0", "sigma { type temperatureDependent; sigma constant 0.07; }"),
        [TRANSPORT, "'type'", "value temperatureDependent", "constant"],
    ),
    "sigma of other dimensions": (
        swap(TRANSPORT, "sigma 0", "sigma [1 0 0 0 0 0 0] 0.07"),
        [TRANSPORT, "'sigma'", "[1 0 -2 0 0 0 0]"],
    ),
    "negative density": (
        swap(TRANSPORT, "rho 1000", "rho -1000"),
        [f"{TRANSPORT}.water", "'rho'", "value -1000"],
    ),
    "no viscosity": (
        swap(TRANSPORT, "nu 1.48e-5;", ""),
        [f"{TRANSPORT}.air", "'nu'", "missing"],
    ),
    "unknown entry": (swap(TRANSPORT, "sigma", "beta 1; sigma"), [TRANSPORT, "'beta'"]),
    "fraction above one": (
        swap("0/alpha.water", "1.0\n", "1.5\n"),
        ["0/alpha.water", "internalField", "1.5", "0 to 1"],
    ),
    "fraction with dimensions": (
        swap("0/alpha.water", "[0 0 0 0 0 0 0]", "[1 0 0 0 0 0 0]"),
        ["alpha.water", "[1 0 0 0 0 0 0]"],
    ),
    "contact angle": (
        swap(
            "0/alpha.water",
            "type zeroGradient;",
            "type constantAlphaContactAngle; theta0 190; limit gradient; value uniform 0;",
        ),
        ["0/alpha.water", "'theta0'", "value 190", "0 to 180"],
    ),
    "contact angle of grains": (
        swap(GRAINS, "density 2500;", "density 2500; contactAngle 190;"),
        [f"{GRAINS}.materials.glass", "'contactAngle'", "value 190", "0", "180"],
    ),
    "contact angle of grains that is no number": (
        swap(GRAINS, "density 2500;", "density 2500; contactAngle steep;"),
        [f"{GRAINS}.materials.glass", "'contactAngle'", "value steep"],
    ),
    "negative contact angle of walls": (
        swap(
            "0/alpha.water",
            "type zeroGradient;",
            "type constantAlphaContactAngle; theta0 -1; limit gradient; value uniform 0;",
        ),
        ["0/alpha.water", "'theta0'", "value -1", "0 to 180"],
    ),
    "explicit MULES": (
        swap(SOLUTION, "MULESCorr yes", "MULESCorr no"),
        [SOLUTION, "'MULESCorr'", "value no", "yes"],
    ),
    "misspelt control of the fraction": (
        swap(SOLUTION, "nAlphaCorr 1", "nAlphaCor 1"),
        [SOLUTION, "Unknown keyword 'nAlphaCor'", "nAlphaCorr"],
    ),
    "no corrections of the fraction": (
        swap(SOLUTION, "nAlphaCorr 1", "nAlphaCorr 0"),
        [SOLUTION, "'nAlphaCorr'", "value 0"],
    ),
    "negative compression": (
        swap(SOLUTION, "cAlpha 1", "cAlpha -1"),
        [SOLUTION, "'cAlpha'", "value -1"],
    ),
    "no iterations of the limiter": (
        swap(SOLUTION, "nLimiterIter 5;", ""),
        [SOLUTION, "'nLimiterIter'", "missing", "a whole number"],
    ),
    "no scheme for the stress": (
        swap(SCHEMES, "    div(tau)        Gauss linear;\n", ""),
        [SCHEMES, "'div(tau)'", "missing", "a scheme", "'default'"],
    ),
    "no scheme for convection": (
        swap(SCHEMES, "div(rhoPhi,U)   Gauss linearUpwind grad(U);", ""),
        [SCHEMES, "'div(rhoPhi,U)'", "missing", "a scheme", "'default'"],
    ),
    "outer corrections": (
        swap(SOLUTION, "PIMPLE\n{", "PIMPLE\n{\n nOuterCorrectors 2;"),
        [SOLUTION, "'nOuterCorrectors'", "value 2"],
    ),
    "closing of momentum": (
        swap(SOLUTION, "PIMPLE\n{", "PIMPLE\n{\n closeMomentum often;"),
        [SOLUTION, "'closeMomentum'", "value often", "yes", "no"],
    ),
    "second order in time": (
        swap("system/fvSchemes", "default         Euler", "default         backward"),
        ["system/fvSchemes", "'default'", "value backward", "Euler"],
    ),
    "refinement in two dimensions": (
        refined,
        ["constant/dynamicMeshDict", "'dynamicFvMesh'", "value dynamicRefineFvMesh", "gmsh"],
    ),
    "waves with gravity along -y": (waves, ["0/U", "waveVelocity", "'left'", "(0 0 -1)"]),
    "turbulence": (turbulent, ["turbulenceProperties", "laminar"]),
    "another void fraction": (
        swap("constant/grainProperties", "type    exactOverlap", "type    centroid"),
        ["voidFraction", "'type'", "value centroid", "exactOverlap"],
    ),
    "Courant number of the surface": (
        swap("system/controlDict", "deltaT", "maxAlphaCo -1;\ndeltaT"),
        ["system/controlDict", "'maxAlphaCo'", "value -1"],
    ),
}


@pytest.mark.parametrize("name", INPUTS)
def test_answer(clone, name):
    change, words = INPUTS[name]
    case = water_box(clone, level(0.05), [(0.05, 0.03)])
    change(case)
    assert case.run("grainInterFoam", check=False) != 0
    for word in words:
        assert word in case.log, f"no '{word}' in\n{case.log[-1500:]}"
    assert "\nTime = " not in case.log
    assert "printStack" not in case.log

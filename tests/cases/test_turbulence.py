# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Turbulence models of OpenFOAM: as in pisoFoam without grains, weighted by the fluid with them."""

import re

import numpy as np
import pytest
from grain_box import control, grain_box, lattice, ledger, replace
from heat_box import SOLVER as OF_SCALARS
from heat_box import with_heat, with_psi, write_scalar
from test_noGrains import as_piso_foam
from test_restart import assert_same

RHO, NU = 1000.0, 1e-5
SPEED, K, EPSILON = 1.0, 0.01, 0.05
FLUID = "constant/transportProperties"
GRAINS = "constant/grainProperties"
TURBULENCE = "constant/turbulenceProperties"
CELLS = (16, 12)
WALLS = '"left|right|bottom|top"'

MODELS = {
    "kEpsilon": "simulationType RAS; RAS { RASModel kEpsilon; turbulence on; printCoeffs off; }",
    "laminar": "simulationType laminar;",
    "Stokes": "simulationType laminar; laminar { laminarModel Stokes; }",
}

SCHEMES = "".join(
    f"    div({flux},{name}) Gauss upwind;\n"
    for flux in ("phi", "alphaPhi")
    for name in ("k", "epsilon")
)
AT_WALLS = """functions
{
    force
    {
        type forces; libs ("libforces.so"); patches (bottom top); rho %s; CofR (0 0 0);
        log no;
    }
    wallShearStress { type wallShearStress; libs ("libfieldFunctionObjects.so"); log no; }
    yPlus { type yPlus; libs ("libfieldFunctionObjects.so"); log no; }
}
"""
SOLVER = "{ solver PBiCGStab; preconditioner DILU; tolerance 1e-13; relTol 0; }"


def write_field(case, name, dims, value, wall):
    """At the inlet fixed, at the outlet without gradient."""
    (case.path / "0" / name).write_text(
        f"FoamFile {{ version 2.0; format ascii; class volScalarField; object {name}; }}\n"
        f"dimensions {dims};\ninternalField uniform {value};\nboundaryField\n{{\n"
        f"    left {{ type fixedValue; value uniform {value}; }}\n"
        "    right { type zeroGradient; }\n"
        f'    "bottom|top" {{ type {wall}; value uniform {value}; }}\n'
        "    frontAndBack { type empty; }\n}\n"
    )


def set_model(case, text):
    (case.path / TURBULENCE).write_text(
        "FoamFile { version 2.0; format ascii; class dictionary; object turbulenceProperties; }\n"
        f"{text}\n"
    )


def channel(clone, centres=(), model="kEpsilon", steps=50, delta_t=2e-3, name=None):
    """From left to right between walls; the grains are held where they are."""
    case = grain_box(clone, centres, 0.002, name=name)
    replace(case, "system/blockMeshDict", "(10 10 1)", f"({CELLS[0]} {CELLS[1]} 1)")
    for patch in ("left", "right"):
        begin = f"{patch}\n    {{\n        type    "
        replace(case, "system/blockMeshDict", begin + "wall", begin + "patch")
    case.run("blockMesh")
    ends = (
        f"left {{ type fixedValue; value uniform ({SPEED} 0 0); }} right {{ type zeroGradient; }}"
        ' "bottom|top" { type noSlip; }'
    )
    replace(case, "0/U", f"{WALLS}\n    {{\n        type    noSlip;\n    }}", ends)
    replace(case, "0/U", "uniform (0 0 0)", f"uniform ({SPEED} 0 0)")
    outlet = "right { type fixedValue; value uniform 0; }"
    replace(case, "0/p_rgh", WALLS, f'{outlet} "left|bottom|top"')
    replace(case, GRAINS, "(left right bottom top)", "(bottom top)")
    replace(case, GRAINS, "coupling\n{", "coupling\n{\n    motion fixed;")
    replace(case, "constant/g", "-9.81", "0")
    replace(case, FLUID, "1e-4;", f"{NU};\ntransportModel Newtonian;")
    replace(case, "system/fvSchemes", "    div(tau)", SCHEMES + "    div(tau)")
    replace(case, "system/fvSolution", "    U\n", f'    "(k|epsilon)" {SOLVER}\n    U\n')
    write_field(case, "k", "[0 2 -2 0 0 0 0]", K, "kqRWallFunction")
    write_field(case, "epsilon", "[0 2 -3 0 0 0 0]", EPSILON, "epsilonWallFunction")
    write_field(case, "nut", "[0 2 -1 0 0 0 0]", 0, "nutkWallFunction")
    if model:
        set_model(case, MODELS[model])
    control(case, deltaT=delta_t, endTime=delta_t * steps, writeInterval=steps)
    return case


def test_equals_piso_foam(clone):
    """The same discrete equations: what differs is what the linear solvers leave."""
    ours, theirs = (channel(clone, name=name) for name in ("ours", "theirs"))
    as_piso_foam(theirs)
    set_model(theirs, MODELS["kEpsilon"])
    ours.run("grainFoam")
    theirs.run("pisoFoam")
    bounds = {"U": SPEED, "k": K, "epsilon": EPSILON, "nut": 0.09 * K**2 / EPSILON}
    for name, scale in bounds.items():
        np.testing.assert_allclose(
            ours.field(name), theirs.field(name), rtol=1e-9, atol=1e-10 * scale, err_msg=name
        )
    p = ours.field("p") / RHO
    np.testing.assert_allclose(p, theirs.field("p"), rtol=0, atol=1e-10 * SPEED**2)
    # The model has been at work, and the flow has become another than that without
    assert np.ptp(ours.field("k")) > K / 10
    assert ours.field("nut").min() > NU


def last_numbers(case, name, lines=1):
    """Of the file of a function object."""
    (file,) = (case.path / f"postProcessing/{name}/0").glob(f"*{name}*.dat")
    text = " ".join(file.read_text().splitlines()[-lines:])
    return np.array([float(x) for x in re.findall(r"[-+]?\d[-+.e\d]*", text)])


def test_function_objects_know_the_stress_of_turbulence(clone):
    """Forces, shear and y+ of walls are pisoFoam's."""
    ours, theirs = (channel(clone, name=name) for name in ("ours", "theirs"))
    as_piso_foam(theirs)
    set_model(theirs, MODELS["kEpsilon"])
    for case, rho in ((ours, "rho"), (theirs, f"rhoInf; rhoInf {RHO}")):
        file = case.path / "system/controlDict"
        text = file.read_text()
        file.write_text(text[: text.index("functions")] + AT_WALLS % rho)
    ours.run("grainFoam")
    theirs.run("pisoFoam")
    for name, lines in (("force", 1), ("wallShearStress", 2), ("yPlus", 2)):
        one, other = (last_numbers(case, name, lines) for case in (ours, theirs))
        # The bound of test_equals_piso_foam, through a gradient
        np.testing.assert_allclose(one, other, rtol=1e-8, atol=1e-8 * np.abs(other).max())


YIELDING = """transportModel HerschelBulkley;
HerschelBulkleyCoeffs { nu0 1e-3; tau0 1e-3; k 1e-4; n 0.5; }
"""
FLUIDS = {
    "plain": f"nu {NU};",
    "Newtonian": f"nu {NU}; transportModel Newtonian;",
    "yielding": YIELDING,
}


@pytest.mark.parametrize("fluid", FLUIDS)
def test_function_objects_know_the_stress_of_laminar_flow(clone, fluid):
    """The same without a file of turbulence, whatever makes the viscosity."""
    ours, theirs = (channel(clone, model=None, steps=10, name=name) for name in ("ours", "theirs"))
    as_piso_foam(theirs)
    for case, rho in ((ours, "rho"), (theirs, f"rhoInf; rhoInf {RHO}")):
        file = case.path / "system/controlDict"
        text = file.read_text()
        file.write_text(text[: text.index("functions")] + AT_WALLS % rho)
        file = case.path / FLUID
        text = re.sub(r"(?m)^(nu|transportModel)\s[^;]*;", "", file.read_text())
        same = fluid if case is ours or fluid != "plain" else "Newtonian"
        file.write_text(text + FLUIDS[same])
    ours.run("grainFoam")
    theirs.run("pisoFoam")
    # The bound of test_equals_piso_foam, through a gradient; a viscosity that follows the strain is
    # that of the step's beginning here and of its end there: as much as it changes in a step
    error = 1e-3 if fluid == "yielding" else 1e-8
    for name, lines in (("force", 1), ("wallShearStress", 2), ("yPlus", 2)):
        one, other = (last_numbers(case, name, lines) for case in (ours, theirs))
        np.testing.assert_allclose(one, other, rtol=error, atol=error * np.abs(other).max())


def test_laminar_is_no_file(clone):
    bed = lattice(4, 4, 0.011, (0.03, 0.03))
    plain, *others = (
        channel(clone, bed, model, steps=10, name=str(model))
        for model in (None, "laminar", "Stokes")
    )
    plain.run("grainFoam")
    for other in others:
        other.run("grainFoam")
        assert_same(plain, other)


def test_bed_of_grains(clone):
    """The model's viscosity acts in the flow through grains, and eps k adds up."""
    bed = lattice(5, 8, 0.0105, (0.04, 0.013))
    laminar, turbulent = (
        channel(clone, bed, model, steps=100, name=model) for model in ("laminar", "kEpsilon")
    )
    # No production and no loss but at the ends: of the transport alone
    for case in (laminar, turbulent):
        case.run("grainFoam")
    assert turbulent.field("eps").min() < 0.95
    nut = turbulent.field("nut")
    assert nut.min() > 0
    difference = np.abs(turbulent.field("U") - laminar.field("U")).max()
    assert difference > 1e-2 * SPEED
    assert ledger(turbulent)["transportDefect"].max() <= 1e-12


def test_turbulence_mixes_what_the_fluid_carries(clone):
    """T, a dye and vapour of one molecular and one turbulent diffusivity are the same."""
    case = channel(clone, steps=100)
    D = 1e-6
    with_heat(
        case,
        fluid=f"Cp 1000; kappa {1000 * RHO * D}; Prt 0.5; Sct 0.5; vapour {{ D {D}; }}",
        convection="linear",
    )
    with_psi(case, 0, "", convection="linear")
    file = case.path / FLUID
    file.write_text(f"{file.read_text()}\nscalars {{ dye {{ D {D}; }} }}\n")
    scheme = "    div(phiFluid,dye) Gauss linear;\n"
    replace(case, "system/fvSchemes", "    div(tau)", f"{scheme}    div(tau)")
    replace(case, "system/fvSolution", "    U\n", f"    dye {OF_SCALARS}\n    U\n")
    # Cold and hot at the inlet, half and half
    n = CELLS[1]
    scalars = [("T", "0 0 0 1 0 0 0", 300, 400), ("dye", "0 0 0 0 0 0 0", 0, 1)]
    scalars.append(("psi", *scalars[1][1:]))
    for name, dims, low, high in scalars:
        values = " ".join(repr(float(v)) for v in np.repeat([low, high], n // 2))
        inlet = f"left {{ type fixedValue; value nonuniform List<scalar> {n}({values}); }}"
        others = '"right|bottom|top" { type zeroGradient; } frontAndBack { type empty; }'
        write_scalar(case, name, dims, low, f"{inlet} {others}")
    case.run("grainThermalFoam")
    T = (case.field("T") - 300) / 100
    for name in ("dye", "psi"):
        # What the linear solver leaves of T in 100 steps
        np.testing.assert_allclose(case.field(name), T, rtol=0, atol=1e-9)
    # By D alone the layer would be 0.4 mm wide, in cells of 8 mm
    outlet = T.reshape(n, CELLS[0])[:, -1]
    assert np.abs(np.diff(outlet)).max() < 0.5


@pytest.mark.parallel
@pytest.mark.parametrize("ranks", [2, 4])
def test_ranks_agree(clone, ranks):
    """The solvers' preconditioners are of each rank: what differs is what they leave."""
    bed = lattice(5, 8, 0.0105, (0.04, 0.013))
    one, many = (channel(clone, bed, steps=20, name=name) for name in ("serial", "ranks"))
    one.run("grainFoam")
    replace(many, "system/decomposeParDict", "Subdomains 2", f"Subdomains {ranks}")
    replace(many, "system/decomposeParDict", "(2 1 1)", f"(2 {ranks // 2} 1)")
    many.run("decomposePar")
    many.parallel("grainFoam", ranks)
    many.run("reconstructPar -latestTime")
    bounds = {"U": SPEED, "k": K, "epsilon": EPSILON, "nut": 0.09 * K**2 / EPSILON}
    for name, scale in bounds.items():
        np.testing.assert_allclose(
            one.field(name), many.field(name), rtol=1e-9, atol=1e-9 * scale, err_msg=name
        )
    assert np.ptp(one.field("k")) > K / 10


BAD = {
    # Name: what is wrong, what the message has
    "simulationType": (
        lambda case: set_model(case, "simulationType DNS;"),
        [TURBULENCE, "'simulationType'", "value DNS", "allowed: (laminar RAS LES)"],
    ),
    "noSimulationType": (
        lambda case: set_model(case, "RAS { RASModel kEpsilon; }"),
        [TURBULENCE, "'simulationType'", "missing", "allowed: (laminar RAS LES)"],
    ),
    "viscoelastic": (
        lambda case: set_model(
            case,
            "simulationType laminar;"
            " laminar { laminarModel Maxwell; MaxwellCoeffs { nuM 1; lambda 1; } }",
        ),
        [TURBULENCE, "'laminarModel'", "value Maxwell", "allowed: (Stokes)"],
    ),
    "viscoelasticOfLaterVersions": (
        lambda case: set_model(case, "simulationType laminar; laminar { model Giesekus; }"),
        [TURBULENCE, "'model'", "value Giesekus", "allowed: (Stokes)"],
    ),
    "RAS": (
        lambda case: set_model(case, "simulationType RAS;"),
        [TURBULENCE, "'RAS'", "missing", "allowed: a dictionary"],
    ),
    "RASModel": (
        lambda case: replace(case, TURBULENCE, "RASModel kEpsilon", "RASModel kEpsilom"),
        [TURBULENCE, "RASModel", "kEpsilom", "kEpsilon kOmegaSST"],
    ),
    "noTransportModel": (
        lambda case: replace(case, FLUID, "transportModel Newtonian;", ""),
        [FLUID, "'transportModel'", "missing", "allowed: transportModel Newtonian"],
    ),
    "transportModel": (
        lambda case: replace(case, FLUID, "Newtonian;", "Newtonain;"),
        [FLUID, "'transportModel'", "value Newtonain", "allowed: (", "Newtonian", "powerLaw"],
    ),
    "noK": (lambda case: (case.path / "0/k").unlink(), ["0/k", "cannot find file"]),
    "noNut": (lambda case: (case.path / "0/nut").unlink(), ["0/nut", "cannot find file"]),
}


@pytest.mark.parametrize("name", BAD)
def test_what_a_model_lacks_is_named(clone, name):
    spoil, fragments = BAD[name]
    case = channel(clone, steps=1)
    spoil(case)
    assert case.run("grainFoam", check=False, timeout=60) == 1
    for fragment in fragments:
        assert fragment in case.log, f"no '{fragment}' in\n{case.log[case.log.find('-->') :]}"
    assert "\nTime = " not in case.log

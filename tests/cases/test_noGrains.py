# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Without grains, grainFoam is a plain incompressible solver: the lid-driven cavity."""

import re
from pathlib import Path

import numpy as np
import pytest
from grain_box import DEPTH, control, cyclic_box, grain_box, ledger, replace
from moving_mesh import write

GHIA = Path(__file__).parent / "reference/ghiaCavityRe100.csv"
SIZE = 0.1
LID = 1.0

# 1 m/s2
PUSH = """
push
{
    type            vectorSemiImplicitSource;
    selectionMode   all;
    volumeMode      specific;
    injectionRateSuSp { U ((1000 0 0) 0); }
}
"""


def cavity(clone, cells, nu, delta_t, steps, name=None):
    """The box without grains and without gravity, its top moving to the right."""
    case = grain_box(clone, name=name)
    replace(case, "system/blockMeshDict", "(10 10 1)", f"({cells} {cells} 1)")
    case.run("blockMesh")
    replace(case, "constant/transportProperties", "1e-4", str(nu))
    replace(case, "constant/g", "(0 -9.81 0)", "(0 0 0)")
    lid = f'top {{ type fixedValue; value uniform ({LID} 0 0); }}\n    "left|right|bottom"'
    replace(case, "0/U", '"left|right|bottom|top"', lid)
    control(case, deltaT=delta_t, endTime=delta_t * steps, writeInterval=steps)
    return case


def as_piso_foam(case):
    """The same case for pisoFoam: other names of fields and schemes, a laminar model."""
    zero = case.path / "0"
    pressure = (zero / "p_rgh").read_text().replace("p_rgh", "p")
    (zero / "p").write_text(pressure.replace("[1 -1 -2", "[0 2 -2"))
    (zero / "p_rgh").unlink()
    schemes = case.path / "system/fvSchemes"
    text = schemes.read_text().replace("div(phiEps,U)", "div(phi,U)")
    schemes.write_text(text.replace("div(tau)", "div((nuEff*dev2(T(grad(U)))))"))
    solution = case.path / "system/fvSolution"
    solution.write_text(solution.read_text().replace("p_rgh", "p"))
    transport = case.path / "constant/transportProperties"
    transport.write_text(transport.read_text() + "transportModel Newtonian;\n")
    header = re.match(r"FoamFile\s*\{[^}]*\}", transport.read_text())[0]
    (case.path / "constant/turbulenceProperties").write_text(
        header.replace("transport", "turbulence") + "\nsimulationType laminar;\n"
    )
    case.dict_set("system/controlDict", "functions", "{}")


@pytest.mark.parametrize("correctors", [2, 3])
def test_equals_piso_foam(clone, correctors):
    """The same discrete equations: what differs is what the linear solvers leave.

    100 m across, so that what OpenFOAM's limiter adds to fluxes, 1e-15 m3/s, is nothing.
    """
    cases = [cavity(clone, 16, 1.0, 2.0, 50, name) for name in ("ours", "theirs")]
    ours, theirs = cases
    as_piso_foam(theirs)
    for case, solver in ((ours, "grainFoam"), (theirs, "pisoFoam")):
        replace(case, "system/blockMeshDict", "\nvertices", "\nscale 1000;\nvertices")
        case.run("blockMesh")
        replace(case, "system/fvSolution", "nCorrectors     2", f"nCorrectors     {correctors}")
        case.run(solver)
    assert ours.times[-1] == theirs.times[-1] == "100"

    # 50 steps of residuals 1e-12, relative to the lid's speed and to rho LID^2
    np.testing.assert_allclose(ours.field("U"), theirs.field("U"), rtol=0, atol=1e-12 * LID)
    p = ours.field("p") / 1000
    np.testing.assert_allclose(p, theirs.field("p"), rtol=0, atol=1e-12 * LID**2)
    assert np.ptp(p) > 0.1 * LID**2
    assert np.all(ledger(ours)["volumeDefect"] == 0)


@pytest.mark.parametrize("scheme", ["Euler", "backward"])
@pytest.mark.parametrize("centres", [[], [(0.05, 0.05)]])
def test_a_fluid_that_is_accelerated_takes_its_flux_along(clone, scheme, centres):
    """With a small grain, too: that of the faces was a tenth too small after 20 steps."""
    case = cyclic_box(clone, centres, radius=1e-4)
    replace(case, "system/fvSchemes", "Euler", scheme)
    write(case, "system/fvOptions", "dictionary", PUSH)
    control(case, deltaT=1e-3, endTime=0.02, writeInterval=20)
    case.run("grainFoam")
    u = case.field("U")[:, 0]
    np.testing.assert_allclose(u, 0.02, rtol=1e-4)
    assert case.flux("right") == pytest.approx(0.02 * SIZE * DEPTH, rel=1e-4)


def test_cavity_at_re_100_agrees_with_ghia(clone):
    cells = 40
    case = cavity(clone, cells, SIZE * LID / 100, 2e-3, 1000)
    case.run("grainFoam")
    u = case.field("U").reshape(cells, cells, 3) / LID
    centres = (np.arange(cells) + 0.5) / cells
    reference = np.genfromtxt(GHIA, delimiter=",", names=True, skip_header=3)

    # Steady to 1e-5 after 20 lid lengths; h^2 |u'''| / 24 of the second-order schemes near the
    # lid, where u falls by one over a tenth of the box, is 0.003 at h = 1/40
    middle = 0.5 * (u[:, cells // 2 - 1, 0] + u[:, cells // 2, 0])
    at = reference["y"]
    inside = (at > centres[0]) & (at < centres[-1])
    error = np.interp(at[inside], centres, middle) - reference["u"][inside]
    assert np.abs(error).max() < 0.005

    # Published copies of v differ by 0.01
    middle = 0.5 * (u[cells // 2 - 1, :, 1] + u[cells // 2, :, 1])
    at = reference["x"]
    inside = (at > centres[0]) & (at < centres[-1])
    error = np.interp(at[inside], centres, middle) - reference["v"][inside]
    assert np.abs(error).max() < 0.01

# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Without grains, grainInterFoam is interFoam, with the fluids carried at the end of a step."""

import numpy as np
import pytest
from grain_box import control, replace, run_whole_and_parts
from moving_mesh import write
from water_box import column, water_box


def as_inter_foam(case):
    write(case, "constant/turbulenceProperties", "dictionary", "simulationType laminar;\n")
    case.dict_set("system/controlDict", "functions", "{}")
    case.dict_set("system/controlDict", "maxAlphaCo", "1")


CONSTANT_ANGLE = "constantAlphaContactAngle; theta0 60"
DYNAMIC_ANGLE = "dynamicAlphaContactAngle; theta0 60; uTheta 0.05; thetaA 80; thetaR 40"


def set_contact_angle(case, angle):
    replace(
        case,
        "0/alpha.water",
        '"left|right|bottom|top" { type zeroGradient; }',
        f'"left|right|top" {{ type zeroGradient; }} bottom {{ type {angle};'
        " limit gradient; value uniform 0; }",
    )


@pytest.mark.parametrize("sigma, angle", [(0, None), (0.07, None), (0.07, CONSTANT_ANGLE)])
def test_equals_inter_foam(clone, sigma, angle):
    steps = 40
    cases = []
    for name in ("ours", "theirs", "before"):
        case = water_box(clone, column(0.033, 0.061), cells=(20, 20), sigma=sigma, name=name)
        if angle:
            set_contact_angle(case, angle)
            # Before the pressure's first solution gravity at such a wall is taken half a cell away
            case.dict_set("system/fvSolution", "PIMPLE/momentumPredictor", "no")
        path = case.path / "system/fvSolution"
        path.write_text(path.read_text().replace("1e-12", "1e-16"))
        end = steps - 1 if name == "before" else steps
        control(case, deltaT=1e-3, endTime=end * 1e-3, writeInterval=end)
        if name != "theirs":
            case.run("grainInterFoam")
        else:
            as_inter_foam(case)
            case.run("interFoam")
        cases.append(case)
    ours, theirs, before = cases
    # Residuals of 1e-16; a contact line makes 2e-7 of a difference of 4e-13 after the first step
    error = 1e-6 if angle else 1e-8
    head, speed = 9.81 * 0.061, np.sqrt(9.81 * 0.061)
    for case, name, unit in (
        (ours, "U", speed), (ours, "p_rgh", 1000 * head), (before, "alpha.water", 1)
    ):
        np.testing.assert_allclose(
            case.field(name), theirs.field(name), rtol=0, atol=error * unit, err_msg=name
        )
    assert np.linalg.norm(ours.field("U"), axis=1).max() > 0.2 * speed


@pytest.mark.parametrize("angle", [CONSTANT_ANGLE, DYNAMIC_ANGLE])
def test_a_restart_goes_on_with_the_angles_at_walls(clone, angle):
    """Reading the fields moved angle and fraction at the wall on by three iterations."""
    whole, parts = (
        water_box(clone, column(0.033, 0.061), cells=(20, 20), sigma=0.07, name=name)
        for name in ("whole", "parts")
    )
    for case in (whole, parts):
        set_contact_angle(case, angle)
        control(case, deltaT=1e-3, endTime=0.04, writeInterval=20)
    run_whole_and_parts(whole, parts, "grainInterFoam", 0.02, 0.04)
    for name in ("U", "p_rgh", "alpha.water"):
        np.testing.assert_array_equal(whole.field(name), parts.field(name), err_msg=name)

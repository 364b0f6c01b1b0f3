# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""A drop at rest by its surface tension, without and with grains in its surface."""

import numpy as np
from grain_box import control, replace
from water_box import SIZE, water_box

GRAINS = "constant/grainProperties"
N, SIGMA = 48, 0.07
H = SIZE / N
DROP, DISC = 16 * H, 4 * H  # radii: 32 and 8 cells in a diameter
MIDDLE = np.array([0.5037, 0.4961]) * SIZE
PLACES = np.radians([25, 140, 262])


def circle(discs):
    """Share of the drop in what discs leave of a cell, by 32 x 32 points."""

    def share(low, high):
        part = (np.arange(32) + 0.5) / 32
        points = low + (high - low) * part[:, None, None]
        x, y = points[:, None, :, 0], points[None, :, :, 1]
        free = np.ones(np.broadcast_shapes(x.shape, y.shape), bool)
        for disc in discs:
            free &= np.hypot(x - disc[0], y - disc[1]) > DISC
        wet = np.hypot(x - MIDDLE[0], y - MIDDLE[1]) < DROP
        left = free.sum(axis=(0, 1))
        inside = (wet & free).sum(axis=(0, 1)) / np.maximum(left, 1)
        return np.where(left > 0, inside, wet.mean(axis=(0, 1)))

    return share


def drop(clone, angle, name):
    """The circle meets fixed discs at the contact angle; without an angle there are none."""
    discs = []
    if angle is not None:
        cosine = np.cos(np.radians(angle))
        away = np.sqrt(DROP**2 + DISC**2 - 2 * DROP * DISC * cosine)
        discs = MIDDLE + away * np.column_stack([np.cos(PLACES), np.sin(PLACES)])
    case = water_box(clone, circle(discs), discs, DISC, (N, N), sigma=SIGMA, name=name)
    replace(case, "constant/g", "-9.81", "0")
    replace(case, GRAINS, "\ncoupling\n{", "\ncoupling\n{ motion fixed;")
    if angle is not None:
        replace(case, GRAINS, "density 2500;", f"density 2500; contactAngle {angle};")
    step = 0.3 * np.sqrt(1001 * H**3 / (4 * np.pi * SIGMA))
    control(case, deltaT=step, endTime=120 * step, writeInterval=20)
    return case


def currents(case):
    """Largest and mean square of the second half of the run [m/s]."""
    times = case.times[1:]
    speeds = [np.linalg.norm(case.field("U", t), axis=1) for t in times[len(times) // 2 :]]
    return np.max(speeds), np.sqrt(np.mean(np.square(speeds)))


def test_discs_in_the_surface_of_a_drop_add_no_current(clone):
    alone = drop(clone, None, "alone")
    alone.run("grainInterFoam")
    together = drop(clone, 90, "together")
    together.run("grainInterFoam")
    (most, mean), (most_alone, mean_alone) = currents(together), currents(alone)
    assert mean <= 0.75 * mean_alone
    assert most <= most_alone

#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Velocity at which the pressure drop carries the bed: minimumFluidisation.py SPEED ...

Reads ours_SPEED and peer_SPEED, prints a table.
"""

import sys

import grainplot
import numpy as np

D, RHO, MU, RHO_P, G = 2.5e-3, 1.2, 1.2e-5, 2526.0, 9.81
AREA = 0.15 * 0.015
WEIGHT = 24750 * np.pi / 6 * D**3 * (RHO_P - RHO) * G / AREA
ROWS, ROW = 90, 60
AR = RHO * (RHO_P - RHO) * G * D**3 / MU**2


def rows(case, name):
    """Mean of the cells of each row, from below."""
    time = grainplot.times(case)[-1]
    return grainplot.read_field(case, time, name).reshape(ROWS, ROW).mean(axis=1)


def drop(case, name, factor):
    """Pressure at the bottom [Pa]."""
    pressure = factor * rows(case, name)
    return 1.5 * pressure[0] - 0.5 * pressure[1]


def root(a, b, c):
    """The positive x with a x + b x^2 = c."""
    return (np.sqrt(a**2 + 4 * b * c) - a) / (2 * b)


def carries(speed, drops):
    """Where a u + b u^2, fitted to the drops, is the bed's weight [m/s]."""
    a, b = np.linalg.lstsq(np.column_stack([speed, speed**2]), drops, rcond=None)[0]
    return root(a, b, WEIGHT)


def ergun(eps):
    """Minimum fluidisation after Ergun (1952) in a bed of this fluid fraction [m/s]."""
    return root(150 * (1 - eps) / eps**3, 1.75 / eps**3, AR) * MU / (RHO * D)


def main():
    speed = np.array(sys.argv[1:], dtype=float)
    ours = np.array([drop(f"ours_{u}", "p_rgh", 1) for u in sys.argv[1:]])
    peer = np.array([drop(f"peer_{u}", "p", RHO) for u in sys.argv[1:]])
    eps = rows(f"ours_{sys.argv[1]}", "eps")
    inside = eps[2 : np.argmax(eps > 0.6) - 2].mean()
    print("| velocity [m/s] | grainFoam: drop / weight | DPMFoam |\n|---|---|---|")
    for u, p, q in zip(speed, ours, peer, strict=True):
        print(f"| {u} | {p / WEIGHT:.4f} | {q / WEIGHT:.4f} |")
    print("\n| minimum fluidisation | m/s |\n|---|---|")
    print(f"| grainFoam | {carries(speed, ours):.3f} |")
    print(f"| DPMFoam | {carries(speed, peer):.3f} |")
    print(f"| Ergun (1952), fluid fraction {inside:.3f} of the bed inside | {ergun(inside):.3f} |")
    wenYu = (np.sqrt(33.7**2 + 0.0408 * AR) - 33.7) * MU / (RHO * D)
    print(f"| Wen and Yu (1966) | {wenYu:.3f} |")


main()

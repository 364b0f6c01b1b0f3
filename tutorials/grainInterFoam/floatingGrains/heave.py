# SPDX-FileCopyrightText: 2026 The grainFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Free heave of a half-immersed cylinder on deep water, linear potential flow.

Maskell and Ursell (J. Fluid Mech. 44, 303, 1970) solved it; here it is the inverse transform of
the response with the added mass and damping of Ursell's multipoles (Q. J. Mech. Appl. Math. 2,
218, 1949).  Radius, gravity and density are 1.
"""

import numpy as np

EULER = 0.57721566490153286
MULTIPOLES, ANGLES = 16, 60
# Beyond that wave number the added mass is that of an infinite one, and no waves are made
LARGEST = 20.0


def source(z, K):
    """Integral of exp(-k z)/(k - K) over k, passing below K; Re(z) > 0."""
    w = K * z
    term, total = np.ones_like(w), np.zeros_like(w)
    for n in range(1, 120):
        term = term * w / n
        total += term / n
    return np.exp(-w) * (-EULER - np.log(w) + 1j * np.pi - total)


def coefficients(K):
    """Added mass over the displaced mass, and damping over it times the frequency."""
    theta = (np.arange(ANGLES) + 0.5) * np.pi / 2 / ANGLES
    z = np.exp(-1j * theta)
    values, slopes = [], []
    waves = [source(z, K), source(z.conj(), K)]
    values.append(sum(waves) / 2)
    slopes.append(-((K * z * waves[0] + 1) + (K * z.conj() * waves[1] + 1)) / 2)
    for m in range(1, MULTIPOLES + 1):
        n = 2 * m - 1
        even, odd = np.cos(2 * m * theta), np.cos(n * theta)
        values.append(even + K / n * odd)
        slopes.append(-2 * m * even - K * odd)
    amplitudes, *_ = np.linalg.lstsq(np.array(slopes).T, np.cos(theta) + 0j, rcond=None)
    potential = np.array(values).T @ amplitudes
    # Both halves of the cylinder, pi/2 is the displaced mass
    S = 2 * (potential * np.cos(theta)).sum() * np.pi / 2 / ANGLES / (np.pi / 2)
    return -S.real, -S.imag


def displacement(t):
    """Over the first one, at times in sqrt(radius/gravity) after the release."""
    top = np.sqrt(LARGEST)
    n = 1200
    omega = (np.arange(n) + 0.5) * top / n
    mass = np.pi / 2
    a, b = np.array([coefficients(w**2) for w in omega]).T
    response = -2 / (2 - omega**2 * mass * (1 + a + 1j * b))
    y = 1 + 2 / np.pi * (response.real * np.sin(np.outer(t, omega)) / omega).sum(axis=1) * top / n
    # Of higher frequencies: 2/(mass (1 + a) omega^2)
    far = np.linspace(top, 40 * top, 20000)
    tail = 2 / (mass * (1 + a[-1]) * far**3) * np.sin(np.outer(t, far))
    return y + 2 / np.pi * np.trapezoid(tail, far, axis=1)


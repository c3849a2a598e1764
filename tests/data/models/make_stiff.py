#!/usr/bin/env python3
"""Writes stiff.csv: solutions of two stiff problems, as reference for the method rodas4 of OdeEngine.

Row: problem, time [s], x_1, x_2, x_3 (van der Pol: 0). Robertson's reaction begins at (1, 0, 0), van der Pol's
oscillator with mu = 1000 at (2, 0). scipy's Radau with rtol = 1e-13 and the Jacobian; the last column is the largest
relative difference to rtol = 1e-12, which says how many digits can be relied on. In addition, the values of
Mazzia, Magherini: Test Set for IVP Solvers, release 2.4, 2008, problems ROBER (t = 1e11) and VDPOL (t = 2 in its
scaled time, eps = 1e-6: x_2 is 1000 times ours), which come from other programs.

Run with /usr/bin/python3 (Debian: python3-scipy 1.10.1) in this folder; a minute.
"""
import csv

import numpy
from scipy.integrate import solve_ivp

MU = 1000.0


def robertson(_t, x):
    slow, fast, back = 0.04 * x[0], 3e7 * x[1] * x[1], 1e4 * x[1] * x[2]
    return [back - slow, slow - back - fast, fast]


def robertson_jacobian(_t, x):
    return [[-0.04, 1e4 * x[2], 1e4 * x[1]], [0.04, -1e4 * x[2] - 6e7 * x[1], -1e4 * x[1]], [0.0, 6e7 * x[1], 0.0]]


def van_der_pol(_t, x):
    return [x[1], MU * (1.0 - x[0] * x[0]) * x[1] - x[0]]


def van_der_pol_jacobian(_t, x):
    return [[0.0, 1.0], [-2.0 * MU * x[0] * x[1] - 1.0, MU * (1.0 - x[0] * x[0])]]


PROBLEMS = [
    ("robertson", robertson, robertson_jacobian, [1.0, 0.0, 0.0], 1e-22, [0.4, 4.0, 40.0, 400.0, 4000.0, 1e4, 1e5, 1e11]),
    ("van_der_pol", van_der_pol, van_der_pol_jacobian, [2.0, 0.0], 1e-18, [1.0, 400.0, 800.0, 1000.0, 1600.0, 2000.0]),
]
LITERATURE = [
    ("robertson_literature", 1e11, [0.2083340149701255e-07, 0.8333360770334713e-13, 0.9999999791665050]),
    ("van_der_pol_literature", 2000.0, [0.1706167732170483e1, -0.8928097010247975e-3, 0.0]),
]


def solve(f, jacobian, begin, rtol, atol, times):
    result = solve_ivp(f, [0.0, times[-1]], begin, "Radau", times, jac=jacobian, rtol=rtol, atol=atol)
    assert result.success, result.message
    return result.y.T


with open("stiff.csv", "w", newline="") as file:
    rows = csv.writer(file, lineterminator="\n")
    rows.writerow("problem time x1 x2 x3 uncertainty".split())
    for name, f, jacobian, begin, atol, times in PROBLEMS:
        values = solve(f, jacobian, begin, 1e-13, atol, times)
        rough = solve(f, jacobian, begin, 1e-12, atol, times)
        for time, x, other in zip(times, values, rough):
            difference = max(abs(x - other) / abs(x))
            padded = list(x) + [0.0] * (3 - len(x))
            rows.writerow([name, repr(time)] + [repr(float(v)) for v in padded] + [f"{difference:.1e}"])
    for name, time, x in LITERATURE:
        rows.writerow([name, repr(time)] + [repr(v) for v in x] + ["0"])

#!/usr/bin/env python3
"""Writes blocks.csv: what numpy and scipy give, as reference for the blocks of models/nodes.

A row: case, then the numbers of one sample, inputs first. The cases and their order of numbers are those of
tests/unit/models/blocks_test.cpp and dynamic_blocks_test.cpp.

Run with /usr/bin/python3 (Debian: python3-scipy 1.10.1, python3-numpy 1.24.2) in this folder.
"""
import csv

import numpy as np
from scipy import interpolate, signal

RNG = np.random.default_rng(16)
ROWS = []


def add(case, *columns):
    """Each column: [samples] or [samples, k]."""
    table = np.column_stack(columns)
    ROWS.extend([case, *map(repr, map(float, row))] for row in table)


def noise(n, k=1):
    """In float32, so that both types of number read the same."""
    return RNG.uniform(-2, 2, (n, k)).astype(np.float32).astype(float)


# Reference: amplitude 2, offset 0.5, from 1.5 Hz to 4 Hz in 2 s.
t = np.arange(200) / 100
add("chirp", 0.5 + 2 * signal.chirp(t, 1.5, 2.0, 4.0, phi=-90))

x = np.linspace(-2, 4, 41).astype(np.float32).astype(float)
add("table", x, np.interp(x, [-1, 0, 0.5, 3], [2, 0.1, 1, -7]))

a, b = RNG.uniform(0, 2.5, 30).astype(np.float32).astype(float), noise(30)[:, 0] / 2
grid = interpolate.RegularGridInterpolator(([0, 1, 2.5], [-1, 1]), np.array([[1, 2], [-3, 4], [0.5, 6]]))
add("grid", a, b, grid(np.column_stack([a, b])))

with open("blocks.csv", "w", newline="", encoding="utf-8") as file:
    csv.writer(file, lineterminator="\n").writerows([["case", "numbers"], *ROWS])

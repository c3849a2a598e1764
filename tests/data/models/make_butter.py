#!/usr/bin/env python3
"""Writes butter_sos.csv, butter_symmetric.csv and butter_response.csv: what scipy gives, as reference for ButterworthFilter.

butter_sos.csv, butter_symmetric.csv: one section a row: order, type, low_hz, high_hz (lowpass, highpass: = low_hz), rate_hz,
section, b0, b1, b2, a1, a2 of scipy.signal.butter(order, ..., fs=rate_hz, output="sos").
butter_response.csv: case, sample, impulse, step, noise_in, noise_out of scipy.signal.sosfilt.

Run with /usr/bin/python3 (Debian: python3-scipy 1.10.1, python3-numpy) in this folder.
"""
import csv

import numpy
from scipy.signal import butter, sosfilt

SINGLE = [(60.0, 10.0), (60.0, 0.5), (60.0, 29.5), (100.0, 25.0), (1000.0, 3.0), (30.0, 7.25)]
BANDS = [(60.0, 2.0, 9.0), (60.0, 14.0, 17.5), (100.0, 1.0, 45.0), (1000.0, 49.0, 51.0), (200.0, 0.5, 60.0)]
# Cases of butterworth_test.cpp: name, order, type, corners [Hz], rate [Hz].
RESPONSES = [
    ("low2", 2, "lowpass", [10.0], 60.0),
    ("high3", 3, "highpass", [2.0], 30.0),
    ("band4", 4, "bandpass", [3.0, 8.0], 60.0),
    ("stop8", 8, "bandstop", [5.0, 12.0], 100.0),
]
SAMPLES = 80


def number(x):
    return repr(float(x))


def sections():
    for order in range(1, 9):
        for kind in ("lowpass", "highpass"):
            for rate, corner in SINGLE:
                yield order, kind, corner, corner, rate, butter(order, corner, kind, fs=rate, output="sos")
        for kind in ("bandpass", "bandstop"):
            for rate, low, high in BANDS:
                yield order, kind, low, high, rate, butter(order, [low, high], kind, fs=rate, output="sos")


with open("butter_sos.csv", "w", newline="") as file:
    rows = csv.writer(file, lineterminator="\n")
    rows.writerow("order type low_hz high_hz rate_hz section b0 b1 b2 a1 a2".split())
    for order, kind, low, high, rate, sos in sections():
        for index, (b0, b1, b2, a0, a1, a2) in enumerate(sos):
            assert a0 == 1.0
            rows.writerow([order, kind, number(low), number(high), number(rate), index] + [number(c) for c in (b0, b1, b2, a1, a2)])

random = numpy.random.default_rng(1)
with open("butter_response.csv", "w", newline="") as file:
    rows = csv.writer(file, lineterminator="\n")
    rows.writerow("case sample impulse step noise_in noise_out".split())
    for name, order, kind, corners, rate in RESPONSES:
        sos = butter(order, corners if len(corners) == 2 else corners[0], kind, fs=rate, output="sos")
        impulse = numpy.eye(1, SAMPLES)[0]
        noise = random.uniform(-1.0, 1.0, SAMPLES)
        columns = (sosfilt(sos, impulse), sosfilt(sos, numpy.ones(SAMPLES)), noise, sosfilt(sos, noise))
        for sample, values in enumerate(zip(*columns)):
            rows.writerow([name, sample] + [number(v) for v in values])

# Band filters that are symmetric about a quarter of the rate: scipy orders their sections by rounding errors.
with open("butter_symmetric.csv", "w", newline="") as file:
    rows = csv.writer(file, lineterminator="\n")
    rows.writerow("order type low_hz high_hz rate_hz section b0 b1 b2 a1 a2".split())
    for order in range(1, 9):
        for kind in ("bandpass", "bandstop"):
            for rate, low, high in [(60.0, 10.0, 20.0), (30.0, 7.0, 8.0)]:
                sos = butter(order, [low, high], kind, fs=rate, output="sos")
                for index, (b0, b1, b2, a0, a1, a2) in enumerate(sos):
                    rows.writerow([order, kind, number(low), number(high), number(rate), index] + [number(c) for c in (b0, b1, b2, a1, a2)])

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

x = noise(60)[:, 0]
T, TAU = 0.01, 0.05
add("integral", x, signal.lfilter([T], [1, -1], x), signal.lfilter([0, T], [1, -1], x),
    signal.lfilter([T / 2, T / 2], [1, -1], x))
# From the first sample on: lfilter from a steady state in which the input has been x[0].
b, a = np.array([1, -1]) / (TAU + T), [1, -TAU / (TAU + T)]
add("derivative", x, signal.lfilter(b, a, x, zi=signal.lfilter_zi(b, a) * x[0])[0])
b, a = [0.2, -0.5, 0.3, 0.1], [2.0, -1.2, 0.7]
add("transfer", x, signal.lfilter(b, a, x))
A = np.array([[0.9, 0.2, 0.0], [-0.1, 0.8, 0.05], [0.3, 0.0, 0.7]])
B = np.array([[0.1, 0.0], [0.0, -0.2], [0.05, 0.3]])
C = np.array([[1.0, 0.0, 0.5], [0.0, 2.0, -1.0]])
D = np.array([[0.0, 0.1], [-0.3, 0.0]])
u = noise(60, 2)
add("space", u, signal.dlsim((A, B, C, D, 1.0), u, x0=[0.5, -1.0, 0.25])[1])
lag = signal.cont2discrete(([1.0], [TAU, 1.0]), T, method="zoh")
add("lag", x, signal.lfilter(np.r_[lag[0].ravel()[1:]], lag[1], x))
delayed = np.interp(np.arange(60) - 3.25, np.arange(-5, 60), np.r_[np.full(5, 0.5), x])
add("delay", x, delayed)
add("median", x, [np.median(x[max(0, n - 4):n + 1]) for n in range(60)])

measured, speed = noise(60)[:, 0], noise(60)[:, 0]
estimate = [measured[0]]
for m, s in zip(measured[1:], speed[1:]):
    estimate.append(TAU / (TAU + T) * (estimate[-1] + T * s) + T / (TAU + T) * m)
add("complementary", measured, speed, estimate)

# Observer: with the error dynamics in one matrix, driven by [y[n], u[n]].
y = noise(60, 2)
L = np.array([[0.3, 0.1], [0.0, 0.2], [0.1, -0.1]])
I = np.eye(3)
found = [np.array([0.5, -1.0, 0.25]) @ (I - L @ C).T + L @ y[0]]
for n in range(1, 60):
    found.append((I - L @ C) @ (A @ found[-1] + B @ u[n]) + L @ y[n])
add("observer", y, u, found)

# Kalman filter: all elements at once, with the inverse and Joseph's form.
Q, R, P = np.diag([0.01, 0.02, 0.03]), np.diag([0.1, 0.4]), np.diag([1.0, 2.0, 0.5])
estimate, found = np.array([0.5, -1.0, 0.25]), []
for n in range(60):
    if n > 0:
        estimate, P = A @ estimate + B @ u[n], A @ P @ A.T + Q
    K = P @ C.T @ np.linalg.inv(C @ P @ C.T + R)
    estimate = estimate + K @ (y[n] - C @ estimate)
    P = (I - K @ C) @ P @ (I - K @ C).T + K @ R @ K.T
    found.append(estimate)
add("kalman", y, u, found)

# PID: kp 2, ki 4, kd 0.05, no limit reached; derivative of measured, setpoint and feed-forward as signals.
measured, setpoint, forward = noise(60)[:, 0], noise(60)[:, 0], noise(60)[:, 0]
error = setpoint - measured
add("pid", measured, setpoint, forward, 2 * error + signal.lfilter([4 * T], [1, -1], error)
    - 0.05 / T * np.diff(measured, prepend=measured[0]) + forward)

# Reference table: amplitude 2, offset 0.5 from 0.1 s on; straight lines and steps.
t = np.arange(310) / 100 - 0.1
TIMES, VALUES = [0.255, 0.505, 1.005, 2.495], [1.0, -3.0, 0.25, 7.0]
lines = np.interp(t, TIMES, VALUES)
steps = interpolate.interp1d(TIMES, VALUES, kind="previous", bounds_error=False, fill_value=(1.0, 7.0))(t)
add("reference_table", *(np.where(np.arange(310) < 10, 0.5, 0.5 + 2 * f) for f in (lines, steps)))

# Extended Kalman filter of Pendulum (pendulum_ode.hpp): the derivative of the Runge-Kutta steps by complex
# differences, which round nothing away; all elements at once, with the inverse and Joseph's form.
INERTIA, MASS, LENGTH, DAMPING, MOTOR, RESISTANCE, FRICTION, SLOPE = (
    0.000159931461600856, 0.0508581731919534, 0.0415233722862552, 1.43298488358436e-05, 0.0333391179016334,
    7.73125142447252, 0.000975041213361349, 165.417960777425)


def pendulum(x, volts):
    torque = (MOTOR / RESISTANCE * volts + MASS * 9.81 * LENGTH * np.sin(x[0]) - DAMPING * x[1]
              - MOTOR**2 / RESISTANCE * x[1] - FRICTION * np.tanh(SLOPE / 2 * x[1]))
    return np.array([x[1], torque / INERTIA])


def predicted(x, volts, h=T / 4):
    for _ in range(4):
        k1 = pendulum(x, volts)
        k2 = pendulum(x + h / 2 * k1, volts)
        k3 = pendulum(x + h / 2 * k2, volts)
        k4 = pendulum(x + h * k3, volts)
        x = x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    return x


y, u = noise(60, 2) * [1.0, 4.0], noise(60)
Q, R, P = np.diag([1e-4, 0.5]), np.diag([0.01, 0.4]), np.diag([1.0, 2.0])
I, C = np.eye(2), np.array([[1.0, 0.0], [0.5, 1.0]])
estimate, found = np.array([0.5, -1.0]), []
for n in range(60):
    if n > 0:
        F = np.column_stack([predicted(estimate + 1e-30j * e, u[n, 0]).imag / 1e-30 for e in I])
        estimate, P = predicted(estimate, u[n, 0]), F @ P @ F.T + Q
    K = P @ C.T @ np.linalg.inv(C @ P @ C.T + R)
    estimate = estimate + K @ (y[n] - C @ estimate)
    P = (I - K @ C) @ P @ (I - K @ C).T + K @ R @ K.T
    found.append(estimate)
add("extended_kalman", y, u, found)

with open("blocks.csv", "w", newline="", encoding="utf-8") as file:
    csv.writer(file, lineterminator="\n").writerows([["case", "numbers"], *ROWS])

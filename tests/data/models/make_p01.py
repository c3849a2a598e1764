#!/usr/bin/env python3
"""Writes p01_sim.csv from a recorded run of EAGERx: the tutorials' pendulum on its OdeEngine at 30 Hz.

Argument: p01_pendulum_ode.json.xz. Row: episode, tick of the engine, simulator state theta [rad] and
omega [rad/s] after that tick and the input [V] during the step that led there (float64). Tick 0 is the state
after the reset: no step was made.
"""
import csv
import json
import lzma
import sys

with lzma.open(sys.argv[1]) as file:
    episodes = json.load(file)["node_trace"]["engine"]
with open("p01_sim.csv", "w", newline="") as file:
    rows = csv.writer(file, lineterminator="\n")
    rows.writerow("episode tick theta omega input".split())
    for index, ticks in enumerate(episodes):
        for tick in ticks:
            simulator = tick["sim"]["pendulum"]
            theta, omega = simulator["state"]
            rows.writerow([index, tick["tick"], repr(theta), repr(omega), repr(float(simulator["input"]))])

#!/usr/bin/env python3
"""Graphs with equal chains of nodes: tests/review/joints.py VARIANT [unlike] > graph.yaml
`unlike`: each joint has another parameter, which does nothing, so that none is like another."""
import sys

JOINTS = [f"{leg}_{joint}" for leg in ("front_left", "front_right", "rear_left", "rear_right")
          for joint in ("abduction", "hip", "knee")]


def graph(variant, unlike):
    joints = [f"joint{i}" for i in range(1, 13)] if variant == "numbered" else JOINTS
    nodes, connections, actions = {}, [], []
    target = "actions.all_target" if variant == "shared" else None
    if target:
        actions.append("all_target")
    for j in joints:
        fast = 1000 if variant == "rates" else 500
        setpoint = joints.index(j) if unlike else 0  # used only while no message has come
        kp = 81.0 if variant == "different" and j == joints[5] else 80.0
        chain = {
            f"{j}_smooth": f"{{type: ButterworthFilter, rate: {fast}, config: {{order: 2, cutoff_hz: 100}}}}",
            f"{j}_servo": f"{{type: PidController, rate: 500, config: {{kp: {kp}, setpoint: {setpoint}.0, ki: 10.0, kd: 2.0, low: -25.0, "
                          "high: 25.0}, inputs: [measured, setpoint]}",
            f"{j}_slew": "{type: SlewLimit, rate: 500, config: {per_second: 4000.0}}",
        }
        nodes.update(chain)
        actions += [f"{j}_angle"] + ([] if target else [f"{j}_target"])
        before = joints[joints.index(j) - 1]
        follows = variant == "follows" and j != joints[0]  # each joint's filter reads that of the one before
        connections += [
            (f"{before}_smooth.filtered" if follows else f"actions.{j}_angle", f"{j}_smooth.signal", ""),
            (f"{j}_smooth.filtered", f"{j}_servo.measured", ", window: 3" if variant == "windows" else ""),
            (target or f"actions.{j}_target", f"{j}_servo.setpoint", ""),
            (f"{j}_servo.u", f"{j}_slew.signal", ", skip: true" if variant == "skipped" else ""),
            (f"{j}_slew.limited", f"observations.{j}_torque", ", skip: true"),
        ]
    used = {source.split(".")[1] for source, _, _ in connections if source.startswith("actions.")}
    yield "name: twelve_joints"
    yield "rate: 500"
    yield "nodes:"
    yield from (f"  {name}: {text}" for name, text in nodes.items())
    yield "actions:"
    yield from (f"  {a}: {{space: {{dtype: float32, shape: [1], low: -2.0, high: 2.0}}}}" for a in actions if a in used)
    yield "observations: [" + ", ".join(f"{j}_torque" for j in joints) + "]"
    yield "connections:"
    yield from (f"  - {{from: {a}, to: {b}{more}}}" for a, b, more in connections)
    yield "safety: {outputs: {" + ", ".join(f"{j}_torque: 0.0" for j in joints) + "}}"
    yield "agent: random"


if __name__ == "__main__":
    print("\n".join(graph(sys.argv[1], sys.argv[2:] == ["unlike"])))

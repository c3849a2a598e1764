"""Tunable parameters and variants in Python: tests/compose/tuned.py PROGRAM FOLDER

PROGRAM is that of FOLDER/tuned.yaml. What Env, vectorized VectorEnv and RealTimeEnv set between two steps has the hash that
the program has with `--set NAME=VALUE@STEP`, and `variant=` that of the graph which says the same without variants.
"""
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.dont_write_bytecode = True
sys.path[:0] = [str(ROOT / "tests/environments/stub"), str(ROOT / "targets/environments/python")]

import numpy as np  # noqa: E402

import eagerx_gen  # noqa: E402

PROGRAM, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2])
ZERO = {"load": np.zeros(1, np.float32)}
STEPS = 120


def expect(good, what):
    if not good:
        sys.exit(f"FAILED: {what}")


def expect_problem(kind, text, call, *arguments, **keywords):
    try:
        call(*arguments, **keywords)
    except kind as problem:
        expect(text in str(problem), f"{problem}: not `{text}`")
    else:
        expect(False, f"no problem: {text}")


def hash_of(*options):
    words = [PROGRAM, "--steps", str(STEPS), "--agent", "zero", "--quiet", "--hash", *options]
    return int(subprocess.run(words, capture_output=True, text=True, check=True).stdout.split()[-1], 16)


def run(env, trace=None):
    """Observations of an episode in which two parameters change."""
    if trace is not None:
        env.environments.trace(0, trace)
    seen = [env.reset(seed=3, options={"states": {"controller.kp": 1.0}})[0]]
    for step in range(STEPS):
        if step == 40:
            env.set({"controller.kp": 3.5})
        if step == 70:
            env.set({"target.amplitude": 0.25})
        seen.append(env.step(ZERO)[0])
    return [observation["theta"].copy() for observation in seen]


def main():
    library = eagerx_gen.load(FOLDER / "tuned.yaml", progress=False)
    expect(library.description["tunable"] == ["controller.kp", "half.gain", "target.amplitude"], "what is tunable")
    expect(library.description["lanes"] > 1 and "why_no_lanes" not in library.description, "a graph with `tunable:` runs vectorized")
    wanted = hash_of("--seed", "3", "--set", "controller.kp=1", "--set", "controller.kp=3.5@40", "--set", "target.amplitude=0.25@70")
    env = eagerx_gen.make(library, progress=False)
    expect_problem(eagerx_gen.Error, "nothing has begun", env.set, {"controller.kp": 1.0})
    alone = run(env, FOLDER / "python.trace")
    expect(env.environments.hash(0) == wanted, "Env has the hash of the program")
    env.environments.trace(0, None)
    said = subprocess.run([PROGRAM, "--replay", FOLDER / "python.trace"], capture_output=True, text=True)
    expect(said.returncode == 0, f"replay of what Python has set: {said.stdout}{said.stderr}")
    expect_problem(ValueError, "did you mean 'controller.kp'?", env.set, {"controller.kpp": 1.0})
    expect_problem(ValueError, "can be set at a reset, not while an episode runs", env.set, {"motor.model_state": [0.0, 0.0]})
    expect_problem(ValueError, "parameters is 3, not a dict", env.set, 3)

    envs = eagerx_gen.make(library, num_envs=101, progress=False)
    expect("vectorized: " in envs.environments.stepping(), envs.environments.stepping())
    envs.reset(seed=3, options={"states": {"controller.kp": 1.0}})
    chosen = np.arange(101) % 7 == 0
    for step in range(STEPS):
        if step == 40:
            envs.set({"controller.kp": np.where(chosen, 3.5, 1.0)})
        if step == 70:
            envs.set({"target.amplitude": 0.25}, mask=chosen)
        seen = envs.step({"load": np.zeros((101, 1), np.float32)})[0]["theta"]
        expect(all(np.array_equal(row, alone[step + 1]) for row in seen[chosen]), f"vectorized VectorEnv, step {step}")
    expect(not np.array_equal(seen[1], alone[-1]), "others are as they were")

    real = eagerx_gen.make(FOLDER / "tuned.yaml", real_time_factor=0, progress=False)
    expect(all(map(np.array_equal, run(real), alone)) and real.environments.hash() == wanted, "a program of its own has the same hash")
    expect_problem(ValueError, "can be set at a reset", real.set, {"motor.model_state": [0.0, 0.0]})
    real.close()

    graph = FOLDER / "variants.yaml"
    graph.write_text((FOLDER / "constant.yaml").read_text() + """variants:
  soft: {}
  strong: {nodes: {controller: {config: {kp: 3.5}}, half: {config: {gain: 0.75}}, target: {config: {amplitude: 0.25}}}}
""")
    hashes = {}
    for variant in ("soft", "strong"):
        one = eagerx_gen.make(graph, variant=variant, progress=False)
        one.environments.trace(0, "")
        one.reset(seed=1)
        for _ in range(STEPS):
            one.step(ZERO)
        hashes[variant] = one.environments.hash(0)
    changed = hash_of("--set", "controller.kp=3.5", "--set", "target.amplitude=0.25", "--set", "half.gain=0.75")
    expect(hashes == {"soft": hash_of(), "strong": changed}, f"variants: {hashes}")
    expect_problem(eagerx_gen.Error, "did you mean `strong`?", eagerx_gen.load, graph, variant="strng", progress=False)
    expect_problem(ValueError, "variant is 3, no name of a variant", eagerx_gen.load, graph, variant=3)
    expect_problem(ValueError, "a library is built already", eagerx_gen.load, library.path, variant="soft")


if __name__ == "__main__":
    main()

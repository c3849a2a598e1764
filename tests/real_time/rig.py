"""The robot on the emulated adapter, and the commands of its motor."""
import os
import pathlib
import sys
import time

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE.parent / "environments/stub"), str(HERE.parent / "gymnasium"), str(ROOT / "targets/environments/python")]

import numpy as np  # noqa: E402

import eagerx_gen  # noqa: E402

PERIOD_S = 0.01
LATE = 3  # of robot.yaml
# Declared: the LATE-th step in a row without an action is safe, so it is 0 V before LATE steps after the last observation
# that the agent was given are over.
LIMIT_S = LATE * PERIOD_S
FULL = np.float32([2.0])


class Rig:
    """The robot's environment. Its time is emulated: verdicts do not depend on how busy the machine is."""

    def __init__(self, emulator, program, folder, *, clock="emulated", **keywords):
        self.voltages = pathlib.Path(folder) / "voltages"
        self.voltages.write_text("")
        variables = {"LD_PRELOAD": str(emulator), "EAGERX_EMULATOR": f"voltages={self.voltages}" + (" time=real" if clock == "real" else "")}
        self.env = eagerx_gen.make(program, flatten=True, progress=False, real_time_factor=1, variables=variables, **keywords)

    def seen_s(self):
        """When the latest observation was there."""
        return self.env.environments.time_s

    def commands(self):
        """[commands, (seconds at which its transfer ended, volts)]"""
        return commands_in(self.voltages)


def commands_in(path):
    with open(path) as lines:
        rows = [line.split() for line in lines if line.endswith("\n")]
    return np.array([(int(end) * 1e-9, float(volts)) for _, end, volts in rows]).reshape(-1, 2)


def safe_s(commands, from_s, until_s=np.inf):
    """How long after `from_s` the motor was commanded 0 V for good, or until then; infinite if it was not."""
    commands = commands[commands[:, 0] < until_s]
    pushes = np.flatnonzero(commands[:, 1])
    first = pushes[-1] + 1 if len(pushes) else 0
    return max(commands[first, 0] - from_s, 0.0) if first < len(commands) else np.inf


def is_gone(process):
    """Whether a process has ended; one whose parent has died is waited for by somebody else."""
    try:
        with open(f"/proc/{process}/stat") as stat:
            return stat.read().rsplit(")", 1)[1].split()[0] in "ZX"
    except OSError:
        return True


def agent(how, emulator, program, folder):
    """A process of its own: pushes for 50 steps, says when and to whom, and fails."""
    rig = Rig(emulator, program, folder, clock="real" if how == "resets" else "emulated")
    if how == "resets":
        print(0.0, rig.env.environments.process, flush=True)
    rig.env.reset(seed=1)
    for _ in range(50):
        info = rig.env.step(FULL)[4]
    print(rig.seen_s(), rig.env.environments.process, flush=True)
    if how == "raises":
        raise RuntimeError("the agent's own mistake")
    if how == "exits":
        sys.exit(0)
    if how == "forks":  # a child that lives on must not be taken for the agent
        if os.fork() == 0:
            sys.stdin.read()
        os.kill(os.getpid(), 9)
    for line in sys.stdin:  # stopped or killed while it waits here
        for _ in range(int(line)):
            info = rig.env.step(FULL)[4]
            print(info["late"], info["applied"][0], rig.seen_s(), flush=True)


def careless_agent(emulator, program, folder, episodes, seed):
    """Episodes in each of which it is late once, and says so; then it says when it saw something last, and waits to be ended."""
    rig = Rig(emulator, program, folder)
    generator = np.random.default_rng(int(seed))
    for _ in range(int(episodes)):
        rig.env.reset(seed=int(generator.integers(2**32)))
        late_at, truncated, step = int(generator.integers(0, 1000)), False, 0
        while not truncated:
            *_, truncated, info = rig.env.step(FULL)
            if step == late_at and not truncated:
                time.sleep(generator.exponential(0.04))
                begun = rig.seen_s()
                *_, truncated, info = rig.env.step(FULL)
                print("late", info["late"], begun, rig.seen_s(), flush=True)
            step += 1
        print("episode", step, flush=True)
    rig.env.reset()
    for _ in range(int(generator.integers(1, 300))):
        rig.env.step(FULL)
    print("waits", rig.env.environments.process, rig.seen_s(), flush=True)
    how = sys.stdin.readline().strip()
    if how == "raise":
        raise RuntimeError("the agent's own mistake")


if __name__ == "__main__":
    (careless_agent if sys.argv[1] == "careless" else agent)(*sys.argv[1 + (sys.argv[1] == "careless"):])

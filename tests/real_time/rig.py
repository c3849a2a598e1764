"""The robot on the emulated adapter, and what its motor was told."""
import os
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path[:0] = [str(HERE.parent / "environments/stub"), str(HERE.parent / "gymnasium"), str(ROOT / "targets/environments/python")]

import numpy as np  # noqa: E402

import eagerx_gen  # noqa: E402

PERIOD_S = 0.01
LATE = 3  # of robot.yaml
# Declared: from the last action in time on, the step of that action and LATE steps without one; then a transfer, before
# which an answer of the adapter may have been waited for, as in tests/ftdi.
LIMIT_S = (1 + LATE) * PERIOD_S + 0.013
FULL = np.float32([2.0])


class Rig:
    """The robot's environment. Its time is emulated: verdicts do not depend on how busy the machine is."""

    def __init__(self, emulator, program, folder, *, clock="emulated", **keywords):
        self.voltages = pathlib.Path(folder) / "voltages"
        self.voltages.write_text("")
        variables = {"LD_PRELOAD": str(emulator), "EAGERX_EMULATOR": f"voltages={self.voltages}" + (" time=real" if clock == "real" else "")}
        self.env = eagerx_gen.make(program, flatten=True, progress=False, real_time_factor=1, variables=variables, **keywords)

    def commands(self):
        """[commands, (seconds at which its transfer ended, volts)]"""
        return commands_in(self.voltages)


def commands_in(path):
    with open(path) as lines:
        rows = [line.split() for line in lines if line.endswith("\n")]
    return np.array([(int(end) * 1e-9, float(volts)) for _, end, volts in rows]).reshape(-1, 2)


def last_push_s(commands, until_s=np.inf):
    """When the motor was last told something else than 0 V before then."""
    pushes = commands[(commands[:, 1] != 0.0) & (commands[:, 0] < until_s), 0]
    return pushes[-1] if len(pushes) else 0.0


def is_gone(process):
    """Whether a process has ended; one whose parent has died is waited for by somebody else."""
    try:
        with open(f"/proc/{process}/stat") as stat:
            return stat.read().rsplit(")", 1)[1].split()[0] in "ZX"
    except OSError:
        return True


def agent(how, emulator, program, folder):
    """A process of its own: pushes for 50 steps, says when and to whom, and fails."""
    rig = Rig(emulator, program, folder)
    rig.env.reset(seed=1)
    for _ in range(50):
        info = rig.env.step(FULL)[4]
    print(info["time_s"], rig.env.environments.process, flush=True)
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
            print(info["late"], info["applied"][0], info["time_s"], flush=True)


if __name__ == "__main__":
    agent(*sys.argv[1:])

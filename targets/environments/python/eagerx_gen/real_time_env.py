"""Gymnasium's interface of one environment in real time."""
from __future__ import annotations

from . import checks
from .errors import Error
from .gymnasium_env import Env
from .program import RunningProgram


class RealTimeEnv(Env):
    """One environment of a graph that runs by the clock, in simulation or on real hardware.

    path   of the program, as eagerx-gen's target `linux-sim` makes it
    flatten, normalize_actions, render_mode, render_size    as of Env; render_mode may be "human", a window
    others as of RunningProgram

    info of a step has, besides that of Env:
        late      steps since the observation before that had no action in time. They had the last action, and after
                  `late` of the graph's `safety:` in a row the safe one. reward and terms are the sums of all these steps.
        applied   row of the action that was applied in the last of them, in the graph's units
    environments.time_s: when the observation was there, CLOCK_MONOTONIC
    """

    metadata = {"render_modes": ["human", "rgb_array"]}

    def __init__(self, path, *, flatten=False, normalize_actions=False, render_mode=None, render_size=(480, 480), **running):
        checks.keywords("RealTimeEnv", running, RunningProgram, ("flatten", "normalize_actions"))
        if render_mode not in (None, "human", "rgb_array"):
            raise ValueError(f"render_mode is {render_mode!r}; it is None, 'human' or 'rgb_array'")
        self.environments = RunningProgram(path, render_mode=render_mode, render_size=render_size, **running)
        try:
            self._describe(self.environments.library, flatten, normalize_actions, render_mode, render_size)
        except BaseException:
            self.environments.close()
            raise

    def _info(self, rows):
        return {**super()._info(rows), "late": rows.late, "applied": rows.applied[0].copy()}

    def render(self):
        """The last picture of the graph's `render:`; None without a render mode, or with a window."""
        self.environments.check_open()
        if self.render_mode != "rgb_array":
            return None
        if not self._begun:
            raise Error("nothing has begun: reset() comes before render()")
        return self.environments.picture(0, self.render_size)

"""Gymnasium's interface of one environment."""
from __future__ import annotations

import numpy as np

from . import checks, conversion
from .errors import Error, RewardNotFinite, need
from .library import Environments

gymnasium = need("gymnasium", "pip install gymnasium")


def as_many(action):
    """One action as a batch of one."""
    return {name: np.asarray(part)[None] for name, part in action.items()} if isinstance(action, dict) else np.asarray(action)[None]


class Env(checks.Single, gymnasium.Env):
    """One environment of a graph.

    library            as load() gives it
    flatten            one row of numbers instead of a Dict of observations, and of actions
    longest            steps until an episode is truncated, besides what the graph's `task:` says
    normalize_actions  actions are from -1 to 1
    number             of the environment: reset(seed=S) with number k is `PROGRAM --seed S --environment k`
    render_mode        "rgb_array" where the graph has `render:`: render() gives uint8 [height, width, 3]
    render_size        (width, height) of it, in pixels
    stage              of the graph's task: the name of one of its `stages:`; None: the graph as it is written

    reset(options={"states": {"pendulum.mass": 0.03}}) sets states instead of sampled ones, reset(options={"stage": "near"}) the stage
    from then on, and set({"controller.kp": 3.0})
    tunable parameters between two steps. Without `task:` in the graph rewards
    are 0. info of a step has `success` and the weighted `terms` of the reward, where the graph has a task.
    """

    metadata = {"render_modes": ["rgb_array"]}

    @checks.arguments("Env")
    def __init__(self, library, *, flatten=False, longest=0, normalize_actions=False, number=0, render_mode=None,
                 render_size=(480, 480), stage=None):
        library.check_render_mode(render_mode)
        self._describe(library, flatten, normalize_actions, render_mode, render_size)
        number = checks.whole("number", number, 0, 2**32 - 1)
        self.environments = Environments(library, 1, numbers=[number], longest=longest, autoreset="disabled", threads=1,
                                         pictures=render_mode is not None)
        self.environments.set_stage(stage)

    def _describe(self, library, flatten, normalize_actions, render_mode, render_size):
        """All but `environments`: rows of one environment."""
        self.metadata = library.metadata
        self.library, self.render_mode, self.render_size = library, render_mode, render_size
        self._actions = conversion.of_actions(library, flatten, normalize_actions)
        self._observations = conversion.of_observations(library, flatten)
        self.action_space, self.observation_space = self._actions.space, self._observations.space
        self._begun = self._ended = False
        self._says_critic = bool(library.critic)

    def _observation(self):
        return conversion.one_of(self._observations.from_row(self.environments.observation.copy()), 0)

    @checks.arguments("reset", **checks.OPTIONS)
    def reset(self, *, seed=None, options=None):
        self.environments.check_open()
        seed = None if seed is None else checks.whole("seed", seed, 0, 2**64 - 1)
        options = checks.options(options, ("states", "stage"))
        stage = checks.stage(options.get("stage"), self.library.stages)
        if "states" in options:
            self.environments.set_states(options["states"])
        if "stage" in options:
            self.environments.set_stage(stage)
        super().reset(seed=seed)
        if seed is None and not self._begun:
            seed = int(self.np_random.integers(2**63))
        self.environments.reset(seeds=None if seed is None else [seed])
        self._begun, self._ended = True, False
        return self._observation(), self._seen()

    def set(self, parameters):
        """Sets tunable parameters between two steps: {"controller.kp": 3.0}. They stay until they are set again."""
        self.environments.check_open()
        if not self._begun:
            raise Error("nothing has begun: reset(options={'states': …}) sets parameters before the first step")
        self.environments.set(parameters)

    def step(self, action):
        self.environments.check_open()
        if self._ended:
            raise Error("the episode has ended: reset() comes before the next step")
        rows = self.environments
        self._actions.to_row(as_many(action), rows.action)
        try:
            rows.step()
        except RewardNotFinite:
            self._ended = bool(rows.terminated[0] or rows.truncated[0])
            raise
        terminated, truncated = bool(rows.terminated[0]), bool(rows.truncated[0])
        self._ended = terminated or truncated
        return self._observation(), float(rows.reward[0]), terminated, truncated, self._info(rows)

    def _info(self, rows):
        if not self.library.has_task:
            return {}
        return {"success": bool(rows.success[0]), "terms": {name: float(x) for name, x in zip(self.library.terms, rows.terms[0])},
                **self._seen()}

    def _seen(self):
        """`critic`: what only the critic of a training sees, where the graph's task says so."""
        if not self._says_critic:
            return {}
        return {"critic": {name: rows[0] for name, rows in self.environments.critic().items()}}

    def render(self):
        """The last picture of the graph's `render:`; None without a render mode."""
        self.environments.check_open()
        if self.render_mode is None:
            return None
        if not self._begun:
            raise Error("nothing has begun: reset() comes before render()")
        return self.environments.picture(0, self.render_size)

    def close(self):
        self.environments.close()

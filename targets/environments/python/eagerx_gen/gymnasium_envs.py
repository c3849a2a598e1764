"""Gymnasium's interfaces: one environment, and many."""
from __future__ import annotations

import numpy as np

from . import conversion
from .errors import Error, need
from .library import Environments

gymnasium = need("gymnasium", "pip install gymnasium")
_vector = need("gymnasium.vector", "pip install gymnasium")


def _vector_base():
    if not hasattr(_vector, "AutoresetMode"):
        raise ImportError(f"eagerx_gen's VectorEnv needs Gymnasium 1.1 or later, and this is {gymnasium.__version__}: "
                          "pip install --upgrade gymnasium")
    return _vector.VectorEnv


def one_of(tree, i):
    return {name: part[i] for name, part in tree.items()} if isinstance(tree, dict) else tree[i]


def as_many(action):
    """One action as a batch of one."""
    return {name: np.asarray(part)[None] for name, part in action.items()} if isinstance(action, dict) else np.asarray(action)[None]


class Env(gymnasium.Env):
    """One environment of a graph.

    library            as load() gives it
    flatten            one row of numbers in place of a Dict of observations, and of actions
    longest            steps until an episode is truncated, besides what the graph's `task:` says
    normalize_actions  actions are from -1 to 1
    number             of the environment: reset(seed=S) with number k is `PROGRAM --seed S --environment k`

    reset(options={"states": {"pendulum.mass": 0.03}}) sets states in place of draws. Without `task:` in the graph rewards
    are 0. info of a step has `success` and the weighted `terms` of the reward, where the graph has a task.
    """

    metadata = {"render_modes": []}

    def __init__(self, library, *, flatten=False, longest=0, normalize_actions=False, number=0, render_mode=None):
        if render_mode is not None:
            raise ValueError(f"render_mode is {render_mode!r}, and there is none yet")
        self.library, self.render_mode = library, render_mode
        self._actions = conversion.of_actions(library, flatten, normalize_actions)
        self._observations = conversion.of_observations(library, flatten)
        self.action_space, self.observation_space = self._actions.space, self._observations.space
        self.environments = Environments(library, 1, numbers=[number], longest=longest, autoreset="disabled", threads=1)
        self._begun = self._ended = False

    def _observation(self):
        return one_of(self._observations.from_row(self.environments.observation.copy()), 0)

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        if seed is None and not self._begun:
            seed = int(self.np_random.integers(2**63))
        if options and "states" in options:
            self.environments.set_states(options["states"])
        self.environments.reset(seeds=None if seed is None else np.array([seed % 2**64], np.uint64))
        self._begun, self._ended = True, False
        return self._observation(), {}

    def step(self, action):
        if self._ended:
            raise Error("the episode has ended: reset() comes before the next step")
        rows = self.environments
        self._actions.to_row(as_many(action), rows.action)
        rows.step()
        terminated, truncated = bool(rows.terminated[0]), bool(rows.truncated[0])
        self._ended = terminated or truncated
        info = {}
        if self.library.has_task:
            info = {"success": bool(rows.success[0]),
                    "terms": {name: float(x) for name, x in zip(self.library.terms, rows.terms[0])}}
        return self._observation(), float(rows.reward[0]), terminated, truncated, info

    def close(self):
        self.environments.close()


class VectorEnv(_vector_base()):
    """Many environments of a graph. Environment i after reset(seed=s) is Env after reset(seed=s + i), bit for bit, whatever
    num_envs and threads are.

    autoreset_mode  Gymnasium's AutoresetMode or its value. With DISABLED, reset(options={"reset_mask": ended}) comes
                    before the next step
    threads         0: one for each core
    copy            False: observations are the library's own rows, which the next step writes over
    numbers         [num_envs] of each in its seed; None: all 0, Gymnasium's rule
    others          as for Env
    """

    def __init__(self, library, num_envs, *, flatten=False, longest=0, normalize_actions=False, autoreset_mode=None,
                 threads=0, copy=True, numbers=None, render_mode=None):
        if render_mode is not None:
            raise ValueError(f"render_mode is {render_mode!r}, and there is none yet")
        modes = _vector.AutoresetMode
        self.autoreset_mode = modes.NEXT_STEP if autoreset_mode is None else modes(autoreset_mode)
        names = {modes.NEXT_STEP: "next_step", modes.SAME_STEP: "same_step", modes.DISABLED: "disabled"}
        numbers = np.zeros(num_envs, np.uint32) if numbers is None and num_envs > 0 else numbers
        self.environments = Environments(library, num_envs, numbers=numbers, longest=longest,
                                         autoreset=names[self.autoreset_mode], threads=threads)
        self.library, self.num_envs, self.copy, self.render_mode = library, num_envs, copy, render_mode
        self.metadata = {"render_modes": [], "autoreset_mode": self.autoreset_mode}
        self._actions = conversion.of_actions(library, flatten, normalize_actions)
        self._observations = conversion.of_observations(library, flatten)
        self.single_action_space, self.single_observation_space = self._actions.space, self._observations.space
        batch_space = need("gymnasium.vector.utils", "pip install gymnasium").batch_space
        self.action_space = batch_space(self.single_action_space, num_envs)
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self._ended = np.zeros(num_envs, np.bool_)
        self._begun = np.zeros(num_envs, np.bool_)

    def _observation(self):
        rows = self.environments.observation
        return self._observations.from_row(rows.copy() if self.copy else rows)

    def _seeds(self, seed, mask):
        """[num_envs] and whose seeds are new; where nothing was said, of those that begin for the first time."""
        if seed is None or isinstance(seed, (int, np.integer)):
            seeds = [None if seed is None else int(seed) + i for i in range(self.num_envs)]
        else:
            seeds = list(seed)
            if len(seeds) != self.num_envs:
                raise ValueError(f"there are {len(seeds)} seeds for {self.num_envs} environments")
        drawn = self.np_random.integers(2**63, size=self.num_envs) if None in seeds and not self._begun.all() else seeds
        new = np.array([s is not None for s in seeds]) | ~self._begun
        numbers = np.array([0 if d is None else int(d if s is None else s) % 2**64 for s, d in zip(seeds, drawn)], np.uint64)
        return numbers, new & mask

    def reset(self, *, seed=None, options=None):
        super().reset(seed=int(seed) if isinstance(seed, (int, np.integer)) else None)
        options = options or {}
        mask = self._mask(options)
        if "states" in options:
            self.environments.set_states(options["states"], mask)
        seeds, new = self._seeds(seed, mask)
        if new.any():
            self.environments.reset(new, seeds)
        if (mask & ~new).any():
            self.environments.reset(mask & ~new)
        self._begun |= mask
        self._ended = self._ended & ~mask
        return self._observation(), {}

    def _mask(self, options):
        if "reset_mask" not in options:
            return np.ones(self.num_envs, np.bool_)
        mask = options["reset_mask"]
        if not isinstance(mask, np.ndarray) or mask.shape != (self.num_envs,) or mask.dtype != np.bool_ or not mask.any():
            raise ValueError(f"reset_mask is {mask!r}, not an array of {self.num_envs} bool with one that is True")
        return mask

    def step(self, actions):
        rows, mode = self.environments, self.environments.autoreset
        if mode == "disabled" and np.count_nonzero(self._ended):
            raise Error(f"the episode of environment {int(self._ended.argmax())} has ended: reset() with a reset_mask comes before "
                        "the next step")
        self._actions.to_row(actions, rows.action)
        rows.step()
        before, self._ended = self._ended, rows.terminated | rows.truncated
        info = self._info_of_step(before) if self.library.has_task else {}
        if mode == "same_step" and np.count_nonzero(self._ended):
            self._add_final(info)
        # float64: what Gymnasium's own vector environments give.
        return self._observation(), rows.reward.astype(np.float64), rows.terminated.copy(), rows.truncated.copy(), info

    def _info_of_step(self, ended_before):
        """Gymnasium takes a reset's info, which is empty, where there was one."""
        resets = {"next_step": ended_before, "same_step": self._ended, "disabled": None}[self.environments.autoreset]
        stepped = np.ones(self.num_envs, np.bool_) if resets is None else ~resets
        return self._info(stepped) if np.count_nonzero(stepped) else {}

    def _info(self, mask):
        """What Gymnasium makes of Env's info of the environments of `mask`."""
        rows, terms = self.environments, {}
        for i, name in enumerate(self.library.terms):
            terms[name] = np.where(mask, rows.terms[:, i], 0.0).astype(np.float64)
            terms["_" + name] = mask.copy()
        return {"success": rows.success & mask, "_success": mask.copy(), "terms": terms, "_terms": mask.copy()}

    def _add_final(self, info):
        ended = self._ended
        final = self._observations.from_row(self.environments.final_observation.copy())
        observations = np.full(self.num_envs, None, dtype=object)
        for i in np.flatnonzero(ended):
            observations[i] = one_of(final, i)
        info["final_obs"], info["_final_obs"] = observations, ended.copy()
        info["final_info"] = self._info(ended) if self.library.has_task else {}
        info["_final_info"] = ended.copy()

    def close_extras(self, **kwargs):
        self.environments.close()

from enum import Enum

import numpy as np

from . import utils  # noqa: F401


class AutoresetMode(Enum):
    NEXT_STEP = "NextStep"
    SAME_STEP = "SameStep"
    DISABLED = "Disabled"


class VectorEnv:
    _generator = None

    @property
    def np_random(self):
        if self._generator is None:
            self._generator = np.random.default_rng()
        return self._generator

    def reset(self, *, seed=None, options=None):
        if seed is not None:
            self._generator = np.random.default_rng(seed)

    def close(self):
        self.close_extras()


class SyncVectorEnv(VectorEnv):
    """The three modes as in Gymnasium's documentation, for lists of environments with the same spaces."""

    def __init__(self, makers, autoreset_mode=AutoresetMode.NEXT_STEP):
        self.envs = [make() for make in makers]
        self.num_envs, self.mode = len(self.envs), autoreset_mode
        self.action_space = utils.batch_space(self.envs[0].action_space, self.num_envs)
        self.ended = np.zeros(self.num_envs, bool)
        self.observations = [None] * self.num_envs

    def reset(self, *, seed=None, options=None):
        mask, info = (options or {}).get("reset_mask", np.ones(self.num_envs, bool)), {}
        for i in np.flatnonzero(mask):
            self.observations[i], entry = self.envs[i].reset(seed=None if seed is None else seed + int(i))
            self.add(info, entry, i)
            self.ended[i] = False
        return utils.together(self.observations), info

    def step(self, actions):
        reward, info = np.zeros(self.num_envs), {}
        terminated, truncated = np.zeros(self.num_envs, bool), np.zeros(self.num_envs, bool)
        for i, env in enumerate(self.envs):
            if self.mode is AutoresetMode.NEXT_STEP and self.ended[i]:
                self.observations[i], entry = env.reset()
            else:
                self.observations[i], reward[i], terminated[i], truncated[i], entry = env.step(utils.part(actions, i))
            if self.mode is AutoresetMode.SAME_STEP and (terminated[i] or truncated[i]):
                self.add(info, {"final_obs": self.observations[i], "final_info": entry}, i)
                self.observations[i], entry = env.reset()
            self.add(info, entry, i)
        self.ended = terminated | truncated
        return utils.together(self.observations), reward, terminated, truncated, info

    def add(self, infos, entry, i):
        for key, value in entry.items():
            if isinstance(value, dict) and key != "final_obs":
                self.add(infos.setdefault(key, {}), value, i)
            else:
                if key not in infos:
                    infos[key] = self.empty(key, value)
                infos[key][i] = value
            infos.setdefault("_" + key, np.zeros(self.num_envs, bool))[i] = True

    def empty(self, key, value):
        """Where the values of all environments go."""
        if type(value) in (bool, float) or isinstance(value, np.number):
            return np.zeros(self.num_envs, type(value))
        if isinstance(value, np.ndarray) and key != "final_obs":
            return np.zeros((self.num_envs, *value.shape), value.dtype)
        return np.full(self.num_envs, None, object)

    def close(self):
        for env in self.envs:
            env.close()

"""As much of Stable-Baselines3's interface as eagerx_gen uses, as stub/gymnasium. No part of Stable-Baselines3."""
import numpy as np


class VecEnv:
    def __init__(self, num_envs, observation_space, action_space):
        self.num_envs, self.observation_space, self.action_space = num_envs, observation_space, action_space
        self._reset_seeds()
        self._reset_options()
        assert len(self.get_attr("render_mode")) == num_envs

    def _reset_seeds(self):
        self._seeds = [None] * self.num_envs

    def _reset_options(self):
        self._options = [{} for _ in range(self.num_envs)]

    def seed(self, seed=None):
        first = int(np.random.randint(2**31)) if seed is None else seed
        self._seeds = [first + i for i in range(self.num_envs)]
        return self._seeds

    def set_options(self, options=None):
        self._options = options if isinstance(options, list) else [options or {}] * self.num_envs

    def step(self, actions):
        self.step_async(actions)
        return self.step_wait()

    def _get_indices(self, indices):
        return range(self.num_envs) if indices is None else [indices] if isinstance(indices, int) else indices

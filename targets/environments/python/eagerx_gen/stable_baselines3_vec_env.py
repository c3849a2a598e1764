"""Stable-Baselines3's interface of many environments."""
from __future__ import annotations

import reprlib
import time

import numpy as np

from . import checks, conversion
from .description import spelled, states_row
from .errors import RewardNotFinite, need
from .library import MOST, Environments

_base = need("stable_baselines3.common.vec_env.base_vec_env", "pip install stable-baselines3")


class VecEnv(checks.Single, _base.VecEnv):
    """Many environments of a graph. Its infos have what Monitor gives: return and length of an episode that ended.

    library, longest, threads, normalize_actions, render_mode, render_size, stage: as for Env and VectorEnv. flatten: Stable-Baselines3
    knows Dict observations, with "MultiInputPolicy", but no Dict actions, so that these are always one row. `environments.set_stage(name)`
    sets another stage while a model learns: from the next episode of each on.

    set_options({"states": {"pendulum.mass": 0.03}, "stage": "near"}), or a list of n_envs such dicts, counts at the next reset(),
    as reset(options=…) of Env. Episodes that begin by themselves sample their states again; a stage stays.
    """

    @checks.arguments("VecEnv", num_envs="n_envs is how many environments there are")
    def __init__(self, library, n_envs=1, *, flatten=True, longest=0, threads=0, normalize_actions=False, numbers=None,
                 render_mode=None, render_size=(480, 480), stage=None):
        library.check_render_mode(render_mode)
        n_envs = checks.whole("n_envs", n_envs, 1, MOST)
        numbers = np.zeros(n_envs, np.uint32) if numbers is None else numbers
        self.environments = Environments(library, n_envs, numbers=numbers, longest=longest, autoreset="same_step", threads=threads,
                                         pictures=render_mode is not None)
        self.environments.set_stage(stage)
        self.library, self.render_size = library, render_size
        self.metadata = library.metadata
        self.render_mode = render_mode  # the base class asks for it with get_attr()
        self._rows_of_actions = conversion.of_actions(library, True, normalize_actions)
        self._rows_of_observations = conversion.of_observations(library, flatten)
        self._begun = False
        super().__init__(n_envs, self._rows_of_observations.space, self._rows_of_actions.space)
        self._returns, self._lengths = np.zeros(n_envs), np.zeros(n_envs, int)

    def _observation(self, rows):
        return self._rows_of_observations.from_row(rows.copy())

    def seed(self, seed=None):
        self.environments.check_open()
        return super().seed(None if seed is None else checks.whole("seed", seed, 0, 2**64 - self.num_envs))

    def set_options(self, options=None):
        self.environments.check_open()
        given = [{} if options is None else options] * self.num_envs if options is None or hasattr(options, "keys") else options
        if not isinstance(given, (list, tuple)) or len(given) != self.num_envs:
            raise ValueError(f"options is {reprlib.repr(options)}, not a dict or a list of {self.num_envs} of them")
        for own in given:
            checks.stage(checks.options(own, ("states", "stage")).get("stage"), self.library.stages)
            states_row(self.library, own.get("states", {}), 1)
        super().set_options(options)

    def _set_options(self):
        """The options of set_options(), for the episodes that begin now."""
        given = [dict(own or {}) for own in self._options]
        names = [field.name for field in self.library.states]
        states = [{spelled(name, names): value for name, value in own.get("states", {}).items()} for own in given]
        if any(states):
            fields = [field for field in self.library.states if any(field.name in own for own in states)]
            rows = {field.name: np.full((self.num_envs, *field.shape), np.nan, np.float32) for field in fields}
            for i, own in enumerate(states):
                for name, value in own.items():
                    rows[name][i] = value
            self.environments.set_states(rows, np.array([bool(own) for own in states]))
        for stage in {own["stage"] for own in given if "stage" in own}:
            self.environments.set_stage(stage, np.array(["stage" in own and own["stage"] == stage for own in given]))

    @checks.arguments("reset", seed="call seed(…) before", options="call set_options({…}) before")
    def reset(self):
        self.environments.check_open()
        self._set_options()
        given = list(self._seeds)
        if not self._begun:
            sampled = np.random.default_rng().integers(2**63, size=self.num_envs)
            given = [int(d) if seed is None else seed for seed, d in zip(given, sampled)]
        new = np.array([seed is not None for seed in given])
        if new.any():
            self.environments.reset(new, [0 if seed is None else seed for seed in given])
        if not new.all():
            self.environments.reset(~new)
        self._begun = True
        self._started = time.monotonic()
        self._returns[:], self._lengths[:] = 0.0, 0
        self.reset_infos = self._infos()
        self._reset_seeds()
        self._reset_options()
        return self._observation(self.environments.observation)

    def step_async(self, actions):
        self.environments.check_open()
        self._rows_of_actions.to_row(actions, self.environments.action)

    def step_wait(self):
        rows = self.environments
        problem = None
        try:
            rows.step()
        except RewardNotFinite as made:
            problem = made
        self._returns += rows.reward
        self._lengths += 1
        ended = rows.terminated | rows.truncated
        if problem is not None:
            self._returns[ended], self._lengths[ended] = 0.0, 0
            raise problem
        infos = self._infos()
        if ended.any():
            final = self._observation(rows.final_observation)
            critic = rows.critic(final=True) if self.library.critic else {}
            for i in np.flatnonzero(ended):
                infos[i] |= self._info_of_end(i, final)
                if critic:
                    infos[i]["terminal_critic"] = conversion.one_of(critic, i)
            self._returns[ended], self._lengths[ended] = 0.0, 0
        return self._observation(rows.observation), rows.reward.copy(), ended, infos

    def _infos(self):
        """`critic` for each environment, where the graph's task says what only the critic of a training sees."""
        if not self.library.critic:
            return [{} for _ in range(self.num_envs)]
        return [{"critic": seen} for seen in conversion.each_of(self.environments.critic())]

    def _info_of_end(self, i, final):
        rows = self.environments
        info = {
            "terminal_observation": {name: part[i] for name, part in final.items()} if isinstance(final, dict) else final[i],
            "TimeLimit.truncated": bool(rows.truncated[i] and not rows.terminated[i]),
            "episode": {"r": float(self._returns[i]), "l": int(self._lengths[i]), "t": time.monotonic() - self._started},
        }
        if self.library.has_task:
            info["is_success"] = bool(rows.success[i])
        return info

    def close(self):
        self.environments.close()

    def get_images(self):
        """The pictures of all environments, of which Stable-Baselines3's render() makes one."""
        self.environments.check_open()
        return [None if self.render_mode is None else self.environments.picture(i, self.render_size) for i in range(self.num_envs)]

    def get_attr(self, attr_name, indices=None):
        self.environments.check_open()
        values = {"spec": None}
        value = values[attr_name] if attr_name in values else getattr(self, attr_name)
        return [value for _ in self._indices(indices)]

    def _indices(self, indices):
        self.environments.check_open()
        if indices is None:
            return range(self.num_envs)
        many = [indices] if np.ndim(indices) == 0 else indices
        return [checks.whole("index", i, -self.num_envs, self.num_envs - 1) for i in many]

    def set_attr(self, attr_name, value, indices=None):
        self.environments.check_open()
        raise AttributeError(f"environments of a batch have no attributes of their own, so no {attr_name!r} is set")

    def env_method(self, method_name, *method_args, indices=None, **method_kwargs):
        self.environments.check_open()
        raise AttributeError(f"environments of a batch have no methods of their own, so there is no {method_name!r}")

    def env_is_wrapped(self, wrapper_class, indices=None):
        name = getattr(wrapper_class, "__name__", None)
        return [name == "Monitor" for _ in self._indices(indices)]

"""Gymnasium's interface of many environments."""
from __future__ import annotations

import reprlib

import numpy as np

from . import checks, conversion
from .errors import Error, RewardNotFinite, need
from .library import MOST, Environments

_vector = need("gymnasium.vector", "pip install gymnasium")
if not hasattr(_vector, "AutoresetMode"):
    raise ImportError("eagerx_gen's VectorEnv needs Gymnasium 1.1 or later: pip install --upgrade gymnasium")


_FLOAT64 = np.dtype(np.float64)


def is_any(flags):
    """flags.any() of an array of bool, without its overhead."""
    return b"\1" in flags.tobytes()


class VectorEnv(checks.Single, _vector.VectorEnv):
    """Many environments of a graph. Environment i after reset(seed=s) is Env after reset(seed=s + i), bit for bit, whatever
    num_envs and threads are.

    autoreset_mode  Gymnasium's AutoresetMode or its value. With DISABLED, reset(options={"reset_mask": ended}) comes
                    before the next step
    threads         0: one for each core
    copy            False: observations are the library's own rows, which the next step writes over
    numbers         [num_envs] of each in its seed; None: all 0, Gymnasium's rule
    others          as for Env
    """

    @checks.arguments("VectorEnv", n_envs="num_envs is how many environments there are")
    def __init__(self, library, num_envs, *, flatten=False, longest=0, normalize_actions=False, autoreset_mode=None,
                 threads=0, copy=True, numbers=None, render_mode=None, render_size=(480, 480), stage=None):
        library.check_render_mode(render_mode)
        modes = _vector.AutoresetMode
        self.autoreset_mode = modes.NEXT_STEP if autoreset_mode is None else modes(autoreset_mode)
        names = {modes.NEXT_STEP: "next_step", modes.SAME_STEP: "same_step", modes.DISABLED: "disabled"}
        num_envs = checks.whole("num_envs", num_envs, 1, MOST)
        numbers = np.zeros(num_envs, np.uint32) if numbers is None else numbers
        self.environments = Environments(library, num_envs, numbers=numbers, longest=longest,
                                         autoreset=names[self.autoreset_mode], threads=threads,
                                         pictures=render_mode is not None)
        self.environments.set_stage(stage)
        self.library, self.num_envs, self.copy = library, num_envs, copy
        self.render_mode, self.render_size = render_mode, render_size
        self.metadata = {**library.metadata, "autoreset_mode": self.autoreset_mode}
        self._actions = conversion.of_actions(library, flatten, normalize_actions)
        self._observations = conversion.of_observations(library, flatten)
        self.single_action_space, self.single_observation_space = self._actions.space, self._observations.space
        batch_space = need("gymnasium.vector.utils", "pip install gymnasium").batch_space
        self.action_space = batch_space(self.single_action_space, num_envs)
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self._none = np.zeros(num_envs, np.bool_)  # which nothing changes
        self._ended = self._none
        self._begun = np.zeros(num_envs, np.bool_)

        self._take_rows()

    def _take_rows(self):
        """Looks up attributes that steps need once, which saves some tenths of a microsecond per step."""
        rows, mode = self.environments, self.environments.autoreset
        self._is_next_step, self._is_same_step, self._must_reset = (mode == each for each in ("next_step", "same_step", "disabled"))
        self._action_rows, self._observation_rows, self._reward = rows.action, rows.observation, rows.reward
        self._terminated, self._truncated, self._success, self._terms = rows.terminated, rows.truncated, rows.success, rows.terms
        self._has_task, self._says_critic = self.library.has_task, bool(self.library.critic)
        self._term_names = tuple(self.library.terms)
        self._term_masks = tuple("_" + name for name in self._term_names)
        self._to_row, self._from_row = self._actions.to_row, self._observations.from_row
        self._all = np.ones(self.num_envs, np.bool_)

    def _observation(self):
        rows = self._observation_rows
        return self._observations.from_row(rows.copy() if self.copy else rows)

    def _given(self, seed):
        """[num_envs] the seed of each, or None."""
        if seed is None:
            return [None] * self.num_envs
        if np.ndim(seed) == 0:
            first = checks.whole("seed", seed, 0, 2**64 - self.num_envs)
            return [first + i for i in range(self.num_envs)]
        if len(seed) != self.num_envs:
            raise ValueError(f"there are {len(seed)} seeds for {self.num_envs} environments")
        return [None if s is None else checks.whole(f"seed[{i}]", s, 0, 2**64 - 1) for i, s in enumerate(seed)]

    def _seeds(self, given, mask):
        """[num_envs] and whose seeds are new; where nothing was said, of those that begin for the first time."""
        sampled = self.np_random.integers(2**63, size=self.num_envs) if None in given and not self._begun.all() else given
        new = np.array([s is not None for s in given]) | ~self._begun
        return [0 if d is None else int(d) if s is None else s for s, d in zip(given, sampled)], new & mask

    @checks.arguments("reset", reset_mask="give options={'reset_mask': …}", **checks.OPTIONS)
    def reset(self, *, seed=None, options=None):
        self.environments.check_open()
        given, options = self._given(seed), checks.options(options, ("states", "stage", "reset_mask"))
        mask, stage = self._mask(options), checks.stage(options.get("stage"), self.library.stages)
        if "states" in options:
            self.environments.set_states(options["states"], mask)
        if "stage" in options:
            self.environments.set_stage(stage, mask)
        super().reset(seed=int(seed) if seed is not None and np.ndim(seed) == 0 else None)
        seeds, new = self._seeds(given, mask)
        if new.any():
            self.environments.reset(new, seeds)
        if (mask & ~new).any():
            self.environments.reset(mask & ~new)
        self._begun |= mask
        self._ended = self._ended & ~mask
        info = {}
        self._add_critic(info, mask)
        return self._observation(), info

    def _mask(self, options):
        if "reset_mask" not in options:
            return np.ones(self.num_envs, np.bool_)
        mask = options["reset_mask"]
        if not isinstance(mask, np.ndarray) or mask.shape != (self.num_envs,) or mask.dtype != np.bool_ or not mask.any():
            raise ValueError(f"reset_mask is {reprlib.repr(mask)}, not an array of {self.num_envs} bool with one that is True")
        return mask

    def set(self, parameters, mask=None):
        """Sets tunable parameters between two steps: {"controller.kp": 3.0, or [num_envs, ...]}, where `mask` [num_envs] is true.

        They stay until they are set again.
        """
        self.environments.check_open()
        if not self._begun.all():
            raise Error("not all environments have begun: reset(options={'states': …}) sets parameters before the first step")
        self.environments.set(parameters, mask)

    def step(self, actions):
        rows = self.environments
        if self._must_reset and is_any(self._ended):
            rows.check_open()
            raise Error(f"the episode of environment {int(self._ended.argmax())} has ended: reset() with a reset_mask comes before "
                        "the next step")
        self._to_row(actions, self._action_rows)
        try:
            rows.step()
        except RewardNotFinite:
            self._ended = rows.terminated | rows.truncated
            raise
        before, terminated, truncated = self._ended, self._terminated.copy(), self._truncated.copy()
        ends = b"\1" in terminated.tobytes() or b"\1" in truncated.tobytes()  # is_any() of each, without two calls
        self._ended = ended = terminated | truncated if ends else self._none
        if not self._has_task:
            info = {}
        elif before is ended is self._none:  # nothing ends or begins, as in most steps
            info = self._info(self._all.copy())
        else:
            info = self._info_of_step(before)
        if self._says_critic:
            self._add_critic(info)
        if ends and self._is_same_step:
            self._add_final(info)
        seen = self._observation_rows
        # float64: what Gymnasium's own vector environments give.
        return self._from_row(seen.copy() if self.copy else seen), self._reward.astype(_FLOAT64), terminated, truncated, info

    def _info_of_step(self, ended_before):
        """Gymnasium takes a reset's info, which is empty, where there was one."""
        resets = ended_before if self._is_next_step else self._ended if self._is_same_step else None
        if resets is None or not is_any(resets):
            return self._info(self._all.copy())
        return {} if b"\0" not in resets.tobytes() else self._info(~resets, resets)

    def _info(self, mask, others=None):
        """The info of the environments in `mask`, as Gymnasium combines it; all keys share the mask's array. others: ~mask, if any.

        One conversion for all terms: one for each would cost more than the rest of a step.
        """
        success, terms = self._success.copy(), self._terms.astype(_FLOAT64).T
        if others is not None:
            success &= mask
            np.copyto(terms, 0.0, where=others)
        return {"success": success, "_success": mask, "terms": {**dict(zip(self._term_names, terms)), **dict.fromkeys(self._term_masks, mask)},
                "_terms": mask}

    def _add_critic(self, info, mask=None, final=False):
        """Adds the critic's inputs to the info, if the graph's task has any; also after a reset. mask None: all environments."""
        if not self._says_critic:
            return
        seen = self.environments.critic(final)
        if mask is None:
            mask = self._all.copy()
        else:
            mask = mask.copy()
            for rows in seen.values():
                rows[~mask] = 0
        info["critic"], info["_critic"] = {**seen, **{"_" + name: mask for name in seen}}, mask

    def _add_final(self, info):
        ended = self._ended
        places = np.flatnonzero(ended)
        final = self._observations.from_row(self.environments.final_observation[places])
        observations = np.full(self.num_envs, None, dtype=object)
        for place, observation in zip(places.tolist(), conversion.each_of(final)):
            observations[place] = observation
        info["final_obs"], info["_final_obs"] = observations, ended.copy()
        info["final_info"] = self._info(ended.copy(), ~ended) if self._has_task else {}
        self._add_critic(info["final_info"], ended, final=True)
        info["_final_info"] = ended.copy()

    def render(self):
        """A tuple of the pictures of all environments; None without a render mode."""
        self.environments.check_open()
        if self.render_mode is None:
            return None
        if not self._begun.all():
            raise Error("not all environments have begun: reset() comes before render()")
        return tuple(self.environments.picture(i, self.render_size) for i in range(self.num_envs))

    def close_extras(self, **kwargs):
        self.environments.close()

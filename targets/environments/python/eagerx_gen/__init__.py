"""Environments of graphs that eagerx-gen compiled: for Gymnasium, for Stable-Baselines3, or as plain numpy rows.

    import eagerx_gen
    env = eagerx_gen.make("graph.yaml")                        # gymnasium.Env
    envs = eagerx_gen.make("graph.yaml", num_envs=4096)        # gymnasium.vector.VectorEnv
    envs = eagerx_gen.make_vec_env("graph.yaml", n_envs=64)    # stable_baselines3's VecEnv

Gymnasium and Stable-Baselines3 are imported when they are needed. `Environments(load("graph.yaml"), 4096)` needs neither.
"""
import sys

from .build import load
from .errors import Error, RewardNotFinite
from .library import VERSION, Environments, Library

__all__ = ["VERSION", "Environments", "Error", "Library", "RewardNotFinite", "load", "make", "make_vec_env"]

_BUILDING = ("engine", "paths", "progress")


def _split(keywords):
    return ({name: value for name, value in keywords.items() if name in _BUILDING},
            {name: value for name, value in keywords.items() if name not in _BUILDING})


_said = set()


def _say_stepping(made, progress=True, **_building):
    """One line on the standard error, once for many that are alike."""
    environments = made.environments
    line = f"{environments.library.description['graph']}: {environments.count} " \
           f"{'environment steps' if environments.count == 1 else 'environments step'} {environments.stepping()}"
    if progress and line not in _said:
        print(line, file=sys.stderr, flush=True)
    _said.add(line)
    return made


def make(graph, num_envs=None, **keywords):
    """An `Env` (num_envs=None) or a `VectorEnv` of a graph's file, or of a library that is built already (`*.so`).

    `engine`, `paths` and `progress` are those of load(); all others go to Env or VectorEnv. Unless `progress` is False, a
    line on the standard error says whether environments step in packs, and if not, why.
    """
    building, rest = _split(keywords)
    if num_envs is None:
        from .gymnasium_env import Env

        return _say_stepping(Env(load(graph, **building), **rest), **building)
    from .gymnasium_vector import VectorEnv

    return _say_stepping(VectorEnv(load(graph, **building), num_envs, **rest), **building)


def make_vec_env(graph, n_envs=1, **keywords):
    """The same as Stable-Baselines3's VecEnv."""
    from .stable_baselines3_vec_env import VecEnv

    building, rest = _split(keywords)
    return _say_stepping(VecEnv(load(graph, **building), n_envs, **rest), **building)

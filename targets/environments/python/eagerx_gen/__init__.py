"""Environments of graphs that eagerx-gen compiled: for Gymnasium, for Stable-Baselines3, or as plain numpy rows.

    import eagerx_gen
    env = eagerx_gen.make("graph.yaml")                        # gymnasium.Env
    envs = eagerx_gen.make("graph.yaml", num_envs=4096)        # gymnasium.vector.VectorEnv
    envs = eagerx_gen.make_vec_env("graph.yaml", n_envs=64)    # stable_baselines3's VecEnv
    env = eagerx_gen.make("graph.yaml", real_time_factor=1)    # gymnasium.Env that runs by the clock

Gymnasium and Stable-Baselines3 are imported when they are needed. `Environments(load("graph.yaml"), 4096)` needs neither.
"""
import os
import sys

from . import build, checks
from .build import checked, is_program, load, moves_hardware
from .errors import Error, RewardNotFinite
from .library import VERSION, Environments, Library

__all__ = ["VERSION", "Environments", "Error", "Library", "RewardNotFinite", "load", "make", "make_vec_env"]

_BUILDING = ("engine", "paths", "progress", "variant")
_IN_REAL_TIME = ("publish", "publish_only", "publish_rate", "trace", "variables")


def _split(keywords):
    return ({name: value for name, value in keywords.items() if name in _BUILDING},
            {name: value for name, value in keywords.items() if name not in _BUILDING})


# Arguments of Gymnasium's make() and make_vec(), and of Stable-Baselines3's make_vec_env().
_THEIRS = {"env_kwargs": "give its arguments themselves", "max_episode_steps": "longest is how many steps an episode has at most",
           "wrappers": "wrap what it returns", "wrapper_class": "wrap what it returns"}
_INSTEAD = {"n_envs": "make(graph, num_envs=…) makes a Gymnasium VectorEnv, make_vec_env(graph, n_envs=…) Stable-Baselines3's VecEnv",
            "seed": "give it to reset(seed=…) of what it returns",
            "vectorization_mode": "environments of a VectorEnv step in one process; threads is how many step at once",
            "vector_kwargs": "give its arguments themselves", **_THEIRS}
_INSTEAD_OF_VEC = {"num_envs": "n_envs is how many environments there are", "seed": "call seed(…) of what it returns",
                   "monitor_dir": "its infos have what Monitor gives; wrap what it returns in VecMonitor for a file",
                   "vec_env_cls": "its environments step in one process; threads is how many step at once",
                   "vec_env_kwargs": "give its arguments themselves", **_THEIRS}


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


def _with_program(start, graph, building):
    """Calls start(path) with the program of a graph, which it builds unless `graph` is a program."""
    engine, variant = building.get("engine"), building.get("variant")
    graph, paths = checked(graph, engine, building.get("paths", ()), variant)
    if is_program(graph):
        if variant is not None:
            raise ValueError("variant: a program is built already; give the graph's file")
        return start(graph)
    return build.build(graph, engine, paths, building.get("progress", True), variant, target="linux-sim", ending=".program",
                       opened=lambda path: start(str(path)))


def _is_real(graph, building):
    if isinstance(graph, Library):
        return False
    engine, variant = building.get("engine"), building.get("variant")
    graph, paths = checked(graph, engine, building.get("paths", ()), variant)
    return is_program(graph) or not graph.endswith(".so") and moves_hardware(graph, engine, paths, variant)


def make(graph, num_envs=None, *, real_time_factor=None, **keywords):
    """An `Env` (num_envs=None) or a `VectorEnv` of a graph's file, or of a library that is built already (`*.so`).

    `engine`, `paths`, `progress` and `variant` are those of load(); all others go to Env or VectorEnv. Unless `progress` is False, a
    line on the standard error says whether environments step vectorized, and if not, why.

    real_time_factor  a `RealTimeEnv`, which runs by the clock: the number of simulated seconds a second. With an engine of
                      real hardware it is always one. A program for Linux that is built already can take the graph's place.
    """
    building, rest = _split(keywords)
    if num_envs is None:
        from .gymnasium_env import Env

        checks.keywords("make", rest, Env, (*_BUILDING, *_IN_REAL_TIME, "num_envs", "real_time_factor"), _INSTEAD)
    if real_time_factor is not None or _is_real(graph, building):
        if num_envs is not None:
            raise ValueError(f"num_envs is {num_envs!r}: in real time, and on real hardware, there is one environment; leave num_envs out")
        if isinstance(graph, Library) or os.fsdecode(graph).endswith(".so"):
            raise ValueError("real_time_factor: a library has no clock; give the graph's file")
        from .real_time_env import RealTimeEnv

        checks.keywords("make", rest, RealTimeEnv, (*_BUILDING, *_IN_REAL_TIME, "longest", "number", "real_time_factor"), _INSTEAD)
        rest["real_time_factor"] = 1.0 if real_time_factor is None else real_time_factor
        return _say_stepping(_with_program(lambda path: RealTimeEnv(path, **rest), graph, building), **building)
    for name in _IN_REAL_TIME:
        if name in rest:
            raise ValueError(f"{name} is for environments in real time: give real_time_factor=1, too")
    if num_envs is None:
        return _say_stepping(Env(load(graph, **building), **rest), **building)
    from .gymnasium_vector import VectorEnv

    checks.keywords("make", rest, VectorEnv, (*_BUILDING, "real_time_factor"), _INSTEAD)
    return _say_stepping(VectorEnv(load(graph, **building), num_envs, **rest), **building)


def make_vec_env(graph, n_envs=1, **keywords):
    """The same as Stable-Baselines3's VecEnv."""
    if "real_time_factor" in keywords:
        raise ValueError("real_time_factor: in real time there is one environment; give Stable-Baselines3 that of make()")
    from .stable_baselines3_vec_env import VecEnv

    building, rest = _split(keywords)
    checks.keywords("make_vec_env", rest, VecEnv, _BUILDING, _INSTEAD_OF_VEC)
    return _say_stepping(VecEnv(load(graph, **building), n_envs, **rest), **building)

"""Wrong calls of the Python package, of its wrappers and of the C functions, and right ones next to them (see misuse)."""
import copy
import ctypes
import os
import pickle
import threading

import numpy as np

import eagerx_gen
from eagerx_gen.gymnasium_env import Env
from eagerx_gen.gymnasium_vector import VectorEnv
from eagerx_gen.library import _Options, _Rows
from eagerx_gen.stable_baselines3_vec_env import VecEnv

KINDS = (ValueError, eagerx_gen.Error, AttributeError)
"""Exceptions that a wrong call may raise. AttributeError: for attributes that are read-only or do not exist."""

MODES = ("next_step", "same_step", "disabled")


class Odd:
    def __repr__(self):
        return "x" * 10_000


ODDITIES = (0.5, float("nan"), float("inf"), "3", "\0", b"x", [], {}, Odd(), 1j, np.float32(2), np.array([1, 2]), True, np.zeros((2, 2)),
            [[1], [1, 2]], object, set())


def anything(rng):
    return rng.choice((*ODDITIES, None, 0, 1, -1, 2**33, 2**70, -(2**70), [True] * 3, np.zeros(3), np.ones(3, bool), "a.trace"))


def wrong_whole(rng, least, most):
    return rng.choice((*ODDITIES, least - 1, most + 1, -(2**70), 2**70, 10**30))


def wrong_index(rng, count):
    return rng.choice((*ODDITIES, None, -1, count, 2**32, 2**32 + 1, -(2**32), 2**64))


def wrong_mask(rng, n):
    return rng.choice(([256] * n, np.ones(n, np.int64), np.ones(n + 1, bool), np.ones((n, 1), bool), "mask", 0.5, [], {}, Odd(),
                         np.full(n, np.nan), [1] * n, [[True], [True, False]], np.zeros(n, np.uint8), ["True"] * n))


def wrong_wholes(rng, n, most):
    return rng.choice((1.9, [1.9] * n, [-1] * n, [most + 1] * n, ["a"] * n, [None] * n, [1] * (n + 1), np.zeros(n), np.full(n, -1),
                         np.zeros((n, 1), int), np.zeros(n + 1, int), Odd(), [], np.full(n, np.nan), [[1, 2]] * n, [True] * n, 2**70))


def wrong_rows(rng, shape):
    return rng.choice((np.zeros(shape[0] + 1), np.zeros((*shape, 2)), np.zeros(shape[:-1] + (shape[-1] + 1,)), "fast", None, Odd(), {},
                         np.full(shape, "1"), np.full(shape, None), np.zeros(shape, complex), [[1.0], [1.0, 2.0]], b"x", {"speed": 1.0}))


def wrong_path(rng):
    return rng.choice(("a\0b", b"a\0b", "/no/such/folder/x", "/", ".", 5, 0.5, Odd(), ["a"], "x" * 5000, "\ud800", "/dev/full/x", True))


def wrong_states(rng):
    return rng.choice((5, "x", ["pendulum.mass"], Odd(), {"weight": 1.0}, {5: 1.0}, {"pendulum.mass": "heavy"}, {"pendulum.mass": None},
                         {"pendulum.mass": [1, 2, 3, 4, 5, 6, 7]}, {"pendulum.mass": 5.0}, {"pendulum.mass": 1e300},
                         {"pendulum.mass": float("inf")}, {"pendulum.mass": 1j}, {"pendulum.mass": Odd()}, {"pendulum.mass": -1}))


def copied(rng, used):
    how = rng.choice((copy.copy, copy.deepcopy, pickle.dumps, lambda it: pickle.dumps(it, protocol=0), lambda it: copy.deepcopy([it])))
    return "copies", lambda: how(used)


def bits(*parts):
    """Of arrays, in dicts too."""
    return tuple(bits(*part.values()) if isinstance(part, dict) else np.asarray(part).tobytes() if isinstance(part, (np.ndarray, np.generic))
                 else part for part in parts)


class Plain:
    """Environments, and the C functions with the same memory."""

    name = "Environments"

    def __init__(self, library, rng):
        self.library, self.n = library, rng.choice((1, 2, 4, 37))
        self.how = {"seed": rng.randrange(2**64), "longest": rng.randrange(1, 6), "autoreset": rng.choice(MODES),
                    "threads": rng.randrange(1, 4)}

    def make(self):
        made = eagerx_gen.Environments(self.library, self.n, **self.how)
        made.trace(0, "")
        return made

    def state(self, used):
        return bits(used.observation, used.reward, used.terminated, used.truncated, used.success, used.terms, used.hash(0), used.states())

    def first(self, rng):
        seeds = [rng.randrange(2**64) for _ in range(self.n)]
        return lambda used: (used.reset(seeds=seeds), self.state(used))

    def right(self, rng):
        kind, action = rng.randrange(6), np.array([[rng.uniform(-3, 3)] for _ in range(self.n)], np.float32)
        mask, mass = np.array([rng.random() < 0.5 for _ in range(self.n)]), rng.uniform(0.04, 0.06)

        def call(used):
            if kind == 0:
                used.reset(mask)
            elif kind == 1:
                used.set_states({"pendulum.mass": mass}, mask)
            elif kind == 2:
                return used.counts()
            else:
                used.action = action
                used.step()
            return self.state(used)

        return call

    def wrong(self, rng, used):
        n, most = self.n, 2**64 - 1
        fixed = rng.choice(("observation", "reward", "terminated", "truncated", "success", "terms", "final_observation", "count", "library",
                              "autoreset"))
        value = rng.choice((None, 5, np.zeros((n, 1), np.float32), np.zeros(n)))
        return rng.choice((
            lambda: ("reset mask", lambda: used.reset(wrong_mask(rng, n))),
            lambda: ("reset seeds", lambda: used.reset(seeds=wrong_wholes(rng, n, most))),
            lambda: ("set_states", lambda: used.set_states(wrong_states(rng))),
            lambda: ("set_states mask", lambda: used.set_states({}, wrong_mask(rng, n))),
            lambda: ("trace environment", lambda: used.trace(wrong_index(rng, n), "")),
            lambda: ("trace path", lambda: used.trace(rng.randrange(n), wrong_path(rng))),
            lambda: ("trace one_file", lambda: self.two_in_one_file(used, rng)),
            lambda: ("hash", lambda: used.hash(wrong_index(rng, n))),
            lambda: ("picture", lambda: used.picture(wrong_index(rng, n))),
            lambda: ("picture nothing", lambda: used.picture(0, (2, 2))),
            lambda: ("picture size", lambda: used.picture(0, rng.choice((None, 5, (1,), (0, 5), (5, 5000), (1.5, 2), "ab", (1, 2, 3), Odd())))),
            lambda: ("attributes set", lambda: setattr(used, fixed, value)),
            lambda: ("attributes deleted", lambda: delattr(used, rng.choice((fixed, "action")))),
            lambda: ("attributes action", lambda: setattr(used, "action", wrong_rows(rng, (n, 1)))),
            lambda: ("attributes resized", lambda: getattr(used, rng.choice(("observation", "action"))).resize((n, 9), refcheck=False)),
            lambda: ("made_twice", lambda: used.__init__(self.library, self.n)),
            lambda: copied(rng, used),
            lambda: self.wrong_making(rng),
            *[lambda: self.wrong_c(rng, used)] * 6))()

    def two_in_one_file(self, used, rng):
        other = eagerx_gen.Environments(self.library, 1)
        other.trace(0, "one.trace")
        try:
            used.trace(rng.randrange(self.n), rng.choice(("one.trace", "./one.trace", os.path.abspath("one.trace"))))
        finally:
            other.close()

    def wrong_making(self, rng):
        what, value = rng.choice((
            ("count", wrong_whole(rng, 1, 10**6)), ("numbers", wrong_wholes(rng, 2, 2**32 - 1)), ("seed", wrong_whole(rng, 0, 2**64 - 1)),
            ("longest", wrong_whole(rng, 0, 2**32 - 1)), ("threads", wrong_whole(rng, 0, 1024)),
            ("autoreset", rng.choice((None, "never", 3, [], Odd()))), ("library", rng.choice((None, "x.so", 5, Odd()))),
            ("pictures", 1)))
        arguments = {"library": self.library, "count": 2, what: value}
        if what == "pictures":  # of a graph with `render:` there are some
            return "load", lambda: eagerx_gen.load(rng.choice((None, 5, "a\0b.so", "none.so", "none.yaml", Odd(), "/", "one.trace.so")))
        return f"Environments {what}", lambda: eagerx_gen.Environments(**arguments)

    def any(self, rng, used):
        a, b = anything(rng), anything(rng)
        return rng.choice((("reset", lambda: used.reset(a, b)), ("set_states", lambda: used.set_states(a, b)), ("hash", lambda: used.hash(a)),
                             ("trace", lambda: used.trace(a, b)), ("set_states", lambda: used.set_states({"pendulum.mass": a}, b)),
                             ("action", lambda: setattr(used, "action", a)),
                             ("trace", lambda: used.trace(0, a)), ("step", used.step), ("counts", used.counts), ("stepping", used.stepping),
                             ("Environments", lambda: eagerx_gen.Environments(self.library, 3, numbers=a, autoreset="disabled", longest=b).close())))

    def closed(self, rng, used):
        calls = (used.reset, used.step, used.states, used.counts, used.stepping, lambda: used.hash(0), lambda: used.trace(0, ""),
                 lambda: used.set_states({}), lambda: used.picture(0, (2, 2)), lambda: used.trace(0, None), used.check_open)
        return [("closed", call) for call in rng.sample(calls, 3)] + [copied(rng, used)]

    def wrong_c(self, rng, used):
        """The functions themselves; buffers have the sizes that they should have, and no byte more."""
        c, n, row = self.library.c, self.n, self.library._sizes
        c.eagerx_act.argtypes = [ctypes.c_void_p] * 3
        handle, rows = rng.choice((used._handle, None)), _Rows(ctypes.sizeof(_Rows))
        observation, action, states = (np.zeros((n, row[what]), np.float32) for what in ("observations", "actions", "states"))
        seeds, pixels = np.zeros(n, np.uint64), np.zeros((2, 2, 3), np.uint8)
        beyond = rng.choice((n, n + 1, 2**31, 2**32 - 1))
        null = handle is None
        calls = [
            ("step", lambda: c.eagerx_step(handle, action.ctypes.data if null else None, ctypes.addressof(rows))),
            ("reset", lambda: c.eagerx_reset(None, None, seeds.ctypes.data, observation.ctypes.data)),
            ("act", lambda: c.eagerx_act(handle, None, action.ctypes.data)),
            ("act", lambda: c.eagerx_act(handle, observation.ctypes.data, None)),
            ("get_states", lambda: c.eagerx_get_states(handle, states.ctypes.data if null else None)),
            ("set_states", lambda: c.eagerx_set_states(handle, None, None)),
            ("set_states", lambda: c.eagerx_set_states(handle, None, np.full_like(states, rng.choice((1e30, np.inf, -np.inf))).ctypes.data)),
            ("trace", lambda: c.eagerx_trace(handle, beyond, b"")),
            ("trace", lambda: c.eagerx_trace(handle, 0, rng.choice((b"/no/such/x", b"/", b"x" * 5000, b"\xff/x")))),
            ("hash", lambda: -1 if c.eagerx_hash(handle, beyond) == 0 else 0),
            ("picture", lambda: c.eagerx_picture(handle, beyond, 2, 2, pixels.ctypes.data)),
            ("picture", lambda: c.eagerx_picture(handle, 0, rng.choice((0, 4097, 2**32 - 1)), 2, pixels.ctypes.data)),
            ("picture", lambda: c.eagerx_picture(handle, 0, 2, 2, rng.choice((None, pixels.ctypes.data)))),
            ("stepping", lambda: -1 if c.eagerx_stepping(None) is None else 0),
            ("counts", lambda: -1 if c.eagerx_counts(None) is None else 0),
        ]
        if not null:
            rows.size = rng.choice((0, 8, 63, 2**32 - 1))
            calls.append(("step", lambda: c.eagerx_step(handle, action.ctypes.data, ctypes.addressof(rows))))
        options = _Options(ctypes.sizeof(_Options), 2, None, 0, 0, 0, 1, 0)
        what, value = rng.choice((("size", 12), ("environments", 0), ("environments", 10**6 + 1), ("autoreset", 3), ("threads", 1025),
                                    ("pictures", 2), ("size", 2**32 - 1), ("environments", 2**32 - 1)))
        setattr(options, what, value)
        calls.append(("create", lambda: -1 if c.eagerx_create(rng.choice((None, ctypes.addressof(options)))) is None else 0))
        name, call = rng.choice(calls)

        def fails():
            result = call()
            c.eagerx_destroy(None)
            if result != 0:
                raise eagerx_gen.Error(c.eagerx_error().decode())
            return result

        return f"C eagerx_{name} {'of null' if null else ''}", fails


class Wrapper:
    """Misuses that Env, VectorEnv and VecEnv share."""

    def __init__(self, library, rng):
        self.library, self.n, self.flatten = library, rng.choice((1, 2, 4, 37)), rng.random() < 0.5
        self.how = {"flatten": self.flatten, "longest": rng.randrange(1, 6), "normalize_actions": rng.random() < 0.5}

    def actions(self, rng, shape):
        row = np.array([rng.uniform(-3, 3) for _ in range(int(np.prod(shape)))], np.float32).reshape(shape)
        return row if self.flatten else {"voltage": row}

    def wrong_actions(self, rng, shape):
        rows = wrong_rows(rng, shape)
        return rows if self.flatten or rng.random() < 0.5 else rng.choice(({"voltage": rows}, {"current": rows}, {}))

    def wrong_making(self, rng, make, counts=()):
        what, value = rng.choice((
            *((name, wrong_whole(rng, 1, 10**6)) for name in counts), ("longest", wrong_whole(rng, 0, 2**32 - 1)),
            ("render_mode", rng.choice(("human", 5, [], Odd())))))
        return f"{self.name}() {what}", lambda: make(**{"library": self.library, what: value, **{c: 2 for c in counts if c != what}})

    def wrong_options(self, rng):
        return rng.choice((5, "x", [1], Odd(), {"states": 5}, {"states": wrong_states(rng)}))


class One(Wrapper):
    name = "Env"

    def make(self):
        return Env(self.library, **self.how)

    def first(self, rng):
        seed = rng.randrange(2**64)
        return lambda used: bits(*used.reset(seed=seed))

    def right(self, rng):
        action, again = self.actions(rng, (1,)), rng.random() < 0.2

        def call(used):
            if again or used._ended:
                return bits(*used.reset())
            observation, reward, terminated, truncated, _ = used.step(action)
            return bits(observation, reward, terminated, truncated)

        return call

    def wrong(self, rng, used):
        return rng.choice((
            lambda: ("Env.step", lambda: used.step(self.wrong_actions(rng, (1,)))),
            lambda: ("Env.reset seed", lambda: used.reset(seed=wrong_whole(rng, 0, 2**64 - 1))),
            lambda: ("Env.reset options", lambda: used.reset(seed=7, options=self.wrong_options(rng))),
            lambda: copied(rng, used),
            lambda: ("Env() number", lambda: Env(self.library, number=wrong_whole(rng, 0, 2**32 - 1))),
            lambda: self.wrong_making(rng, Env)))()

    def any(self, rng, used):
        a, b = anything(rng), anything(rng)
        return rng.choice((("reset", lambda: used.reset(seed=a, options=b)), ("step", lambda: used.step(a)),
                             ("step", lambda: used.step({"voltage": a})), ("reset", lambda: used.reset(options={"states": a})),
                             ("Env", lambda: Env(self.library, number=a, longest=b).close())))

    def closed(self, rng, used):
        return [("closed Env", call) for call in (used.reset, lambda: used.step(self.actions(rng, (1,))), used.render)] + [copied(rng, used)]


class Many(Wrapper):
    name = "VectorEnv"

    def __init__(self, library, rng):
        super().__init__(library, rng)
        self.how.update(autoreset_mode=rng.choice(("NextStep", "SameStep", "Disabled")), copy=rng.random() < 0.7,
                        threads=rng.randrange(1, 3))

    def make(self):
        return VectorEnv(self.library, self.n, **self.how)

    def first(self, rng):
        seed = rng.randrange(2**63)
        return lambda used: bits(*used.reset(seed=seed))

    def right(self, rng):
        actions, again = self.actions(rng, (self.n, 1)), rng.random() < 0.2

        def call(used):
            ended = used._ended
            if again or (ended.any() and self.how["autoreset_mode"] == "Disabled"):
                return bits(*used.reset(options={"reset_mask": ended} if ended.any() else {}))
            return bits(*used.step(actions)[:4])

        return call

    def wrong(self, rng, used):
        n, states = self.n, wrong_states(rng)
        mask = rng.choice(([True] * n, np.zeros(n, bool), np.ones(n), np.ones(n + 1, bool), None, 5, Odd()))
        options = rng.choice(({"reset_mask": mask}, {"reset_mask": mask, "states": {}}, {"states": states}, 5, "x", Odd()))
        return rng.choice((
            lambda: ("VectorEnv.step", lambda: used.step(self.wrong_actions(rng, (n, 1)))),
            lambda: ("VectorEnv.reset seed", lambda: used.reset(seed=rng.choice((0.5, "3", Odd(), True, -1, 2**64 - n + 1, 10**30, {}, set())))),
            lambda: ("VectorEnv.reset seeds", lambda: used.reset(seed=rng.choice(([-1] * n, [1.9] * n, [1] * (n + 1), ["a"] * n, np.full(n, 0.5))))),
            lambda: ("VectorEnv.reset options", lambda: used.reset(seed=7, options=options)),
            lambda: copied(rng, used),
            lambda: ("VectorEnv() numbers", lambda: VectorEnv(self.library, 2, numbers=wrong_wholes(rng, 2, 2**32 - 1))),
            lambda: ("VectorEnv() mode", lambda: VectorEnv(self.library, 2, autoreset_mode=rng.choice(("never", 3, [], Odd())))),
            lambda: self.wrong_making(rng, VectorEnv, ["num_envs"])))()

    def any(self, rng, used):
        a, b = anything(rng), anything(rng)
        return rng.choice((("reset", lambda: used.reset(seed=a, options=b)), ("step", lambda: used.step(a)), ("step", lambda: used.step({"voltage": a})),
                             ("reset", lambda: used.reset(options={"states": a, "reset_mask": b})),
                             ("VectorEnv", lambda: VectorEnv(self.library, 3, numbers=a, longest=b).close())))

    def closed(self, rng, used):
        return [("closed VectorEnv", call) for call in (used.reset, lambda: used.step(self.actions(rng, (self.n, 1))), used.render)] + [
            copied(rng, used)]


class Stable(Wrapper):
    name = "VecEnv"

    def __init__(self, library, rng):
        super().__init__(library, rng)
        self.how["threads"] = rng.randrange(1, 3)

    def make(self):
        return VecEnv(self.library, self.n, **self.how)

    def first(self, rng):
        seed = rng.randrange(2**63)
        return lambda used: (used.seed(seed), bits(used.reset()))

    def right(self, rng):
        actions = np.array([[rng.uniform(-3, 3)] for _ in range(self.n)], np.float32)
        again = rng.random() < 0.2
        return lambda used: bits(used.reset()) if again else bits(*used.step(actions)[:3])

    def wrong(self, rng, used):
        index = rng.choice((0.5, "x", [99], self.n, -self.n - 1, [None], Odd(), [0.5]))
        return rng.choice((
            lambda: ("VecEnv.step", lambda: used.step(wrong_rows(rng, (self.n, 1)))),
            lambda: ("VecEnv.seed", lambda: used.seed(wrong_whole(rng, 0, 2**64 - self.n))),
            lambda: ("VecEnv.get_attr", lambda: used.get_attr(rng.choice(("spec", "metadata")), index)),
            lambda: ("VecEnv.get_attr", lambda: used.get_attr("no_such_attribute")),
            lambda: ("VecEnv.set_attr", lambda: used.set_attr("spec", 5)),
            lambda: ("VecEnv.env_method", lambda: used.env_method("reset")),
            lambda: ("VecEnv.env_is_wrapped", lambda: used.env_is_wrapped(anything(rng), index)),
            lambda: copied(rng, used),
            lambda: self.wrong_making(rng, VecEnv, ["n_envs"])))()

    def any(self, rng, used):
        a = anything(rng)
        return rng.choice((("seed", lambda: used.seed(a)), ("step", lambda: used.step(a)), ("env_is_wrapped", lambda: used.env_is_wrapped(a)),
                             ("reset", used.reset), ("get_images", used.get_images),
                             ("VecEnv", lambda: VecEnv(self.library, 3, numbers=a).close())))

    def closed(self, rng, used):
        actions = np.zeros((self.n, 1), np.float32)
        calls = (used.reset, used.seed, used.set_options, lambda: used.step_async(actions), used.step_wait, used.get_images,
                 lambda: used.get_attr("spec"), lambda: used.set_attr("a", 1), lambda: used.env_method("a"), lambda: used.env_is_wrapped(int))
        return [("closed VecEnv", call) for call in rng.sample(calls, 3)] + [copied(rng, used)]


SUBJECTS = (Plain, Plain, Plain, One, Many, Stable)


def threads(library, rng, tally):
    """One thread steps while another does something: both go well or get an error, and the bits are right again after a reset."""
    n, seeds = 300, [rng.randrange(2**64) for _ in range(300)]
    used, fresh = (eagerx_gen.Environments(library, n, threads=2) for _ in range(2))
    used.reset(seeds=seeds)
    closes, c = rng.random() < 0.5, library.c
    in_c = not closes and rng.random() < 0.5  # where only the library itself sees both

    def checked(result):
        if result != 0:
            raise eagerx_gen.Error(c.eagerx_error().decode())

    def step():
        if in_c:
            checked(c.eagerx_step(used._handle, *used._arguments))
        else:
            used.step()

    def reset():
        if in_c:
            checked(c.eagerx_reset(used._handle, None, None, used.observation.ctypes.data))
        else:
            used.reset()

    def steps():
        for _ in range(10):
            tally.may_fail("step with threads", step, (eagerx_gen.Error,))

    other = threading.Thread(target=steps)
    other.start()
    while other.is_alive():
        call = rng.choice((step, reset, used.counts, used.states, lambda: used.hash(0), *([used.close] if closes else [])))
        tally.may_fail("call with threads", call, (eagerx_gen.Error,))
    other.join()
    if used._handle is None:
        tally.must_fail("closed by a thread", used.step, (eagerx_gen.Error,))
    else:
        for environments in (used, fresh):
            environments.reset(seeds=seeds)
            environments.step()
        if bits(used.observation, used.reward) != bits(fresh.observation, fresh.reward):
            tally.fail("threads: other bits after a reset")
        used.close()
    fresh.close()

"""The C interface of a graph's library, with nothing but Python's own ctypes."""
import ctypes
import json
from ctypes import POINTER, c_char_p, c_float, c_int, c_uint8, c_uint32, c_uint64, c_void_p

NEXT_STEP, SAME_STEP, DISABLED = range(3)


class Options(ctypes.Structure):
    _fields_ = [("size", c_uint32), ("environments", c_uint32), ("numbers", POINTER(c_uint32)), ("seed", c_uint64),
                ("longest", c_uint32), ("autoreset", c_uint32), ("threads", c_uint32)]


class Rows(ctypes.Structure):
    _fields_ = [("size", c_uint32), ("observation", POINTER(c_float)), ("reward", POINTER(c_float)),
                ("terminated", POINTER(c_uint8)), ("truncated", POINTER(c_uint8)), ("success", POINTER(c_uint8)),
                ("terms", POINTER(c_float)), ("final_observation", POINTER(c_float))]


def floats(numbers):
    return (c_float * len(numbers))(*numbers)


def numbers(fields):
    """Of a row of these fields."""
    count = 0
    for field in fields:
        size = 1
        for length in field["shape"]:
            size *= length
        assert field["first"] == count and len(field["low"]) == len(field["high"]) == size, field
        count += size
    return count


class Library:
    def __init__(self, path):
        self.path = str(path)
        self.c = ctypes.CDLL(self.path)
        for name in ("eagerx_describe", "eagerx_error", "eagerx_counts"):
            getattr(self.c, name).restype = c_char_p
        self.c.eagerx_create.restype = c_void_p
        self.c.eagerx_hash.restype = c_uint64
        self.description = json.loads(self.c.eagerx_describe())
        self.observed = numbers(self.description["observations"])
        self.acted = numbers(self.description["actions"])
        self.states = numbers(self.description["states"])
        task = self.description["task"]
        self.terms = len(task["terms"]) if task else 0
        self.seen = numbers(task["critic"]) if task else 0
        self.stages = [stage["name"] for stage in task["stages"]] if task else []


class Batch:
    def __init__(self, library, environments, seed=1, longest=0, autoreset=NEXT_STEP, threads=1):
        self.library, self.environments = library, environments
        options = Options(ctypes.sizeof(Options), environments, None, seed, longest, autoreset, threads)
        self.handle = c_void_p(library.c.eagerx_create(ctypes.byref(options)))
        self.check(0 if self.handle else -1)
        self.observation = (c_float * (environments * library.observed))()
        self.reward = (c_float * environments)()
        self.terminated, self.truncated = (c_uint8 * environments)(), (c_uint8 * environments)()
        self.terms = (c_float * (environments * library.terms))()
        self.rows = Rows(ctypes.sizeof(Rows), self.observation, self.reward, self.terminated, self.truncated, None, self.terms)

    def check(self, result):
        if result != 0:
            raise RuntimeError(self.library.c.eagerx_error().decode())

    def reset(self):
        self.check(self.library.c.eagerx_reset(self.handle, None, None, self.observation))

    def step(self, actions):
        """actions: one row for all environments, or floats() of every one's."""
        if isinstance(actions, list):
            actions = floats(actions * self.environments)
        self.check(self.library.c.eagerx_step(self.handle, actions, ctypes.byref(self.rows)))

    def stage(self, name, mask=None):
        """From their next reset on."""
        self.check(self.library.c.eagerx_set_stage(self.handle, mask, None if name is None else name.encode()))

    def critic(self):
        """Inputs of a training's critic only: current rows, and rows of the ends of episodes."""
        now, ends = ((c_float * (self.environments * self.library.seen))() for _ in range(2))
        self.check(self.library.c.eagerx_critic(self.handle, now, ends))
        return bytes(now), bytes(ends)

    def trace(self, environment, path):
        self.check(self.library.c.eagerx_trace(self.handle, c_uint32(environment), None if path is None else str(path).encode()))

    def hash(self, environment):
        return self.library.c.eagerx_hash(self.handle, c_uint32(environment))

    def close(self):
        self.library.c.eagerx_destroy(self.handle)

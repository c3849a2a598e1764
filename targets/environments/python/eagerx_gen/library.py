"""The C interface of targets/environments/eagerx_environments.h over numpy arrays."""
from __future__ import annotations

import contextlib
import ctypes
import json
import operator
import os
import reprlib
from ctypes import c_char_p, c_int, c_uint32, c_uint64, c_void_p

import numpy as np

from . import checks
from .description import Described, picture_size, states_row, tuning_row
from .errors import Error, RewardNotFinite
from .turn import turn

VERSION = 5
"""Of the C interface."""

MOST = 1_000_000
"""Environments in a batch: EAGERX_ENVIRONMENTS_MOST."""

AUTORESET = {"next_step": 0, "same_step": 1, "disabled": 2}


class _Options(ctypes.Structure):
    _fields_ = [("size", c_uint32), ("environments", c_uint32), ("numbers", c_void_p), ("seed", c_uint64),
                ("longest", c_uint32), ("autoreset", c_uint32), ("threads", c_uint32), ("pictures", c_uint32)]


class _Rows(ctypes.Structure):
    _fields_ = [("size", c_uint32)] + [(name, c_void_p) for name in (
        "observation", "reward", "terminated", "truncated", "success", "terms", "final_observation")]


_FUNCTIONS = {
    "eagerx_version": (c_uint32, []),
    "eagerx_describe": (c_char_p, []),
    "eagerx_error": (c_char_p, []),
    "eagerx_create": (c_void_p, [c_void_p]),
    "eagerx_destroy": (None, [c_void_p]),
    "eagerx_reset": (c_int, [c_void_p] * 4),
    "eagerx_step": (c_int, [c_void_p] * 3),
    "eagerx_set_states": (c_int, [c_void_p] * 3),
    "eagerx_tune": (c_int, [c_void_p] * 3),
    "eagerx_get_states": (c_int, [c_void_p] * 2),
    "eagerx_critic": (c_int, [c_void_p] * 3),
    "eagerx_trace": (c_int, [c_void_p, c_uint32, c_char_p]),
    "eagerx_hash": (c_uint64, [c_void_p, c_uint32]),
    "eagerx_picture": (c_int, [c_void_p, c_uint32, c_uint32, c_uint32, c_void_p]),
    "eagerx_counts": (c_char_p, [c_void_p]),
    "eagerx_stepping": (c_char_p, [c_void_p]),
}


class Library(Described):
    """The library of a graph, as eagerx-gen's target `environments` makes it."""

    def __init__(self, path):
        # Absolute, because a name without a folder would be looked for in the system's folders.
        self.path = os.path.abspath(os.fsdecode(checks.path("the library", path)))
        try:
            self.c = ctypes.CDLL(self.path)
            version = self.c.eagerx_version()  # first: others have other functions
            if version != VERSION:
                raise Error(f"`{self.path}` has version {version} of the interface, and this package version {VERSION}: "
                            "make it again with the eagerx-gen that this package is from")
            functions = {name: getattr(self.c, name) for name in _FUNCTIONS}
        except (OSError, AttributeError) as problem:
            raise Error(f"`{self.path}` is not a library of environments: {problem}") from problem
        for name, (result, arguments) in _FUNCTIONS.items():
            functions[name].restype, functions[name].argtypes = result, arguments
        super().__init__(json.loads(self.c.eagerx_describe()))
        if self.stages:  # libraries of older versions have neither
            self.c.eagerx_set_stage.restype, self.c.eagerx_set_stage.argtypes = c_int, [c_void_p, c_void_p, c_char_p]

    def __reduce__(self):
        return Library, (self.path,)

    def __repr__(self):
        return f"<eagerx_gen.Library {self.description['graph']} on {self.description['engine']}>"


def _fixed(name, help="its elements can be changed, as by `{}[:] = …`"):
    """An attribute that stays: the library writes where it lies, or has the same number."""
    def refuse(_self, *_value):
        raise AttributeError(f"{name} of these environments is always the same: " + help.format(name))

    return property(operator.attrgetter("_" + name), refuse, refuse)


def _zeros(shape, dtype):
    """Not resizable, because the library has its address."""
    return np.ndarray(shape, dtype, bytearray(int(np.prod(shape, dtype=int)) * np.dtype(dtype).itemsize))


class Environments(checks.Single):
    """`count` environments and their rows, which every step writes over.

    action             [count, numbers of an action] float32, read by step(); `action = …` copies
    observation        [count, numbers of an observation] float32
    final_observation  the same: rows whose episode ended, with autoreset "same_step"
    reward             [count] float32
    terminated, truncated, success    [count] bool
    terms              [count, terms of the reward] float32, weighted

    seed, longest, threads: as in eagerx_environments.h. numbers: [count] of each in its seed, or None: 0, 1, 2, ...
    pictures: whether picture() will be called; environments then run one by one.

    ValueError for arguments that are none, Error with the library's text, from a second thread in a call, and behind close().
    """

    _handle = None  # until eagerx_create()
    library, count, autoreset = (_fixed(name, "make others") for name in ("library", "count", "autoreset"))
    observation, final_observation, reward = (_fixed(name) for name in ("observation", "final_observation", "reward"))
    terminated, truncated, success, terms = (_fixed(name) for name in ("terminated", "truncated", "success", "terms"))

    @checks.arguments("Environments", num_envs="count is how many environments there are", n_envs="count is how many environments there are")
    def __init__(self, library, count, *, seed=0, numbers=None, longest=0, autoreset="next_step", threads=0, pictures=False):
        if self._handle is not None:
            raise Error("these environments are made already")
        if not isinstance(library, Library):
            raise ValueError(f"library is {reprlib.repr(library)}, not what load() gives")
        if not isinstance(autoreset, str) or autoreset not in AUTORESET:
            raise ValueError(f"autoreset is {reprlib.repr(autoreset)}; it is one of {', '.join(AUTORESET)}")
        count = checks.whole("count", count, 1, MOST)
        if numbers is not None:
            numbers = checks.whole_numbers("numbers", numbers, count, np.uint32)
        options = _Options(ctypes.sizeof(_Options), count, None if numbers is None else numbers.ctypes.data,
                           checks.whole("seed", seed, 0, 2**64 - 1), checks.whole("longest", longest, 0, 2**32 - 1), AUTORESET[autoreset],
                           checks.whole("threads", threads, 0, 2**32 - 1), int(bool(pictures)))
        self._library, self._count, self._autoreset = library, count, autoreset
        self._turn = turn()
        self._handle = library.c.eagerx_create(ctypes.byref(options))
        if not self._handle:
            self._handle = None
            self._fail()
        observed = (count, library._sizes["observations"])
        rows = {
            "observation": _zeros(observed, np.float32),
            "reward": _zeros(count, np.float32),
            "terminated": _zeros(count, np.bool_),
            "truncated": _zeros(count, np.bool_),
            "success": _zeros(count, np.bool_),
            "terms": _zeros((count, library._sizes["terms"]), np.float32),
            "final_observation": _zeros(observed, np.float32),
        }
        vars(self).update({"_" + name: row for name, row in rows.items()})
        self._action = _zeros((count, library._sizes["actions"]), np.float32)
        # Addresses are taken once, so that a step is one call.
        self._rows = _Rows(ctypes.sizeof(_Rows), *(row.ctypes.data for row in rows.values()))
        self._step = library.c.eagerx_step
        self._arguments = (self._action.ctypes.data, ctypes.addressof(self._rows))
        self._critic_row = _zeros((count, library._sizes["critic"]), np.float32)
        self._critic_address = self._critic_row.ctypes.data
        self._memory = (*rows.values(), self._action)

    @property
    def action(self):
        return self._action

    @action.setter
    def action(self, values):
        if values is self._action:  # env.action += 1
            return
        array = checks.numbers("the action", values)
        if array.shape != self._action.shape:
            raise ValueError(f"the action has shape {array.shape}, not {self._action.shape}")
        self._action[...] = array

    @action.deleter
    def action(self):
        raise AttributeError("these environments always have an action")

    def _fail(self, kind=Error):
        raise kind(self._library.c.eagerx_error().decode(errors="replace"))

    def _call(self, function, *arguments):
        """Calls a function of the library, from one thread at a time."""
        with self._turn:
            result = function(self._open(), *arguments)
        return result

    def _open(self):
        if self._handle is None:
            raise Error("these environments are closed")
        return self._handle

    def check_open(self):
        """Error behind close()."""
        self._open()

    def _index(self, environment):
        try:
            return checks.whole("environment", environment, 0, self._count - 1)
        except ValueError:
            raise ValueError(f"there is no environment {reprlib.repr(environment)}, but 0 to {self._count - 1}") from None

    def reset(self, mask=None, seeds=None):
        """Begins episodes, where `mask` [count] bool is true. seeds: [count], from whose episode 0 they begin; None: the next episode."""
        mask = checks.mask(mask, self._count)
        if seeds is not None:
            seeds = checks.whole_numbers("seeds", seeds, self._count, np.uint64)
        if self._call(self._library.c.eagerx_reset, None if mask is None else mask.ctypes.data,
                      None if seeds is None else seeds.ctypes.data, self._observation.ctypes.data) != 0:
            self._fail()

    def step(self):
        """One step with `action`. RewardNotFinite, an Error: which term, where and when.

        That step is made and its rows are there: to continue, catch it. counts() has how often.
        """
        with self._turn:  # not _call(), which would cost more than the rest of this
            result = self._step(self._handle, *self._arguments)
        if result != 0:
            self._open()
            self._fail(RewardNotFinite if result > 0 else Error)

    def set_states(self, states, mask=None):
        """The states of the next episode: {name: value or [count, ...]}; what is not named is sampled."""
        row = states_row(self._library, states, self._count)
        mask = checks.mask(mask, self._count)
        if self._call(self._library.c.eagerx_set_states, None if mask is None else mask.ctypes.data, row.ctypes.data) != 0:
            self._fail()

    def set(self, parameters, mask=None):
        """Sets tunable parameters while episodes run, before the next step: {name: value or [count, ...]}."""
        row = tuning_row(self._library, parameters, self._count)
        mask = checks.mask(mask, self._count)
        if self._call(self._library.c.eagerx_tune, None if mask is None else mask.ctypes.data, row.ctypes.data) != 0:
            self._fail()

    def states(self):
        """{name: [count, ...]} that the episodes began with; NaN where nothing was set or sampled."""
        row = np.zeros((self._count, self._library._sizes["states"]), np.float32)
        if self._call(self._library.c.eagerx_get_states, row.ctypes.data) != 0:
            self._fail()
        return {field.name: row[:, field.columns].reshape(self._count, *field.shape) for field in self._library.states}

    def set_stage(self, stage, mask=None):
        """From their next reset on, episodes are those of a stage of the graph's task; None: the graph as it is written."""
        stage = checks.stage(stage, self._library.stages)
        mask = checks.mask(mask, self._count)
        if not self._library.stages:
            return self.check_open()
        if self._call(self._library.c.eagerx_set_stage, None if mask is None else mask.ctypes.data, stage.encode()) != 0:
            self._fail()

    def critic(self, final=False):
        """{name: [count, ...]} what the graph's `task.critic` shows besides observations, as of the last step or reset.

        final: rows whose episode ended with the last step, with autoreset "same_step".
        """
        address = self._critic_address
        if self._call(self._library.c.eagerx_critic, None if final else address, address if final else None) != 0:
            self._fail()
        row = self._critic_row.copy()
        return {field.name: row[:, field.columns].reshape(self._count, *field.shape) for field in self._library.critic}

    def trace(self, environment, path):
        """From its next reset on, messages of an environment go to a file for `eagerx-gen replay`; None ends it.

        "": no file, only the hash. A file has one trace: one that others write into is an Error.
        """
        if self._call(self._library.c.eagerx_trace, self._index(environment), None if path is None else checks.path("path", path)) != 0:
            self._fail()

    def hash(self, environment):
        """Of all messages of an environment since its trace began; 0 without one."""
        return self._call(self._library.c.eagerx_hash, self._index(environment))

    def picture(self, environment, size=(480, 480)):
        """uint8 [height, width, 3] of size (width, height): what the graph's `render:` showed last; white before that."""
        environment, (width, height) = self._index(environment), picture_size(size)
        pixels = np.empty((height, width, 3), np.uint8)
        if self._call(self._library.c.eagerx_picture, environment, width, height, pixels.ctypes.data) != 0:
            self._fail()
        return pixels

    def stepping(self):
        """How they are stepped, and what made that slower: "vectorized: 64 lanes (avx512)", "one by one: …"."""
        text = self._call(self._library.c.eagerx_stepping)
        if text is None:
            self._fail()
        return text.decode()

    def counts(self):
        """Counts of guards and nodes, {"safe: action not finite: voltage": 3}, and of steps, {"not finite: task.angle": 12}."""
        text = self._call(self._library.c.eagerx_counts)
        if text is None:
            self._fail()
        return json.loads(text)

    def close(self):
        """Frees what the library has; the rows stay. Not while another thread is in a call."""
        if self._handle is None:
            return
        with self._turn:
            handle, self._handle = self._handle, None
            if handle is not None:
                self._library.c.eagerx_destroy(handle)

    def __del__(self):
        with contextlib.suppress(Error):  # a thread is still in a call when Python ends
            self.close()

"""The program of a graph in real time: rows of one environment over a socket (targets/linux-sim/external/protocol.hpp)."""
from __future__ import annotations

import contextlib
import itertools
import json
import os
import reprlib
import socket
import struct
import subprocess
import sys
import tempfile
import weakref

import numpy as np

from . import checks
from .description import Described, picture_size, states_row, tuning_row
from .errors import Error, RewardNotFinite
from .turn import turn

VERSION = 3
"""Of the protocol."""

_DESCRIBE, _RESET, _STEP, _COUNTS, _HASH, _PICTURE, _CLOSE, _TUNE = range(1, 9)
_PROBLEM, _PIECE, _NUMBER, _OBSERVATION = range(1, 5)
_TERMINATED, _TRUNCATED, _SUCCESS = 1, 2, 4
_REQUEST = struct.Struct("=IIQQ")
_ANSWER = struct.Struct("=IIQQqdII")
_LONGEST = 2**18  # bytes of an answer
_PATIENCE_S = 10  # until a program ends on request

_sockets = weakref.WeakSet()


def _forget_in_child():
    # A child that another thread, or multiprocessing, forks: the program must see that its agent is gone.
    for each in _sockets:
        each.close()


os.register_at_fork(after_in_child=_forget_in_child)


class Program(Described):
    """The description of a graph by its program."""

    render_modes = ("human", "rgb_array")

    def __init__(self, path, description):
        super().__init__(description)
        self.path = path

    def __repr__(self):
        return f"<eagerx_gen.Program {self.description['graph']} on {self.description['engine']}>"


def _said(errors):
    # The program writes at the place that both have in the file, so it stays where it is.
    return os.pread(errors.fileno(), 2**20, 0).decode(errors="replace").strip()


def _finish(ours, process, errors, owner):
    """Tells the program to end, and waits: it makes safe, writes its files."""
    if os.getpid() != owner:  # a child was forked, which has nothing to do with the program
        return
    try:
        with contextlib.suppress(OSError):
            ours.send(_REQUEST.pack(_CLOSE, 0, 0, 0), socket.MSG_DONTWAIT)
    finally:
        ours.close()  # without the request it sees that its agent is gone, which is the same
    with contextlib.suppress(subprocess.TimeoutExpired):
        process.wait(_PATIENCE_S)
    errors.close()


class RunningProgram(checks.Single):
    """One environment in another process, with rows as Environments has them, `count` 1.

    path               of the program, as eagerx-gen's target `linux-sim` makes it
    number, longest    as of Env
    real_time_factor   simulated seconds a second; 0: as fast as possible. Real hardware runs in real time only.
    publish, publish_only, publish_rate, trace    the program's options
    render_mode        "human": a window of the program. "rgb_array": picture() gives uint8 [height, width, 3]
    variables          of the program's environment, besides those of this process

    The program is in a session of its own: what ends or stops this process does not end or stop it. It makes safe and ends
    when this process closes it, dies or is killed.
    """

    count = 1

    @checks.arguments("RunningProgram")
    def __init__(self, path, *, number=0, longest=0, real_time_factor=1.0, publish=(), publish_only=(), publish_rate=None,
                 trace=None, render_mode=None, render_size=(480, 480), variables=None):
        options = ["--environment", str(checks.whole("number", number, 0, 2**32 - 1))]
        options += ["--steps", str(checks.whole("longest", longest, 0, 2**32 - 1) or 2**64 - 1), "--episodes", str(2**32 - 1)]
        options += ["--real-time-factor", repr(factor(real_time_factor))]
        options += [word for kind in words("publish", publish) for word in ("--publish", kind)]
        options += [word for channel in words("publish_only", publish_only) for word in ("--publish-only", channel)]
        options += [] if publish_rate is None else ["--publish-rate", repr(float(publish_rate))]
        options += [] if trace is None else ["--trace", os.fsdecode(checks.path("trace", trace))]
        if render_mode is not None:
            width, height = picture_size(render_size)
            options += ["--render", "window" if render_mode == "human" else "asked", "--size", f"{width}x{height}"]
        self._turn = turn()
        self._numbers = itertools.count(1)  # of requests: an answer that an interrupt has left unread has another one
        self._start(path, options, variables)
        description = json.loads(self._pieces(_DESCRIBE))
        if description["version"] != VERSION:
            self.close()
            raise Error(f"`{path}` has version {description['version']} of the protocol, and this package version {VERSION}: "
                        "make it again with the eagerx-gen that this package is from")
        self.library = library = Program(path, description)
        sizes = library._sizes
        self.action = np.zeros((1, sizes["actions"]), np.float32)
        self.applied = np.zeros((1, sizes["actions"]), np.float32)
        self.observation = np.zeros((1, sizes["observations"]), np.float32)
        self.terms = np.zeros((1, sizes["terms"]), np.float32)
        self.reward = np.zeros(1)
        self.terminated, self.truncated, self.success = np.zeros((3, 1), np.bool_)
        self.late, self.time_s = 0, 0.0
        self._states = np.full(sizes["states"], np.nan, np.float32)

    def _start(self, path, options, variables):
        ours, theirs = socket.socketpair(socket.AF_UNIX, socket.SOCK_SEQPACKET)
        errors = tempfile.TemporaryFile()  # never full, unlike a pipe without a reader
        command = [path, "--agent", f"fd:{theirs.fileno()}", "--quiet", "--hash", *options]
        try:
            process = subprocess.Popen(command, pass_fds=[theirs.fileno()], stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                       stderr=errors, start_new_session=True, env={**os.environ, **(variables or {})})
        except OSError as problem:
            ours.close()
            raise Error(f"cannot run `{path}`: {problem.strerror}") from problem
        finally:
            theirs.close()
        _sockets.add(ours)
        self._socket, self._process, self._errors = ours, process, errors
        # At the end of this process, too, whatever ends it but a signal; then the program sees that the agent is gone.
        self._end = weakref.finalize(self, _finish, ours, process, errors, os.getpid())

    @property
    def process(self):
        """Number of the program's process."""
        return self._process.pid

    def check_open(self):
        """Error behind close()."""
        if not self._end.alive:
            raise Error("these environments are closed")

    def _lost(self):
        with contextlib.suppress(subprocess.TimeoutExpired):
            self._process.wait(_PATIENCE_S)
        said, code = _said(self._errors), self._process.poll()
        self._end()
        raise Error(said or f"the program of the graph has ended with exit code {code}")

    def _receive(self):
        try:
            answer = self._socket.recv(_LONGEST)
        except ConnectionError:
            answer = b""
        return answer or self._lost()

    def _ask(self, kind, number=0, seed=0, row=b""):
        """(header, bytes behind it) of the answer."""
        with self._turn:
            self.check_open()
            asked = next(self._numbers)
            try:
                self._socket.send(_REQUEST.pack(kind, number, seed, asked) + row)
            except OSError:
                self._lost()
            header = None
            while header is None or header[2] != asked:
                answer = self._receive()
                header = _ANSWER.unpack_from(answer)
        if header[0] == _PROBLEM:
            raise Error(answer[_ANSWER.size:].decode(errors="replace"))
        return header, answer[_ANSWER.size:]

    def _pieces(self, kind):
        """A text or a picture, which is asked for piece by piece."""
        pieces, size = [], None
        while size is None or sum(map(len, pieces)) < size:
            header, piece = self._ask(kind, sum(map(len, pieces)))
            pieces.append(piece)
            size = header[3]
        return b"".join(pieces)

    def _take(self, header, row):
        numbers = np.frombuffer(row, np.float32)
        terms, actions = self.terms.shape[1], self.applied.shape[1]
        self.terms[0] = numbers[:terms]
        self.applied[0] = numbers[terms:terms + actions]
        self.observation[0] = numbers[terms + actions:]
        _, self._episode, _, self._step, time_ns, self.reward[0], flags, self.late = header
        self.time_s = time_ns * 1e-9
        self.terminated[0], self.truncated[0], self.success[0] = flags & _TERMINATED, flags & _TRUNCATED, flags & _SUCCESS

    def reset(self, mask=None, seeds=None):
        """Begins an episode. seeds: [1], from whose episode 0 it begins; None: the next episode."""
        seeded = seeds is not None
        seed = int(checks.whole_numbers("seeds", seeds, 1, np.uint64)[0]) if seeded else 0
        states, self._states = self._states, np.full_like(self._states, np.nan)
        self._take(*self._ask(_RESET, int(seeded), seed, states.tobytes()))

    def step(self):
        """One step with `action`, or more if that is late: `late` of them had no action in time."""
        self._take(*self._ask(_STEP, row=self.action.tobytes()))
        if not np.isfinite(self.reward[0]):
            names = [name for name, x in zip(self.library.terms, self.terms[0]) if not np.isfinite(x)] or ["reward"]
            raise RewardNotFinite(f"`task.{names[0]}` is {'nan' if np.isnan(self.reward[0]) else 'infinite'} in step {self._step} of "
                                  f"episode {self._episode + 1}, both counted from 1")

    def set_stage(self, stage, mask=None):
        """Programs know nothing of stages: None and "" are what they are."""
        checks.stage(stage, ())

    def set_states(self, states, mask=None):
        """The states of the next episode: {name: value}; what is not named is sampled."""
        self.check_open()
        self._states = states_row(self.library, states, 1)[0]

    def set(self, parameters, mask=None):
        """Sets tunable parameters before the next step: {name: value}."""
        self.check_open()
        self._ask(_TUNE, row=tuning_row(self.library, parameters, 1)[0].tobytes())

    def counts(self):
        """Counts of guards, engine and nodes: {"safe: times": 1}."""
        return json.loads(self._pieces(_COUNTS))

    def hash(self, environment=0):
        """The hash of all messages."""
        return self._ask(_HASH)[0][3]

    def picture(self, environment=0, size=None):
        """uint8 [height, width, 3] of the size that the program was started with: what `render:` showed last."""
        return np.frombuffer(self._pieces(_PICTURE), np.uint8).reshape(size[1], size[0], 3).copy()

    def stepping(self):
        """How steps go, in words."""
        patience_s = self.library.description["patience_s"]
        if patience_s is None:
            return "in a program of its own, which waits for each action"
        return f"in a program of its own, in real time: an action is late after {patience_s * 1e3:.3g} ms"

    def close(self):
        """The program makes safe and ends; its files are complete then. What it said goes to the standard error."""
        if not self._end.alive:
            return
        errors = os.dup(self._errors.fileno())
        self._end()
        with open(errors, "rb") as file:
            said = _said(file)
        if said:
            print(said, file=sys.stderr)


def factor(value):
    """Simulated seconds a second."""
    try:
        number = float(value)
    except (TypeError, ValueError):
        number = -1.0
    if not (number == 0.0 or 1e-6 <= number <= 1e6) or isinstance(value, bool):
        raise ValueError(f"real_time_factor is {reprlib.repr(value)}, not 0 or a number from 0.000001 to 1000000")
    return number


def words(name, values):
    """A list of texts."""
    if isinstance(values, (str, bytes)) or not hasattr(values, "__iter__"):
        raise ValueError(f"{name} is {reprlib.repr(values)}, no list of texts")
    values = list(values)
    for value in values:
        if not isinstance(value, str) or "\0" in value:
            raise ValueError(f"{name} has {reprlib.repr(value)}, which is not text")
    return values

"""The description of a graph by its library or program."""
from __future__ import annotations

import difflib
import reprlib
import warnings

import numpy as np

from . import checks

MOST_PIXELS = 4096
"""Of a side of a picture."""

class Field:
    """An action, observation or state: the columns `first` to `first + size - 1` of a row."""

    def __init__(self, entry):
        self.name, self.shape, self.first = entry["name"], tuple(entry["shape"]), entry["first"]
        self.size = int(np.prod(self.shape, dtype=int))
        self.dtype = np.dtype(entry["dtype"])
        if self.dtype.kind == "f":
            self.dtype = np.dtype(np.float32)  # as rows are
            lowest, highest = -np.inf, np.inf
        elif self.dtype.kind == "b":
            lowest, highest = False, True
        else:
            lowest, highest = np.iinfo(self.dtype).min, np.iinfo(self.dtype).max
        self.low = self._bound(entry["low"], lowest)
        self.high = self._bound(entry["high"], highest)
        self.columns = slice(self.first, self.first + self.size)

    def _bound(self, numbers, otherwise):
        # Whole numbers of 64 bits arrive as doubles, whose highest is beyond the type's.
        info = None if self.dtype.kind in "fb" else np.iinfo(self.dtype)
        converted = [otherwise if x is None else x if info is None else min(max(int(x), info.min), info.max) for x in numbers]
        return np.array(converted, self.dtype).reshape(self.shape)


def numbers_of(fields):
    return sum(field.size for field in fields)


class Described:
    """A graph, as `description` has it: the actions, observations and states of its rows, its task, what it shows."""

    render_modes = ("rgb_array",)

    def __init__(self, description):
        self.description = description
        self._fields = {what: tuple(Field(entry) for entry in description[what]) for what in ("observations", "actions", "states")}
        self.critic = tuple(Field(entry) for entry in (description["task"] or {}).get("critic", ()))
        self.stages = tuple(stage["name"] for stage in (description["task"] or {}).get("stages", ()))
        self.terms = tuple(description["task"]["terms"]) if description["task"] else ()
        # Of the memory that is read and written, whatever happens to the fields.
        self._sizes = {what: numbers_of(fields) for what, fields in self._fields.items()} | {
            "terms": len(self.terms), "critic": numbers_of(self.critic)}

    observations = property(lambda self: self._fields["observations"])
    actions = property(lambda self: self._fields["actions"])
    states = property(lambda self: self._fields["states"])

    @property
    def has_task(self):
        return self.description["task"] is not None

    @property
    def metadata(self):
        """Of Gymnasium: how environments of this graph can be seen."""
        render = self.description["render"]
        return {"render_modes": list(self.render_modes), "render_fps": render["rate_hz"]} if render else {"render_modes": []}

    def check_render_mode(self, render_mode):
        if render_mode is not None and not (isinstance(render_mode, str) and render_mode in self.metadata["render_modes"]):
            modes = [repr(mode) for mode in self.render_modes]
            known = " or ".join(["None", *modes]) if self.description["render"] else (
                f"None, because its graph has no `render:`; add `render: {{source: OBJECT.scene}}` to it for {' or '.join(modes)}")
            raise ValueError(f"render_mode is {render_mode!r}; for {self.description['graph']} it is {known}")


def spelled(name, known):
    """`name` as the graph spells it: the one of `known` that differs in separators only (`.`, `/`), with a warning; else itself."""
    if name in known or not isinstance(name, str):
        return name
    found = [each for each in known if each.replace("/", ".") == name.replace("/", ".")]
    if len(found) != 1:
        return name
    warnings.warn(f"{name!r} is {found[0]!r} here", stacklevel=4)
    return found[0]


def states_row(library, states, count, what="states"):
    """[count, numbers of states] of {name: value or [count, ...]}; NaN for what is not named."""
    if not hasattr(states, "items"):
        raise ValueError(f"{what} is {reprlib.repr(states)}, not a dict")
    known = {field.name: field for field in library.states}
    row = np.full((count, library._sizes["states"]), np.nan, np.float32)
    for name, value in states.items():
        name = spelled(name, known)
        if name not in known:
            raise ValueError(f"there is no state {reprlib.repr(name)}, but {', '.join(known) or 'none'}")
        field = known[name]
        with np.errstate(over="ignore"):  # to what is in no space
            array = checks.numbers(repr(name), value).astype(np.float32)
        try:
            row[:, field.columns] = np.broadcast_to(array, (count, *field.shape)).reshape(count, -1)
        except ValueError:
            raise ValueError(f"{name!r} has shape {array.shape}, not {field.shape} or {(count, *field.shape)}") from None
    return row


def tuning_row(library, parameters, count):
    """The same of what is set while an episode runs. ValueError for what can be set at resets only."""
    tunable = library.description["tunable"]
    can = f"what can be set while an episode runs: {', '.join(tunable) or 'nothing of this graph'}"
    states = {field.name for field in library.states}
    for name in parameters if hasattr(parameters, "items") else ():
        name = spelled(name, states)
        if name in states and name not in tunable:
            raise ValueError(f"{name!r} can be set at a reset, not while an episode runs; {can}")
        if name not in states:
            near = difflib.get_close_matches(str(name), tunable, 1)
            raise ValueError(f"there is no parameter {reprlib.repr(name)}; {f'did you mean {near[0]!r}? ' if near else ''}{can}")
    return states_row(library, parameters, count, "parameters")


def picture_size(size):
    """(width, height) of a picture."""
    try:
        return tuple(checks.whole("side", side, 1, MOST_PIXELS) for _, side in zip((0, 1), size, strict=True))
    except (TypeError, ValueError):
        raise ValueError(f"size is {reprlib.repr(size)}: width and height are 1 to {MOST_PIXELS} pixels") from None

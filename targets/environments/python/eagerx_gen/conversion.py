"""Between rows of a library, and what Gymnasium's spaces hold."""
from __future__ import annotations

import reprlib

import numpy as np

from .description import numbers_of
from .errors import need


def _spaces():
    return need("gymnasium.spaces", "pip install gymnasium")


def is_choice(field):
    """Whether each number of an action is one of a few whole numbers."""
    return field.dtype.kind in "iu" and all(int(high) - int(low) < 2**31 for low, high in zip(field.low.flat, field.high.flat))


class Box:
    """Some numbers between bounds, as they are in the row. A single one has the shape (1,): networks flatten their inputs."""

    def __init__(self, field):
        self.field, self.shape = field, field.shape or (1,)
        self.space = _spaces().Box(field.low.reshape(self.shape), field.high.reshape(self.shape), self.shape, field.dtype)

    def to_row(self, values, rows):
        rows[:, self.field.columns] = values.reshape(len(rows), -1)

    def from_row(self, rows):
        return rows[:, self.field.columns].reshape(len(rows), *self.shape).astype(self.field.dtype, copy=False)


class Scaled(Box):
    """Numbers from -1 to 1 instead of those between the bounds, as Stable-Baselines3 scales them."""

    def __init__(self, field):
        super().__init__(field)
        if field.dtype.kind != "f" or not (np.isfinite(field.low).all() and np.isfinite(field.high).all()):
            raise ValueError(f"normalize_actions: action {field.name!r} is not a float32 with finite bounds")
        self.space = _spaces().Box(-1.0, 1.0, self.shape, np.float32)
        self._low, self._size = field.low.reshape(-1), (field.high - field.low).reshape(-1)

    def to_row(self, values, rows):
        scaled = np.asarray(values, np.float32).reshape(len(rows), -1)
        rows[:, self.field.columns] = self._low + (np.float32(0.5) * (scaled + np.float32(1.0))) * self._size


class Choice:
    """One whole number of a few."""

    def __init__(self, field):
        self.field = field
        self.space = _spaces().Discrete(int(field.high) - int(field.low) + 1, start=int(field.low))

    def to_row(self, values, rows):
        rows[:, self.field.first] = values.reshape(len(rows))


class Choices(Box):
    """Several whole numbers, each one of a few."""

    def __init__(self, field):
        super().__init__(field)
        counts = np.array([int(high) - int(low) + 1 for low, high in zip(field.low.flat, field.high.flat)], np.int64)
        self.space = _several(counts.reshape(self.shape), field.low.astype(np.int64).reshape(self.shape))


def _several(counts, low):
    """A MultiDiscrete, which begins elsewhere than at 0 only where it must: older ones of Gymnasium cannot."""
    return _spaces().MultiDiscrete(counts, start=low) if low.any() else _spaces().MultiDiscrete(counts)


class Named:
    """Fields in a Dict, in the order of the columns, which is that of the Dict's keys."""

    def __init__(self, what, parts):
        self.what, self.parts = what, parts
        self.space = _spaces().Dict({part.field.name: part.space for part in parts})

    def to_row(self, values, rows):
        if not hasattr(values, "keys") or set(values.keys()) != {part.field.name for part in self.parts}:
            raise ValueError(f"{self.what} is {reprlib.repr(values)}, not a dict with {', '.join(part.field.name for part in self.parts)}")
        # All before the first is written.
        checked = [shaped(values[part.field.name], part.space, len(rows), f"{self.what} {part.field.name!r}") for part in self.parts]
        for part, numbers in zip(self.parts, checked):
            part.to_row(numbers, rows)

    def from_row(self, rows):
        return {part.field.name: part.from_row(rows) for part in self.parts}


class Flat:
    """The row itself."""

    def __init__(self, what, parts):
        self.what, self.parts = what, parts
        boxes = [part.space for part in parts]
        join = lambda side: np.concatenate([np.zeros(0, np.float32), *(getattr(box, side).ravel() for box in boxes)])
        self.space = _spaces().Box(join("low").astype(np.float32), join("high").astype(np.float32), dtype=np.float32)
        self._scales = any(isinstance(part, Scaled) for part in parts)

    def to_row(self, values, rows):
        if not (type(values) is np.ndarray and values.shape == rows.shape and values.dtype is rows.dtype):  # mostly is
            values = shaped(values, self.space, len(rows), self.what)
        if not self._scales:
            rows[...] = values
            return
        for part in self.parts:
            part.to_row(values[:, part.field.columns], rows)

    def from_row(self, rows):
        return rows


class OnlyChoice(Choice):
    """The row of a graph whose only action is a choice."""

    def __init__(self, what, field):
        super().__init__(field)
        self.what = what

    def to_row(self, values, rows):
        super().to_row(shaped(values, self.space, len(rows), self.what), rows)


class OnlyChoices(Flat):
    """The row of a graph whose actions are whole numbers only."""

    def __init__(self, what, fields):
        super().__init__(what, [Box(field) for field in fields])
        join = lambda side: np.concatenate([getattr(field, side).astype(np.int64).ravel() for field in fields])
        self.space = _several(join("high") - join("low") + 1, join("low"))


def one_of(tree, i):
    return {name: part[i] for name, part in tree.items()} if isinstance(tree, dict) else tree[i]


def each_of(tree):
    """one_of() for every row, in less than half the time."""
    if not isinstance(tree, dict):
        return list(tree)
    (first, part), *others = tree.items()
    rows = [{first: value} for value in part]
    for name, part in others:
        for row, value in zip(rows, part):
            row[name] = value
    return rows


def shaped(values, space, count, what):
    """As an array [count, ...] of the space's shape, or a ValueError."""
    array = values if type(values) is np.ndarray else np.asarray(values)
    if array.dtype.kind not in "fiub":
        raise ValueError(f"{what} is {reprlib.repr(values)}, no numbers")
    if array.shape != (count, *space.shape):
        one = (array.shape[1:], space.shape) if count == 1 and array.ndim > 0 else (array.shape, (count, *space.shape))
        raise ValueError(f"{what} has shape {one[0]}, not {one[1]}")
    return array


def of_observations(library, flatten):
    parts = [Box(field) for field in library.observations]
    return Flat("the observation", parts) if flatten else Named("the observation", parts)


def _part_of_action(field):
    if not is_choice(field):
        return Box(field)
    return Choice(field) if field.shape == () else Choices(field)


def of_actions(library, flatten, normalize):
    if flatten and library.actions and all(is_choice(field) for field in library.actions) and not normalize:
        one = len(library.actions) == 1 and library.actions[0].shape == ()
        return OnlyChoice("the action", library.actions[0]) if one else OnlyChoices("the action", library.actions)
    if normalize:
        parts = [Scaled(field) for field in library.actions]
    elif flatten:
        parts = [Box(field) for field in library.actions]
    else:
        parts = [_part_of_action(field) for field in library.actions]
    assert numbers_of([part.field for part in parts]) == numbers_of(library.actions)
    return Flat("the action", parts) if flatten else Named("the action", parts)

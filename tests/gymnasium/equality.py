"""Whether two environments, or vectors of them, do the same."""
import numpy as np


def same(ours, theirs):
    """Equal to the bit, NaN like NaN, in trees of dicts and arrays."""
    if isinstance(theirs, dict):
        return isinstance(ours, dict) and set(ours) == set(theirs) and all(same(ours[key], theirs[key]) for key in theirs)
    ours, theirs = np.asarray(ours), np.asarray(theirs)
    if ours.dtype != theirs.dtype or ours.shape != theirs.shape:
        return False
    if theirs.dtype == object:
        return all((a is None) == (b is None) and (b is None or same(a, b)) for a, b in zip(ours.flat, theirs.flat))
    return np.array_equal(ours, theirs, equal_nan=theirs.dtype.kind == "f")


def compare(ours, theirs, mode, steps, seed=5):
    """Steps both with the same actions. (whether all was equal, how many episodes ended)"""
    generator = np.random.default_rng(0)
    (first, info), (wanted, wanted_info) = ours.reset(seed=seed), theirs.reset(seed=seed)
    equal, ended = same(first, wanted) and same(info, wanted_info), 0
    for _ in range(steps):
        action = sample(ours.action_space, generator)
        *result, info = ours.step(action)
        *wanted, wanted_info = theirs.step(action)
        equal = equal and all(same(a, b) for a, b in zip(result, wanted)) and same(info, wanted_info)
        done = wanted[2] | wanted[3]
        ended += int(done.sum())
        if mode == "Disabled" and done.any():
            (first, info), (wanted, wanted_info) = (each.reset(options={"reset_mask": done}) for each in (ours, theirs))
            equal = equal and same(first, wanted) and same(info, wanted_info)
    return equal, ended


def sample(space, generator):
    """Within the bounds and a little beyond."""
    if hasattr(space, "spaces"):
        return {name: sample(part, generator) for name, part in space.spaces.items()}
    if hasattr(space, "nvec"):  # of choices
        return space.start + generator.integers(space.nvec)
    return generator.uniform(1.2 * space.low, 1.2 * space.high).astype(space.dtype)

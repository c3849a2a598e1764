import numpy as np

from .. import spaces


class Choices:
    """Of several Discrete."""

    def __init__(self, space, n):
        self.nvec, self.start, self.shape = np.full(n, space.n), np.full(n, space.start), (n,)


def batch_space(space, n):
    if isinstance(space, spaces.Dict):
        return spaces.Dict({name: batch_space(part, n) for name, part in space.spaces.items()})
    if isinstance(space, spaces.Discrete):
        return Choices(space, n)
    return spaces.Box(np.repeat(space.low[None], n, 0), np.repeat(space.high[None], n, 0), dtype=space.dtype)


def part(tree, i):
    return {name: part(below, i) for name, below in tree.items()} if isinstance(tree, dict) else tree[i]


def together(trees):
    return {name: together([tree[name] for tree in trees]) for name in trees[0]} if isinstance(trees[0], dict) else np.stack(trees)

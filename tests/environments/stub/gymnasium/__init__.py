"""As much of Gymnasium's interface as eagerx_gen uses, for machines that do not have it (Debian does not). No part of
Gymnasium: tests/gymnasium/run uses the real one."""
import numpy as np

from . import spaces, vector  # noqa: F401

__version__ = "0 (a stub)"


class Env:
    _generator = None

    @property
    def np_random(self):
        if self._generator is None:
            self._generator = np.random.default_rng()
        return self._generator

    def reset(self, *, seed=None, options=None):
        if seed is not None:
            self._generator = np.random.default_rng(seed)

"""The same as half.hpp."""
import numpy as np


class Half:
    def __init__(self, config):
        pass

    def reset(self):
        pass

    def step(self, n, signal):
        return np.float32(0.5) * signal[-1]

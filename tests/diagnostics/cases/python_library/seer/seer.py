"""A node in Python alone."""
import numpy as np


class Seer:
    def __init__(self, config):
        pass

    def reset(self):
        pass

    def step(self, n, signal):
        return np.clip(signal[-1], -1, 1)

"""The same as mixer.hpp, number by number."""
import numpy as np


class Mixer:
    def __init__(self, config):
        self.weight = np.float32(config["weight"])

    def reset(self):
        self.mean = np.zeros(2, np.float32)
        self.seen = 0

    def step(self, n, a, b):
        sums = np.zeros(2, np.float32)
        for value in a.ravel():
            sums[0] = sums[0] + value
        for value in b:
            sums[1] = sums[1] + value
        self.mean = self.weight * self.mean + sums
        self.seen += len(a) + len(b)
        return {"mean": self.mean, "seen": self.seen, "high": [self.mean[0] > 0, self.mean[1] > 0, n % 2 == 1]}

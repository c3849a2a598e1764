"""Finds the orange weight of a pendulum in an image."""
import numpy as np

SIZE = 64
NUMBERS = np.arange(SIZE)


class FindWeight:
    def __init__(self, config):
        pass

    def reset(self):
        pass

    def step(self, n, image):
        red, blue = image[-1][:, :, 0].astype(np.int64), image[-1][:, :, 2].astype(np.int64)
        weight = np.maximum(red - blue - 40, 0)
        total = weight.sum()
        if total == 0:
            return np.zeros(2, np.float32)
        right = weight.sum(axis=0) @ NUMBERS
        down = weight.sum(axis=1) @ NUMBERS
        sums = np.array([right, down], np.float32) / np.float32(total)  # in pixels
        middle = np.float32((SIZE - 1) / 2)
        x, y = (sums - middle) / np.float32(SIZE / 2)
        return np.array([x, -y], np.float32)

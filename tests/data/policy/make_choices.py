#!/usr/bin/python3
"""Writes the policies of libraries/ that choose several numbers at once, and their golden rows, with Debian's
python3-torch:
    cd tests/data/policy && ./make_choices.py
Actions are those of Stable-Baselines3's predict(deterministic=True): of a MultiDiscrete the mode of each Categorical,
of a MultiBinary the mode of each Bernoulli, as stable_baselines3.common.distributions makes them of `action_net`.
"""
import numpy as np
import torch

import make_more_libraries as more
from make_stable_baselines import COMMON, Flat, box, ppo, save_zip


def modes_of_categoricals(nvec):
    """MultiCategoricalDistribution.mode()."""
    def call(logits):
        parts = torch.split(torch.from_numpy(logits)[None], list(nvec), dim=1)
        made = [torch.distributions.Categorical(logits=part) for part in parts]
        return torch.stack([torch.argmax(one.probs, dim=1) for one in made], dim=1).numpy().ravel()
    return call


def modes_of_bernoullis(logits):
    """BernoulliDistribution.mode()."""
    return torch.round(torch.distributions.Bernoulli(logits=torch.from_numpy(logits)).probs).numpy()


if __name__ == "__main__":
    torch.manual_seed(21)
    rng = np.random.default_rng(21)
    observation = box(-4.0, 4.0, (3,))
    draw = lambda: rng.normal(0, 2, 3)
    keywords = {"net_arch": [6]}

    nvec = np.array([3, 2, 4])
    space = more.space("multi_discrete", nvec=nvec, start=np.zeros_like(nvec), dtype=np.dtype(np.int64), _shape=(3,))
    model = ppo(Flat(), 3, int(nvec.sum()))
    save_zip("ppo_multi_discrete", model, COMMON, observation, space, {"n_epochs": 10}, keywords)
    more.golden(model, draw, "ppo_multi_discrete", modes_of_categoricals(nvec), rows=60)

    bits = more.space("multi_binary", n=4, _shape=(4,), dtype=np.dtype(np.int8))
    model = ppo(Flat(), 3, 4)
    save_zip("ppo_multi_binary", model, COMMON, observation, bits, {"n_epochs": 10}, keywords)
    more.golden(model, draw, "ppo_multi_binary", modes_of_bernoullis, rows=60)

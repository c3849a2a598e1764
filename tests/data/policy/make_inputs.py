#!/usr/bin/python3
"""Writes more of torchscript/ and of libraries/, and torch's answers, with Debian's python3-torch:
    cd tests/data/policy && ./make_inputs.py
TorchScript with several inputs, whose sizes are in its layers (encoded) or not (joined), and modules that torch froze, whose
tensors are constants of the code. State dicts whose names say no order of their layers. Golden rows have the inputs of
`forward` side by side.
"""
import copy

import numpy as np
import torch
from torch import nn

import make_stable_baselines as libraries
import make_torchscript as make

rng = np.random.default_rng(9)


class Encoded(nn.Module):
    """No tensor has the size of `obs`, 27: the actor takes it with the 3 numbers of the encoder."""

    def __init__(self):
        super().__init__()
        self.encoder = make.mlp([12, 8, 3], nn.ELU)
        self.actor = make.mlp([30, 6, 2], nn.ELU)

    def forward(self, obs, history):
        return self.actor(torch.cat([obs, self.encoder(history)], -1))


class Joined(nn.Module):
    """Only the sum of 3 and 7 is in the file."""

    def __init__(self):
        super().__init__()
        self.actor = make.mlp([10, 6, 2], nn.ELU)

    def forward(self, command, obs):
        return self.actor(torch.cat([command, obs], -1))


class Trunk(nn.Module):
    """net.0, net.2, mean_head, and a deviation that is for the training."""

    def __init__(self):
        super().__init__()
        self.net = nn.Sequential(nn.Linear(4, 7), nn.ELU(), nn.Linear(7, 6), nn.ELU())
        self.mean_head = nn.Linear(6, 2)
        self.log_std = nn.Parameter(torch.zeros(2))

    def forward(self, x):
        return torch.tanh(self.mean_head(self.net(x)))


class Norms(nn.Module):
    """bn1, fc1, fc2, out: relu in one place, elu in the other."""

    def __init__(self):
        super().__init__()
        self.bn1, self.fc1, self.fc2, self.out = nn.BatchNorm1d(4), nn.Linear(4, 7), nn.Linear(7, 5), nn.Linear(5, 2)
        self.bn1.running_mean += torch.randn(4)
        self.bn1.running_var += torch.rand(4)

    def forward(self, x):
        return self.out(torch.nn.functional.elu(self.fc2(torch.relu(self.fc1(self.bn1(x))))))


def rsl_rl():
    """From 4 on: the actor's modules are obs_normalizer, distribution and mlp."""
    normalizer, mlp = make.EmpiricalNormalization(3), make.mlp([3, 7, 2], nn.ELU)
    actor = {**{f"obs_normalizer.{key}": value for key, value in normalizer.state_dict().items()},
             "distribution.std_param": torch.ones(2), **{f"mlp.{key}": value for key, value in mlp.state_dict().items()}}
    critic = {f"mlp.{key}": value for key, value in make.mlp([3, 5, 1], nn.ELU).state_dict().items()}
    torch.save({"actor_state_dict": actor, "critic_state_dict": critic, "iter": 5, "infos": None}, libraries.OUT / "rsl_rl_4.pt")
    golden(nn.Sequential(normalizer, mlp), (3,), libraries.OUT / "rsl_rl_4")


def golden(module, sizes, path, rows=24):
    exact = copy.deepcopy(module).double()
    columns = {"obs": [], "network_out": [], "network_out_f64": []}
    for _ in range(rows):
        x = rng.normal(0, 1, sum(sizes)).round(2).astype(np.float32)
        parts = torch.from_numpy(x)[None].split(sizes, 1)
        with torch.no_grad():
            columns["network_out"].append(module(*parts).numpy().ravel())
            columns["network_out_f64"].append(exact(*(part.double() for part in parts)).numpy().ravel())
        columns["obs"].append(x)
    np.savez_compressed(f"{path}_golden.npz", **{key: np.array(value) for key, value in columns.items()})


def main():
    torch.manual_seed(31)
    torch.set_num_threads(1)
    for name, module, sizes in (("encoded", Encoded(), (27, 12)), ("joined", Joined(), (3, 7))):
        module.eval()
        make.save(torch.jit.script(module), f"{name}_scripted")
        golden(module, sizes, make.OUT / name)
    module = make.mlp([4, 7, 2], nn.ELU).eval()
    make.save(torch.jit.freeze(torch.jit.script(module)), "frozen_scripted")
    make.save(torch.jit.freeze(torch.jit.trace(module, torch.zeros(1, 4))), "frozen_traced")
    make.save(torch.jit.optimize_for_inference(torch.jit.script(module)), "frozen_inference")
    golden(module, (4,), make.OUT / "frozen")
    rsl_rl()
    for name, module in (("named_trunk", Trunk()), ("named_norms", Norms())):
        module.eval()
        torch.save(module.state_dict(), libraries.OUT / f"{name}.pth")
        golden(module, (4,), libraries.OUT / name)


if __name__ == "__main__":
    main()

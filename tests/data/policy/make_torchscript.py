#!/usr/bin/env python3
"""Writes the TorchScript archives of torchscript/ and their golden rows, with Debian's python3-torch (and python3-onnx for
the branches as ONNX).

The modules have the forms of those that legged_gym, rsl_rl, Isaac Lab, HIMLoco and others export, with random weights.
Golden rows are torch's answers in float32 (network_out) and in float64 (network_out_f64); where `episode_start` is 1
the module was reset. Observations have few digits, so that the files stay small. Run it in this folder.
"""
import copy
import io
import zipfile
from pathlib import Path
from typing import Tuple

import numpy as np
import torch
import torch.nn.functional as F
from torch import nn

OUT = Path("torchscript")
ROWS = 1000
EPISODE = 50
DATE = (1980, 1, 1, 0, 0, 0)


def mlp(sizes, activation):
    layers = []
    for i in range(len(sizes) - 1):
        layers.append(nn.Linear(sizes[i], sizes[i + 1]))
        if i + 2 < len(sizes):
            layers.append(activation())
    return nn.Sequential(*layers)


class EmpiricalNormalization(nn.Module):
    """Statistics as rsl_rl keeps them."""

    def __init__(self, size, eps=1e-2):
        super().__init__()
        self.eps = eps
        self.register_buffer("_mean", torch.randn(1, size))
        self.register_buffer("_var", torch.rand(1, size) + 0.5)
        self.register_buffer("_std", torch.sqrt(self._var))
        self.register_buffer("count", torch.tensor(1000, dtype=torch.long))

    def forward(self, x):
        return (x - self._mean) / (self._std + self.eps)


class Exported(nn.Module):
    """An actor with its normalizer: rsl_rl and Isaac Lab without a memory."""

    def __init__(self, actor, normalizer):
        super().__init__()
        self.actor = actor
        self.normalizer = normalizer

    def forward(self, x):
        return self.actor(self.normalizer(x))

    @torch.jit.export
    def reset(self):
        pass


class OldLstm(nn.Module):
    """legged_gym's exporter of an LSTM."""

    def __init__(self, inputs, hidden, actor, layers=1):
        super().__init__()
        self.actor = actor
        self.is_recurrent = True
        self.memory = nn.LSTM(inputs, hidden, layers)
        self.register_buffer("hidden_state", torch.zeros(layers, 1, hidden))
        self.register_buffer("cell_state", torch.zeros(layers, 1, hidden))

    def forward(self, x):
        out, (h, c) = self.memory(x.unsqueeze(0), (self.hidden_state, self.cell_state))
        self.hidden_state[:] = h
        self.cell_state[:] = c
        return self.actor(out.squeeze(0))

    @torch.jit.export
    def reset_memory(self):
        self.hidden_state[:] = 0.0
        self.cell_state[:] = 0.0


class NewGru(nn.Module):
    """rsl_rl's exporter of a GRU, with its normalizer."""

    def __init__(self, inputs, hidden, actor, layers=1):
        super().__init__()
        self.actor = actor
        self.is_recurrent = True
        self.rnn = nn.GRU(inputs, hidden, layers)
        self.register_buffer("hidden_state", torch.zeros(layers, 1, hidden))
        self.normalizer = EmpiricalNormalization(inputs)

    def forward(self, x):
        x = self.normalizer(x)
        x, h = self.rnn(x.unsqueeze(0), self.hidden_state)
        self.hidden_state[:] = h
        x = x.squeeze(0)
        return self.actor(x)

    @torch.jit.export
    def reset(self):
        self.hidden_state[:] = 0.0


class Branches(nn.Module):
    """An encoder of the last observations, next to the newest one, as HIMLoco has it."""

    def __init__(self, size, frames, latent, actions):
        super().__init__()
        self.size = size
        self.encoder = mlp([size * frames, 24, 3 + latent], nn.ELU)
        self.actor = mlp([size + 3 + latent, 20, actions], nn.ELU)

    def forward(self, history):
        parts = self.encoder(history)
        velocity, latent = parts[..., :3], parts[..., 3:]
        latent = F.normalize(latent, dim=-1, p=2.0)
        return self.actor(torch.cat((history[:, 0:self.size], velocity, latent), dim=-1))


class Residual(nn.Module):
    """Residual additions, a gate, scaling and clipping."""

    def __init__(self):
        super().__init__()
        self.first = nn.Linear(6, 9)
        self.block = nn.Sequential(nn.LayerNorm(9), nn.Linear(9, 9), nn.SiLU())
        self.gate = nn.Linear(9, 9)
        self.last = nn.Linear(9, 2)
        self.register_buffer("scale", torch.tensor([2.0, 0.5]))

    def forward(self, x):
        y = torch.tanh(self.first(x))
        y = y + self.block(y)
        y = y * torch.sigmoid(self.gate(y)) + torch.sin(y)
        return torch.clamp(self.last(y) * self.scale - 0.25, -1.5, 1.5)


class Activations(nn.Module):
    """One of each."""

    def __init__(self):
        super().__init__()
        kinds = [nn.ReLU, nn.Tanh, nn.LeakyReLU, nn.SELU, nn.SiLU, nn.GELU, nn.Sigmoid, nn.Softplus]
        self.layers = nn.ModuleList(nn.Linear(5, 5) for _ in kinds)
        self.kinds = nn.ModuleList(kind() for kind in kinds)

    def forward(self, x):
        for layer, kind in zip(self.layers, self.kinds):
            x = kind(layer(x))
        return x


class Small(nn.Module):
    """Branches and a memory for the pendulum's three numbers: what tests/firmware runs."""

    def __init__(self):
        super().__init__()
        self.encoder = mlp([3, 9, 4], nn.Tanh)
        self.rnn = nn.GRU(3, 5)
        self.register_buffer("hidden_state", torch.zeros(1, 1, 5))
        self.head = nn.Linear(11, 9)
        self.last = nn.Linear(9, 1)

    def forward(self, x):
        y, h = self.rnn(x.unsqueeze(0), self.hidden_state)
        self.hidden_state[:] = h
        z = F.normalize(self.encoder(x), dim=-1)
        y = F.elu(self.head(torch.cat([x[:, 1:], z, y.squeeze(0)], dim=-1)))
        y = y + torch.cos(y) * torch.exp(-y.abs())
        return torch.tanh(self.last(y))


class ByHand(nn.Module):
    """Products of matrices, as written by hand, in half precision."""

    def __init__(self):
        super().__init__()
        self.a = nn.Parameter(torch.randn(4, 8))
        self.b = nn.Parameter(torch.randn(8))
        self.c = nn.Parameter(torch.randn(2, 8))
        self.d = nn.Parameter(torch.randn(2))

    def forward(self, x):
        y = F.relu(torch.matmul(x, self.a) + self.b)
        return torch.addmm(self.d, y, self.c.t())


def golden(make, name, inputs):
    """Answers to random observations; `make` gives the module that answers, in float32 or float64."""
    generator = torch.Generator().manual_seed(7)
    now, exact = make(torch.float32), make(torch.float64)
    states = [state for state in ("hidden_state", "cell_state", "history", "speeds") if hasattr(now, state)]
    columns = {"obs": [], "network_out": [], "network_out_f64": [], "episode_start": []}
    for i in range(ROWS):
        if i % EPISODE == 0:
            for module in (now, exact):
                for state in states:
                    getattr(module, state).zero_()
        x = torch.round(32 * torch.randn(1, inputs, generator=generator)) / 16
        with torch.no_grad():
            columns["obs"].append(x.numpy().ravel())
            columns["network_out"].append(now(x).numpy().ravel())
            columns["network_out_f64"].append(exact(x.double()).numpy().ravel())
        columns["episode_start"].append([float(i % EPISODE == 0)])
    if not states:
        del columns["episode_start"]
    np.savez_compressed(OUT / f"{name}_golden.npz", **{key: np.array(value) for key, value in columns.items()})


def save(program, name):
    """Without torch's padding of megabytes and its notes for debuggers."""
    buffer = io.BytesIO()
    torch.jit.save(program, buffer)
    with zipfile.ZipFile(buffer) as full, zipfile.ZipFile(OUT / f"{name}.pt", "w", zipfile.ZIP_DEFLATED) as file:
        for entry in full.namelist():
            if not entry.endswith(".debug_pkl"):
                path = f"{name}/{entry.split('/', 1)[1]}"
                file.writestr(zipfile.ZipInfo(path, DATE), full.read(entry), zipfile.ZIP_DEFLATED)


def write(name, module, inputs, *ways):
    """One file for each of the ways "scripted", "traced", "half" (scripted) and "onnx", and the answers of all."""
    module.eval()
    if "half" in ways:
        module = copy.deepcopy(module).half()
    for way in ways:
        if way == "onnx":
            torch.onnx.export(module, torch.zeros(1, inputs), str(OUT / f"{name}.onnx"), opset_version=14)
            continue
        traced = way == "traced"
        save(torch.jit.trace(module, torch.zeros(1, inputs)) if traced else torch.jit.script(module), f"{name}_{way}")
    golden(lambda kind: copy.deepcopy(module).to(kind), name, inputs)


def main():
    torch.manual_seed(5)
    torch.set_num_threads(1)
    OUT.mkdir(exist_ok=True)
    write("mlp", mlp([8, 16, 12, 3], nn.ELU), 8, "scripted", "traced")
    write("activations", Activations(), 5, "scripted", "traced")
    write("normalizer", Exported(mlp([7, 10, 2], nn.ELU), EmpiricalNormalization(7)), 7, "scripted", "traced")
    write("identity", Exported(mlp([7, 10, 2], nn.ELU), nn.Identity()), 7, "scripted")
    write("lstm", OldLstm(6, 8, mlp([8, 6, 2], nn.ELU)), 6, "scripted")
    write("lstm_two", OldLstm(6, 5, mlp([5, 6, 2], nn.ELU), 2), 6, "scripted")
    write("gru", NewGru(6, 8, mlp([8, 6, 2], nn.ELU)), 6, "scripted")
    write("branches", Branches(6, 3, 4, 2), 18, "scripted", "traced", "onnx")
    write("residual", Residual(), 6, "scripted", "traced", "onnx")
    write("small", Small(), 3, "scripted")
    write("by_hand", ByHand(), 4, "half")


if __name__ == "__main__":
    main()

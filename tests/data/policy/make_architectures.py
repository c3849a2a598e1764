#!/usr/bin/env python3
"""Writes the policies of architectures/ and their golden rows, with Debian's python3-torch and python3-onnx.

The networks have random weights. Golden rows are torch's answers in float32 (network_out) and in float64
(network_out_f64); with `episode_start` the states of the row before go into the next one.
recurrent_ppo.zip is put together here: the tensors of sb3-contrib's RecurrentPPO under their names, and what
Stable-Baselines3 wrote about ppo_64.zip. Run it in this folder.
"""
import copy
import io
import json
import zipfile
from pathlib import Path

import numpy as np
import onnx
import torch
from torch import nn

OUT = Path("architectures")


class Recurrent(nn.Module):
    """(encoder,) GRU or LSTM, head; states go in and come out."""

    def __init__(self, cell, layers, batch_first, encoder=False, squash=True):
        super().__init__()
        self.squash = squash
        self.encoder = nn.Linear(3, 5) if encoder else None
        self.rnn = getattr(nn, cell)(5 if encoder else 3, 8, layers, batch_first=batch_first)
        self.head = nn.Linear(8, 1)

    def forward(self, x, *states):
        if self.encoder is not None:
            x = torch.relu(self.encoder(x))
        y, states = self.rnn(x, states[0] if len(states) == 1 else states)
        action = torch.tanh(self.head(y)) if self.squash else self.head(y)
        return (action, *(states if isinstance(states, tuple) else (states,)))


class Frames(nn.Module):
    """Four observations of the pendulum, oldest first, through a convolution over time."""

    def __init__(self):
        super().__init__()
        self.net = nn.Sequential(
            nn.Conv1d(3, 6, 2), nn.ELU(), nn.Conv1d(6, 4, 2, groups=2, padding=1), nn.ReLU(),
            nn.AvgPool1d(2, stride=1), nn.Flatten(), nn.Linear(12, 1), nn.Tanh())

    def forward(self, x):
        return self.net(x.transpose(1, 2))


class Image(nn.Module):
    """A small NatureCNN: uint8 pixels, divided by 255 first."""

    def __init__(self):
        super().__init__()
        self.net = nn.Sequential(
            nn.Conv2d(1, 4, 4, stride=2, padding=1), nn.ReLU(), nn.MaxPool2d(2, padding=1),
            nn.Conv2d(4, 6, 3, padding=(2, 1), groups=2, dilation=(2, 1)), nn.SiLU(),
            nn.AvgPool2d(2, stride=1, padding=1), nn.Conv2d(6, 3, 1, bias=False), nn.BatchNorm2d(3), nn.Flatten(),
            nn.Linear(75, 8), nn.ReLU(), nn.Linear(8, 2))
        self.net[7].running_mean.normal_()
        self.net[7].running_var.uniform_(0.5, 2.0)

    def forward(self, x):
        return self.net(x.to(self.net[0].weight.dtype) / 255.0)


class Scaled(nn.Module):
    """Statistics before, LayerNorm and gelu inside, bounds behind."""

    def __init__(self):
        super().__init__()
        self.register_buffer("mean", torch.tensor([0.1, -0.2, 3.0]))
        self.register_buffer("var", torch.tensor([1.0, 2.0, 9.0]))
        self.register_buffer("scale", torch.tensor([2.0, 3.0]))
        self.register_buffer("offset", torch.tensor([0.0, -1.0]))
        self.net = nn.Sequential(
            nn.Linear(3, 12), nn.LayerNorm(12), nn.GELU(), nn.Linear(12, 9), nn.LayerNorm(9, elementwise_affine=False),
            nn.GELU("tanh"), nn.Linear(9, 5), nn.ReLU6(), nn.BatchNorm1d(5), nn.Linear(5, 2), nn.Tanh())
        self.net[8].running_mean.normal_()
        self.net[8].running_var.uniform_(0.5, 2.0)
        nn.init.normal_(self.net[1].weight)
        nn.init.normal_(self.net[1].bias)

    def forward(self, x):
        x = torch.clamp((x - self.mean) / torch.sqrt(self.var + 1e-8), -10, 10)
        return torch.clamp(self.net(x) * self.scale + self.offset, -2.5, 1.5)


class Memory(nn.Module):
    """sb3-contrib's RecurrentPPO: LSTM, then the network of PPO."""

    def __init__(self):
        super().__init__()
        self.lstm_actor = nn.LSTM(3, 8, 1)
        self.lstm_critic = nn.LSTM(3, 8, 1)
        self.mlp_extractor = nn.ModuleDict({
            "policy_net": nn.Sequential(nn.Linear(8, 6), nn.Tanh()),
            "value_net": nn.Sequential(nn.Linear(8, 6), nn.Tanh())})
        self.action_net = nn.Linear(6, 1)
        self.value_net = nn.Linear(6, 1)
        self.log_std = nn.Parameter(torch.zeros(1))

    def forward(self, x, *states):
        y, states = self.lstm_actor(x, states)
        return (self.action_net(self.mlp_extractor["policy_net"](y)), *states)


def golden(model, example, states, name, rows=60, episode=20):
    """Answers to random observations."""
    generator = torch.Generator().manual_seed(7)
    exact = copy.deepcopy(model).double()
    columns = {"obs": [], "network_out": [], "network_out_f64": [], "episode_start": []}
    for i in range(rows):
        if i % episode == 0:
            now, now_exact = states, tuple(state.double() for state in states)
        if example.dtype == torch.uint8:
            x = torch.randint(0, 256, example.shape, generator=generator, dtype=torch.uint8)
        else:
            x = 2 * torch.randn(example.shape, generator=generator)
        with torch.no_grad():
            y = model(x, *now)
            y_exact = exact(x if example.dtype == torch.uint8 else x.double(), *now_exact)
        if states:
            y, *now = y
            y_exact, *now_exact = y_exact
        columns["obs"].append(x.double().numpy().ravel())
        columns["network_out"].append(y.double().numpy().ravel())
        columns["network_out_f64"].append(y_exact.numpy().ravel())
        columns["episode_start"].append([float(i % episode == 0)])
    if not states:
        del columns["episode_start"]
    np.savez_compressed(OUT / f"{name}_golden.npz", **{key: np.array(value) for key, value in columns.items()})


def export(model, name, example, states=(), opset=14):
    model.eval()
    names = ["h", "c"][: len(states)]
    torch.onnx.export(
        model, (example, *states), str(OUT / f"{name}.onnx"), opset_version=opset,
        input_names=["observation", *names], output_names=["action", *(f"new_{n}" for n in names)])
    golden(model, example, states, name)


def recurrent_ppo():
    model = Memory()
    buffer = io.BytesIO()
    torch.save(model.state_dict(), buffer)
    with zipfile.ZipFile("ppo_64.zip") as known:
        data = json.loads(known.read("data"))
    data["policy_class"]["__module__"] = "sb3_contrib.common.recurrent.policies"
    data["policy_kwargs"] = {"net_arch": {"pi": [6], "vf": [6]}}
    with zipfile.ZipFile(OUT / "recurrent_ppo.zip", "w") as file:
        for entry, content in (("data", json.dumps(data)), ("policy.pth", buffer.getvalue()),
                               ("_stable_baselines3_version", "2.3.2")):
            file.writestr(zipfile.ZipInfo(entry), content)
    golden(model, torch.zeros(1, 1, 3), (torch.zeros(1, 1, 8),) * 2, "recurrent_ppo")


def lies():
    """Models that are wrong in one way each, for tests/diagnostics."""
    folder = Path("../../diagnostics/cases/files")
    model = onnx.load(OUT / "gru.onnx")
    node = next(node for node in model.graph.node if node.op_type == "GRU")
    state = node.input[5]
    node.input[5] = ""
    onnx.save(model, folder / "memory_zero.onnx")
    node.input[5] = state
    node.input[1], node.input[2] = node.input[2], node.input[1]
    onnx.save(model, folder / "memory_sizes.onnx")
    node.input[1], node.input[2] = node.input[2], node.input[1]
    del model.graph.output[1]
    onnx.save(model, folder / "memory_lost.onnx")


def main():
    torch.manual_seed(3)
    OUT.mkdir(exist_ok=True)
    observation = torch.zeros(1, 1, 3)
    export(Recurrent("GRU", 1, False), "gru", observation, (torch.zeros(1, 1, 8),))
    export(Recurrent("LSTM", 2, True, encoder=True), "lstm", observation, (torch.zeros(2, 1, 8),) * 2)
    export(Frames(), "frames", torch.zeros(1, 4, 3))
    export(Image(), "image", torch.zeros(1, 1, 12, 12, dtype=torch.uint8))
    export(Scaled(), "scaled", torch.zeros(1, 3))
    recurrent_ppo()
    lies()
    plain = Recurrent("GRU", 2, False, squash=False)
    np.savez(OUT / "gru_state_dict.npz", **{name: value.numpy() for name, value in plain.state_dict().items()})
    golden(plain, observation, (torch.zeros(2, 1, 8),), "gru_state_dict")


if __name__ == "__main__":
    main()

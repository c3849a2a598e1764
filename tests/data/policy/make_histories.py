#!/usr/bin/python3
"""Writes more TorchScript archives of torchscript/ and their golden rows, in the way of make_torchscript.py:
    cd tests/data/policy && ./make_histories.py
Convolutions over a history of observations as parkour policies have them, histories that modules keep in buffers,
comparisons with `where`, and modules that return several results.
"""
import copy
from typing import Tuple

import torch
import torch.nn.functional as F
from torch import nn

import make_torchscript as make
from make_torchscript import mlp


class History(nn.Module):
    """Every observation goes through an encoder, and their sequence through convolutions (StateHistoryEncoder)."""

    def __init__(self, size, steps, actions):
        super().__init__()
        self.size, self.steps = size, steps
        self.encoder = nn.Sequential(nn.Linear(size, 9), nn.ELU())
        self.conv_layers = nn.Sequential(nn.Conv1d(9, 6, kernel_size=4, stride=2), nn.ELU(),
                                         nn.Conv1d(6, 4, kernel_size=2, stride=1), nn.ELU(), nn.Flatten())
        self.linear_output = nn.Sequential(nn.Linear(12, 5), nn.ELU())
        self.actor = mlp([size + 5, 12, actions], nn.ELU)

    def forward(self, obs):
        nd = obs.shape[0]
        projection = self.encoder(obs.reshape([nd * self.steps, -1]))
        output = self.conv_layers(projection.reshape([nd, self.steps, -1]).permute((0, 2, 1)))
        latent = self.linear_output(output)
        return self.actor(torch.cat((obs[:, -self.size:], latent), dim=-1))


class KeptFrames(nn.Module):
    """Keeps the last four observations, newest last, for an encoder."""

    def __init__(self):
        super().__init__()
        self.encoder = mlp([20, 9, 3], nn.ELU)
        self.actor = mlp([8, 7, 2], nn.ELU)
        self.register_buffer("history", torch.zeros(1, 4, 5))

    def forward(self, x):
        self.history = torch.cat((self.history[:, 1:], x.unsqueeze(1)), dim=1)
        return self.actor(torch.cat((x, self.encoder(self.history.flatten(1))), dim=-1))


class KeptFlat(nn.Module):
    """Newest first, in one row, written in place; the observation is normalized before it is kept (HIMLoco)."""

    def __init__(self):
        super().__init__()
        self.normalizer = make.EmpiricalNormalization(3)
        self.actor = mlp([12, 8, 2], nn.ELU)
        self.register_buffer("history", torch.zeros(1, 12))

    def forward(self, x):
        before = self.history[:, :-3].clone()
        self.history[:] = torch.cat((self.normalizer(x), before), dim=-1)
        return self.actor(self.history)


class KeptRolled(nn.Module):
    """Two histories of different length, rolled; of the second only two numbers of the observation are kept."""

    def __init__(self):
        super().__init__()
        self.actor = mlp([27, 8, 2], nn.Tanh)
        self.register_buffer("history", torch.zeros(1, 3, 5))
        self.register_buffer("speeds", torch.zeros(1, 2, 6))

    def forward(self, x):
        self.history = torch.roll(self.history, 1, 1)
        self.history[:, 0] = x
        self.speeds[:, :, :-1] = self.speeds[:, :, 1:].clone()
        self.speeds[:, :, -1] = x[:, 2:4]
        return self.actor(torch.cat((self.history.flatten(1), self.speeds.flatten(1)), dim=-1))


class KeptBefore(nn.Module):
    """The encoder reads the observations before this one, in a convolution; a GRU follows."""

    def __init__(self):
        super().__init__()
        self.encoder = nn.Sequential(nn.Conv1d(3, 4, 3), nn.ELU(), nn.Flatten())
        self.rnn = nn.GRU(11, 6)
        self.head = nn.Linear(6, 2)
        self.register_buffer("history", torch.zeros(1, 3, 4))
        self.register_buffer("hidden_state", torch.zeros(1, 1, 6))

    def forward(self, x):
        y = torch.cat((x, self.encoder(self.history)), dim=-1)
        self.history = torch.cat((self.history[:, :, 1:], x.unsqueeze(-1)), dim=-1)
        y, h = self.rnn(y.unsqueeze(0), self.hidden_state)
        self.hidden_state[:] = h
        return self.head(y.squeeze(0))


class KeptActions(nn.Module):
    """What it keeps depends on what it kept: its own actions."""

    def __init__(self):
        super().__init__()
        self.actor = mlp([9, 6, 2], nn.Tanh)
        self.register_buffer("actions", torch.zeros(1, 4))

    def forward(self, x):
        y = self.actor(torch.cat((x, self.actions), dim=-1))
        self.actions = torch.cat((self.actions[:, 2:], y), dim=-1)
        return y


class KeptMean(nn.Module):
    """A running mean."""

    def __init__(self):
        super().__init__()
        self.actor = mlp([5, 6, 2], nn.Tanh)
        self.register_buffer("mean", torch.zeros(1, 5))

    def forward(self, x):
        self.mean = 0.9 * self.mean + 0.1 * x
        return self.actor(x - self.mean)


class Picture(nn.Module):
    """A small picture: convolutions with padding, pools, a norm."""

    def __init__(self):
        super().__init__()
        self.a = nn.Conv2d(1, 4, 3, padding=1)
        self.norm = nn.BatchNorm2d(4)
        self.norm.running_mean.normal_()
        self.norm.running_var.uniform_(0.5, 1.5)
        self.b = nn.Conv2d(4, 6, (3, 2), stride=(1, 2), groups=2, dilation=1, bias=False)
        self.head = nn.Linear(6, 2)

    def forward(self, x):
        y = F.relu(self.norm(self.a(x.view(-1, 1, 6, 8))))
        y = F.elu(self.b(F.pad(F.max_pool2d(y, 2, 1), [1, 1, 0, 0])))
        y = F.avg_pool2d(y, 2)
        return self.head(F.adaptive_avg_pool2d(y, 1).flatten(1))


class Conditions(nn.Module):
    """Operations with comparisons: dead bands, masks, gaits."""

    def __init__(self):
        super().__init__()
        self.encoder = nn.Linear(6, 8)
        self.head = nn.Linear(8, 3)
        self.register_buffer("limit", torch.tensor([0.5, -0.25, 0.0, 1.0, 0.1, -1.0, 0.75, 0.3]))

    def forward(self, x):
        y = self.encoder(x)
        y = torch.where(y > self.limit, y, 0.5 * y - 1.0)
        y = torch.where((y >= -2.0) & (y < 1.5), y, torch.zeros_like(y))
        y = y.masked_fill(x[:, :1] <= -1.0, 0.25)
        standing = ~(torch.abs(x[:, 1:2]) > 0.5)
        y = torch.where(standing | (x[:, 2:3] == 0.0), y, torch.maximum(y, 0.1 * y * y))
        return self.head(y) * torch.sign(x[:, 3:4]) + (x[:, 4:5] != 0.0).float()


class Several(nn.Module):
    """A value, and the action with its deviation."""

    def __init__(self):
        super().__init__()
        self.actor = mlp([5, 8, 3], nn.Tanh)
        self.critic = mlp([5, 7, 1], nn.Tanh)
        self.log_std = nn.Parameter(torch.zeros(3))

    def forward(self, x) -> Tuple[torch.Tensor, Tuple[torch.Tensor, torch.Tensor]]:
        mean = self.actor(x)
        return self.critic(x), (mean, torch.exp(self.log_std) + 0.0 * mean)


class Reordered(nn.Module):
    """Another order of joints in the simulation than on the robot."""

    def __init__(self):
        super().__init__()
        self.actor = mlp([6, 8, 3], nn.ELU)
        self.register_buffer("back", torch.tensor([2, 0, 1]))

    def forward(self, x):
        joints = x[:, 2:6][:, [3, 1, 0, 2]]
        return torch.index_select(self.actor(torch.cat((x[:, :2], joints), dim=-1)), 1, self.back)


class SomeJoints(nn.Module):
    """Moves some of the joints; the others get what a constant or the observation says."""

    def __init__(self, keeps):
        super().__init__()
        self.actor = mlp([6, 8, 3], nn.ELU)
        self.register_buffer("joints", torch.tensor([4, 0, -3]))
        self.keeps = keeps

    def forward(self, x):
        every = x[:, 1:].clone() if self.keeps else 0.25 * torch.ones(x.shape[0], 5, dtype=x.dtype)
        every[:, self.joints] = self.actor(x).view(3)
        return every


def several():
    module = Several().eval()
    make.save(torch.jit.script(module), "several_scripted")
    make.save(torch.jit.trace(module, torch.zeros(1, 5)), "several_traced")

    def answering(kind):
        same = copy.deepcopy(module).to(kind)
        return lambda x: same(x)[1][0]
    make.golden(answering, "several", 5)


if __name__ == "__main__":
    torch.manual_seed(31)
    torch.set_num_threads(1)
    make.write("history", History(4, 10, 2), 40, "scripted", "traced", "onnx")
    make.write("picture", Picture(), 48, "scripted", "traced")
    make.write("conditions", Conditions(), 6, "scripted", "traced", "onnx")
    several()
    make.write("reordered", Reordered(), 6, "traced", "onnx")
    make.write("some_joints", SomeJoints(False), 6, "traced")
    make.write("kept_joints", SomeJoints(True), 6, "traced")
    make.write("kept_frames", KeptFrames(), 5, "scripted")
    make.write("kept_flat", KeptFlat(), 3, "scripted")
    make.write("kept_rolled", KeptRolled(), 5, "scripted")
    make.write("kept_before", KeptBefore(), 3, "scripted")
    make.save(torch.jit.script(KeptActions().eval()), "kept_actions_scripted")
    make.save(torch.jit.script(KeptMean().eval()), "kept_mean_scripted")

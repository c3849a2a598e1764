#!/usr/bin/env python3
"""Writes the policies of libraries/ and their golden rows, with Debian's python3-torch.

The networks have random weights and the names of the libraries' tensors. In the zips of Stable-Baselines3 the spaces
are pickled as gymnasium's classes are, by stand-ins of the same names, so that neither library is needed. Golden rows
are torch's answers in float32 (network_out) and float64 (network_out_f64), and the action where the library's
predict() is plain. NatureCNN has fewer channels here than its 32, 64 and 64: the files stay small. Run it in this
folder, with another folder as argument for larger ones of everything.
"""
import base64
import copy
import io
import json
import pickle
import sys
import types
import zipfile
from pathlib import Path

import numpy as np
import torch
from torch import nn

OUT = Path(sys.argv[1] if len(sys.argv) > 1 else "libraries")
rng = np.random.default_rng(5)


def stand_in(name):
    """A class that pickles as gymnasium.spaces.NAME."""
    folder, module = "gymnasium.spaces", {"Box": "box", "Dict": "dict", "Discrete": "discrete"}[name]
    for part in ("gymnasium", folder, f"{folder}.{module}"):
        sys.modules.setdefault(part, types.ModuleType(part))
    made = type(name, (), {"__module__": f"{folder}.{module}"})
    setattr(sys.modules[f"{folder}.{module}"], name, made)
    return made


Box, Dict, Discrete = (stand_in(name) for name in ("Box", "Dict", "Discrete"))


def box(low, high, shape, dtype=np.float32):
    space = Box()
    space.dtype = np.dtype(dtype)
    space._shape = shape
    space.low, space.high = (np.broadcast_to(np.asarray(x, dtype), shape).copy() for x in (low, high))
    space._np_random = None
    return space


def dictionary(**spaces):
    space = Dict()
    space.spaces = spaces
    space._shape = space.dtype = None
    return space


def discrete(n, start=0):
    space = Discrete()
    space.n, space.start = np.int64(n), np.int64(start)
    space._shape, space.dtype = (), np.dtype(np.int64)
    return space


def mlp(*sizes, activation=nn.ReLU, head=False):
    """Linear and activation in turn; without the last activation where it is a head."""
    layers = []
    for i, (a, b) in enumerate(zip(sizes, sizes[1:])):
        layers.append(nn.Linear(a, b))
        if not head or i + 2 < len(sizes):
            layers.append(activation())
    return nn.Sequential(*layers)


class NatureCnn(nn.Module):
    def __init__(self, shape, features, channels=(4, 6, 5)):
        super().__init__()
        c, h, w = shape
        self.cnn = nn.Sequential(nn.Conv2d(c, channels[0], 8, 4), nn.ReLU(), nn.Conv2d(channels[0], channels[1], 4, 2),
                                 nn.ReLU(), nn.Conv2d(channels[1], channels[2], 3, 1), nn.ReLU(), nn.Flatten())
        count = self.cnn(torch.zeros(1, c, h, w)).shape[1]
        self.linear = nn.Sequential(nn.Linear(count, features), nn.ReLU())

    def forward(self, x):
        return self.linear(self.cnn(x))


class Flat(nn.Module):
    def forward(self, x):
        return x.flatten(1)


class BatchRenorm(nn.Module):
    """sb3-contrib's, after the training."""

    def __init__(self, count):
        super().__init__()
        self.register_buffer("ra_mean", torch.randn(count))
        self.register_buffer("ra_var", torch.rand(count) + 0.5)
        self.register_buffer("steps", torch.tensor(1000))
        self.scale = nn.Parameter(torch.rand(count) + 0.5)
        self.bias = nn.Parameter(torch.randn(count))

    def forward(self, x):
        return self.scale * ((x - self.ra_mean) / torch.sqrt(self.ra_var + 0.001)) + self.bias


class Actor(nn.Module):
    """Modules by their dotted names; `call` is what the library does with them."""

    def __init__(self, call, scale=1.0, **modules):
        super().__init__()
        self.call, self.scale = call, scale
        for path, module in modules.items():
            where = self
            *folders, last = path.split("__")
            for folder in folders:
                if not hasattr(where, folder):
                    setattr(where, folder, nn.Module())
                where = getattr(where, folder)
            setattr(where, last, nn.Parameter(module) if isinstance(module, torch.Tensor) else module)

    def forward(self, x):
        return self.call(self, x / self.scale)


def golden(model, shape, name, action=None, image=False, rows=24):
    exact = copy.deepcopy(model).double()
    columns = {"obs": [], "network_out": [], "network_out_f64": []}
    for _ in range(rows):
        x = rng.integers(0, 256, shape).astype(np.float32) if image else rng.normal(0, 2, shape).astype(np.float32)
        with torch.no_grad():
            y = model(torch.from_numpy(x)[None]).numpy().ravel()
            y_exact = exact(torch.from_numpy(x).double()[None]).numpy().ravel()
        columns["obs"].append(x.astype(np.uint8).ravel() if image else x.ravel())
        columns["network_out"].append(y)
        columns["network_out_f64"].append(y_exact)
        if action is not None:
            columns.setdefault("action", []).append(np.atleast_1d(action(y_exact)))
    np.savez_compressed(OUT / f"{name}_golden.npz", **{key: np.array(value) for key, value in columns.items()})


def serialized(space):
    return {":type:": str(type(space)), ":serialized:": base64.b64encode(pickle.dumps(space, 4)).decode()}


def save_zip(name, model, module, observation, action, rest=None, keywords=None):
    """The part of Stable-Baselines3's save() that readers use."""
    data = {"policy_class": {":type:": "<class 'abc.ABCMeta'>", "__module__": module},
            "policy_kwargs": keywords or {}, "num_timesteps": 100, "use_sde": False,
            "observation_space": serialized(observation), "action_space": serialized(action), **(rest or {})}
    buffer = io.BytesIO()
    torch.save(model.state_dict(), buffer)
    with zipfile.ZipFile(OUT / f"{name}.zip", "w", zipfile.ZIP_DEFLATED) as file:
        for entry, content in (("data", json.dumps(data)), ("policy.pth", buffer.getvalue()),
                               ("_stable_baselines3_version", "2.3.2")):
            file.writestr(zipfile.ZipInfo(entry), content, zipfile.ZIP_DEFLATED)


LOW, HIGH = np.array([-2.0, -1.0]), np.array([2.0, 3.0])
COMMON, SAC, TD3 = "stable_baselines3.common.policies", "stable_baselines3.sac.policies", "stable_baselines3.td3.policies"


def clipped(y):
    return np.clip(y, LOW, HIGH)


def unscaled(y):
    return LOW + 0.5 * (y + 1.0) * (HIGH - LOW)


def ppo(extractor, features, outputs, net=(6,), activation=nn.Tanh, scale=1.0, output=None):
    """The extractor is there under three names, as in SB3."""
    def call(m, x):
        y = m.action_net(m.mlp_extractor.policy_net(m.pi_features_extractor(x)))
        return y if output is None else output(y)
    return Actor(call, scale, features_extractor=extractor, pi_features_extractor=extractor,
                 vf_features_extractor=extractor, mlp_extractor__policy_net=mlp(features, *net, activation=activation),
                 mlp_extractor__value_net=mlp(features, 7, activation=activation),
                 action_net=nn.Linear(net[-1] if net else features, outputs), value_net=nn.Linear(7, 1),
                 log_std=torch.zeros(outputs))


def sac(observations, net=(8, 6), activation=nn.ReLU, latent=None, mu=None, extractor=None, scale=1.0, features=None):
    last = net[-1] if net else features or observations
    return Actor(lambda m, x: torch.tanh(m.actor.mu(m.actor.latent_pi(m.actor.features_extractor(x)))), scale,
                 actor__features_extractor=extractor or Flat(),
                 actor__latent_pi=latent or mlp(features or observations, *net, activation=activation),
                 actor__mu=mu or nn.Linear(last, 2), actor__log_std=nn.Linear(last, 2),
                 critic__qf0=mlp(observations + 2, 4, 1, head=True))


def stable_baselines():
    vector, action = box(-3.0, 3.0, (3,)), box(LOW, HIGH, (2,))
    image, number = box(0, 255, (3, 36, 36), np.uint8), discrete(3)
    on_policy = {"n_epochs": 10}

    model = ppo(NatureCnn((3, 36, 36), 9), 9, 2, scale=255.0)
    save_zip("ppo_cnn", model, COMMON, image, action, on_policy,
             {"net_arch": [6], "features_extractor_kwargs": {"features_dim": 9}})
    golden(model, (3, 36, 36), "ppo_cnn", clipped, image=True, rows=6)

    model = ppo(NatureCnn((1, 40, 36), 6), 6, 2, net=())
    save_zip("a2c_cnn", model, COMMON, box(0, 255, (1, 40, 36), np.uint8), action, None,
             {"normalize_images": False, "net_arch": []})
    golden(model, (1, 40, 36), "a2c_cnn", clipped, image=True, rows=4)

    model = Actor(lambda m, x: m.q_net.q_net(m.q_net.features_extractor(x)), 255.0,
                  q_net__features_extractor=NatureCnn((1, 36, 36), 6), q_net__q_net=mlp(6, 3, head=True))
    model.q_net_target = copy.deepcopy(model.q_net)
    save_zip("dqn_cnn", model, "stable_baselines3.dqn.policies", box(0, 255, (1, 36, 36), np.uint8), number)
    golden(model, (1, 36, 36), "dqn_cnn", np.argmax, image=True, rows=4)

    model = sac(0, (5,), extractor=NatureCnn((1, 36, 36), 6), features=6, scale=255.0)
    save_zip("sac_cnn", model, SAC, box(0, 255, (1, 36, 36), np.uint8), action, None, {"net_arch": [5]})
    golden(model, (1, 36, 36), "sac_cnn", unscaled, image=True, rows=4)

    model = ppo(Flat(), 3, 2, activation=nn.Tanh, output=torch.tanh)
    save_zip("ppo_sde_squash", model, COMMON, vector, action, {"use_sde": True, **on_policy},
             {"squash_output": True, "net_arch": {"pi": [6], "vf": [7]}})
    golden(model, (3,), "ppo_sde_squash", unscaled)

    model = ppo(Flat(), 3, 3, activation=nn.ELU)
    save_zip("maskable_ppo", model, "sb3_contrib.common.maskable.policies", vector, discrete(3, start=1), on_policy,
             {":type:": "<class 'dict'>", ":serialized:": "gAR9lC4=",
              "activation_fn": "<class 'torch.nn.modules.activation.ELU'>", "net_arch": {"pi": [6], "vf": [7]}})
    golden(model, (3,), "maskable_ppo", lambda y: np.argmax(y) + 1)

    model = sac(3, mu=nn.Sequential(nn.Linear(6, 2), nn.Hardtanh(-0.1, 0.1)))
    model.actor.log_std = nn.Parameter(torch.zeros(6, 2))
    save_zip("sac_sde", model, SAC, vector, action, {"use_sde": True}, {"clip_mean": 0.1, "use_sde": True})
    golden(model, (3,), "sac_sde", unscaled)

    model = sac(3, ())
    save_zip("sac_linear", model, SAC, vector, action, None, {"net_arch": {"pi": [], "qf": [4]}})
    golden(model, (3,), "sac_linear", unscaled)

    model = sac(3, latent=nn.Sequential(BatchRenorm(3), nn.Linear(3, 8), nn.ReLU(), BatchRenorm(8), nn.Linear(8, 6),
                                        nn.ReLU()))
    save_zip("crossq", model, "sb3_contrib.crossq.policies", vector, action)
    golden(model, (3,), "crossq", unscaled)

    model = Actor(lambda m, x: torch.tanh(m.actor.mu(x)), actor__mu=mlp(3, 8, 6, 2, head=True),
                  critic__qf0=mlp(5, 4, 1, head=True))
    save_zip("td3", model, TD3, vector, action, None, {"net_arch": [8, 6]})
    golden(model, (3,), "td3", unscaled)

    model = Actor(lambda m, x: m.quantile_net.quantile_net(x).view(-1, 5, 3).mean(1),
                  quantile_net__quantile_net=mlp(3, 8, 15, head=True))
    model.quantile_net_target = copy.deepcopy(model.quantile_net)
    save_zip("qrdqn", model, "sb3_contrib.qrdqn.policies", dictionary(angle=box(-4.0, 4.0, (2,)), speed=box(-9, 9, (1,))),
             number, None, {"n_quantiles": 5, "net_arch": [8]})
    golden(model, (3,), "qrdqn", np.argmax)

    model = Actor(lambda m, x: torch.tanh(m.action_net(x)), action_net=mlp(3, 8, 2, head=True))
    save_zip("ars", model, "sb3_contrib.ars.policies", vector, action, None, {"net_arch": [8]})
    golden(model, (3,), "ars", unscaled)

    model = Actor(lambda m, x: m.action_net(x), action_net=nn.Sequential(nn.Linear(3, 2, bias=False)))
    save_zip("ars_linear", model, "sb3_contrib.ars.policies", vector, action)
    golden(model, (3,), "ars_linear", clipped)


def others():
    """Checkpoints of libraries that save with torch.save."""
    mean, deviation = torch.randn(1, 3), torch.rand(1, 3) + 0.5
    statistics = {"_mean": mean, "_var": deviation**2, "_std": deviation, "count": torch.tensor(100)}
    rest = {"optimizer_state_dict": {"state": {0: {"step": torch.tensor(1.0)}}, "param_groups": [{"lr": 1e-3}]},
            "iter": 5, "infos": None}

    def normalized(model, epsilon, clip=None):
        wrapped = copy.deepcopy(model)
        call = wrapped.call

        def with_statistics(m, x):
            x = (x - m.mean) / (m.deviation + epsilon)
            return call(m, x if clip is None else x.clamp(-clip, clip))
        wrapped.call = with_statistics
        wrapped.register_buffer("mean", mean)
        wrapped.register_buffer("deviation", deviation)
        return wrapped

    model = Actor(lambda m, x: m.actor(x), actor=mlp(3, 8, 6, 2, activation=nn.ELU, head=True),
                  critic=mlp(3, 5, 1, head=True), std=torch.ones(2))
    torch.save({"model_state_dict": model.state_dict(), "obs_norm_state_dict": statistics, **rest}, OUT / "rsl_rl.pt")
    golden(normalized(model, 0.01), (3,), "rsl_rl")
    newer = {**model.state_dict(), **{f"actor_obs_normalizer.{key}": value for key, value in statistics.items()}}
    torch.save({"model_state_dict": newer, **rest}, OUT / "rsl_rl_3.pt")

    model = Actor(lambda m, x: m.a2c_network.mu(m.a2c_network.actor_mlp(x)),
                  a2c_network__actor_mlp=mlp(3, 8, 6, activation=nn.ELU), a2c_network__mu=nn.Linear(6, 2),
                  a2c_network__value=nn.Linear(6, 1), a2c_network__sigma=torch.zeros(2))
    wrapped = copy.deepcopy(model)
    wrapped.call = lambda m, x: model_call(m, ((x - mean.to(x)) / torch.sqrt(deviation.to(x)**2 + 1e-5)).clamp(-5, 5))
    model_call = model.call
    tensors = {**model.state_dict(), "running_mean_std.running_mean": mean[0].double(),
               "running_mean_std.running_var": deviation[0].double()**2, "running_mean_std.count": torch.tensor(9.0),
               "value_mean_std.running_mean": torch.zeros(1), "value_mean_std.running_var": torch.ones(1)}
    torch.save({"model": tensors, "epoch": 5, "last_mean_rewards": np.float32(1.5), "env_state": None},
               OUT / "rl_games.pth")
    golden(wrapped, (3,), "rl_games")

    model = Actor(lambda m, x: m.policy_layer(m.net_container(x)), net_container=mlp(3, 8, 6, activation=nn.ELU),
                  policy_layer=nn.Linear(6, 2), log_std_parameter=torch.zeros(2))
    torch.save({"policy": model.state_dict(), "value": model.state_dict(), "optimizer": rest["optimizer_state_dict"],
                "state_preprocessor": {"running_mean": mean[0].double(), "running_variance": deviation[0].double()**2,
                                       "current_count": torch.tensor(9.0)}}, OUT / "skrl.pt")
    golden(normalized(model, 1e-8, 5.0), (3,), "skrl")

    model = Actor(lambda m, x: torch.tanh(m.fc_mu(torch.relu(m.fc2(torch.relu(m.fc1(x)))))),
                  fc1=nn.Linear(3, 8), fc2=nn.Linear(8, 6), fc_mu=nn.Linear(6, 2))
    model.register_buffer("action_scale", torch.tensor((HIGH - LOW) / 2).float())
    model.register_buffer("action_bias", torch.tensor((HIGH + LOW) / 2).float())
    torch.save((model.state_dict(), mlp(5, 4, 1).state_dict()), OUT / "cleanrl_td3.pth")
    golden(model, (3,), "cleanrl_td3", unscaled)


def main():
    torch.manual_seed(11)
    OUT.mkdir(exist_ok=True)
    stable_baselines()
    others()


if __name__ == "__main__":
    main()

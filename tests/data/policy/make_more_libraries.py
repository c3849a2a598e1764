#!/usr/bin/python3
"""Writes more policies of libraries/ and their golden rows, with Debian's python3-torch and python3-onnx:
    cd tests/data/policy && ./make_more_libraries.py
Choices as observations of Stable-Baselines3, rl_games' discrete heads, AMP and old checkpoints, Sample Factory,
safe-control-gym, and ONNX with its values in a second file. Names of tensors and dictionaries are those of the
libraries, weights are random. Golden rows are torch's answers in float32 and float64.
"""
import copy
import random

import numpy as np
import onnx
import torch
from torch import nn

import make_stable_baselines as make
from make_stable_baselines import Actor, COMMON, Flat, OUT, box, dictionary, discrete, mlp, ppo, save_zip

CHOICES = {"multi_discrete": "MultiDiscrete", "multi_binary": "MultiBinary"}


def space(module, **values):
    """A stand-in that pickles as gymnasium's."""
    import sys
    import types
    folder = "gymnasium.spaces"
    sys.modules.setdefault(f"{folder}.{module}", types.ModuleType(module))
    made = type(CHOICES[module], (), {"__module__": f"{folder}.{module}"})
    setattr(sys.modules[f"{folder}.{module}"], CHOICES[module], made)
    result = made()
    result.__dict__.update(values)
    return result


def one_hot(sizes):
    """As preprocess_obs: each number with its own number of entries; 0 leaves it unchanged."""
    def call(x):
        parts = []
        for i, size in enumerate(sizes):
            one = x[:, i:i + 1]
            parts.append(nn.functional.one_hot(one[:, 0].long(), size).to(x.dtype) if size else one)
        return torch.cat(parts, 1)
    return call


def golden(model, draw, name, action=None, rows=24):
    exact = copy.deepcopy(model).double()
    columns = {"obs": [], "network_out": [], "network_out_f64": []}
    for _ in range(rows):
        x = np.asarray(draw(), np.float32)
        with torch.no_grad():
            columns["network_out"].append(model(torch.from_numpy(x)[None]).numpy().ravel())
            columns["network_out_f64"].append(exact(torch.from_numpy(x).double()[None]).numpy().ravel())
        columns["obs"].append(x)
        if action is not None:
            columns.setdefault("action", []).append(np.atleast_1d(action(columns["network_out_f64"][-1])))
    np.savez_compressed(OUT / f"{name}_golden.npz", **{key: np.array(value) for key, value in columns.items()})


def choices():
    action = box(make.LOW, make.HIGH, (2,))
    rng = np.random.default_rng(3)

    def draw(sizes):
        return lambda: [rng.integers(0, n) if n else rng.normal(0, 2) for n in sizes]

    def of(sizes, inputs, outputs=2):
        model = ppo(Flat(), inputs, outputs)
        inner, convert = model.call, one_hot(sizes)
        model.call = lambda m, x: inner(m, convert(x))
        return model

    keywords = {"net_arch": [6]}
    model = of([5], 5)
    save_zip("ppo_discrete_obs", model, COMMON, discrete(5), action, {"n_epochs": 10}, keywords)
    golden(model, draw([5]), "ppo_discrete_obs", make.clipped)

    nvec = space("multi_discrete", nvec=np.array([3, 4]), start=np.array([0, 0]), dtype=np.dtype(np.int64), _shape=(2,))
    model = of([3, 4], 7, 3)
    save_zip("ppo_multi_discrete_obs", model, COMMON, nvec, discrete(3), {"n_epochs": 10}, keywords)
    golden(model, draw([3, 4]), "ppo_multi_discrete_obs", np.argmax)

    bits = space("multi_binary", n=4, _shape=(4,), dtype=np.dtype(np.int8))
    model = ppo(Flat(), 4, 2)
    save_zip("ppo_multi_binary_obs", model, COMMON, bits, action, {"n_epochs": 10}, keywords)
    golden(model, lambda: rng.integers(0, 2, 4), "ppo_multi_binary_obs", make.clipped)

    model = of([0, 0, 3, 0], 6)
    parts = dictionary(angle=box(-4.0, 4.0, (2,)), gear=discrete(3), speed=box(-9, 9, (1,)))
    save_zip("ppo_dict_obs", model, COMMON, parts, action, {"n_epochs": 10}, keywords)
    golden(model, draw([0, 0, 3, 0]), "ppo_dict_obs", make.clipped)


def normalized(model, mean, variance, epsilon, clip):
    wrapped = copy.deepcopy(model)
    call = wrapped.call
    wrapped.register_buffer("mean", mean)
    wrapped.register_buffer("variance", variance)
    wrapped.call = lambda m, x: call(
        m, ((x - m.mean.to(x)) / torch.sqrt(m.variance.to(x) + epsilon)).clamp(-clip, clip))
    return wrapped


def vectors(count):
    rng = np.random.default_rng(4)
    return lambda: rng.normal(0, 2, count)


def rl_games():
    mean, variance = torch.randn(3, dtype=torch.float64), torch.rand(3, dtype=torch.float64) + 0.5
    statistics = {"running_mean": mean, "running_var": variance, "count": torch.tensor(9.0, dtype=torch.float64)}
    model = Actor(lambda m, x: m.a2c_network.logits(m.a2c_network.actor_mlp(x)),
                  a2c_network__actor_mlp=mlp(3, 8, 6, activation=nn.ELU), a2c_network__logits=nn.Linear(6, 4),
                  a2c_network__value=nn.Linear(6, 1))
    inside = {**model.state_dict(), **{f"running_mean_std.{key}": value for key, value in statistics.items()}}
    torch.save({"model": inside, "epoch": 5}, OUT / "rl_games_discrete.pth")
    golden(normalized(model, mean, variance, 1e-5, 5.0), vectors(3), "rl_games_discrete", np.argmax)

    model = Actor(lambda m, x: m.a2c_network.mu(m.a2c_network.actor_mlp(x)),
                  a2c_network__actor_mlp=mlp(3, 8, 6, activation=nn.ReLU), a2c_network__mu=nn.Linear(6, 2),
                  a2c_network__value=nn.Linear(6, 1), a2c_network__sigma=torch.zeros(2),
                  a2c_network__critic_mlp=mlp(3, 8, 6), a2c_network___disc_mlp=mlp(10, 7),
                  a2c_network___disc_logits=nn.Linear(7, 1))
    # Before rl_games 1.2 the statistics lie next to the model; AMP has some of the discriminator's too.
    torch.save({"model": model.state_dict(), "running_mean_std": statistics, "epoch": 5,
                "reward_mean_std": {"running_mean": torch.zeros(1), "running_var": torch.ones(1)},
                "amp_input_mean_std": {"running_mean": torch.zeros(10), "running_var": torch.ones(10)}},
               OUT / "rl_games_amp.pth")
    golden(normalized(model, mean, variance, 1e-5, 5.0), vectors(3), "rl_games_amp")


def sample_factory():
    mean, variance = torch.randn(3, dtype=torch.float64), torch.rand(3, dtype=torch.float64) + 0.5
    for name, actor, critic in (("sample_factory", "", ""), ("sample_factory_separate", "actor_", "critic_")):
        modules = {f"{actor}encoder__encoders__obs__mlp_head": mlp(3, 8, 6, activation=nn.ELU),
                   f"{actor}decoder__mlp": mlp(6, 5, activation=nn.ELU), "critic_linear": nn.Linear(5, 1),
                   "action_parameterization__distribution_linear": nn.Linear(5, 2),
                   "action_parameterization__learned_stddev": torch.zeros(2)}
        if critic:
            modules[f"{critic}encoder__encoders__obs__mlp_head"] = mlp(3, 8, 6, activation=nn.ELU)
            modules[f"{critic}decoder__mlp"] = mlp(6, 5, activation=nn.ELU)

        def call(m, x, actor=actor):
            y = getattr(m, f"{actor}encoder").encoders.obs.mlp_head(x)
            return m.action_parameterization.distribution_linear(getattr(m, f"{actor}decoder").mlp(y))
        model = Actor(call, **modules)
        prefix = "obs_normalizer.running_mean_std.running_mean_std.obs."
        tensors = {**model.state_dict(), f"{prefix}running_mean": mean, f"{prefix}running_var": variance,
                   f"{prefix}count": torch.ones(1, dtype=torch.float64),
                   "returns_normalizer.running_mean": torch.zeros(1),
                   "returns_normalizer.running_var": torch.ones(1), "returns_normalizer.count": torch.ones(1)}
        torch.save({"train_step": 10, "env_steps": 1000, "best_performance": 1.5, "model": tensors,
                    "optimizer": {"state": {}, "param_groups": []}, "curr_lr": 1e-4}, OUT / f"{name}.pth")
        golden(normalized(model, mean, variance, 1e-5, 5.0), vectors(3), name)


def safe_control_gym():
    generator = np.random.default_rng(9)
    mean, variance = generator.normal(0, 1, 3), generator.random(3) + 0.5

    class Layers(nn.Module):
        def __init__(self, *sizes):
            super().__init__()
            self.fcs = nn.ModuleList([nn.Linear(a, b) for a, b in zip(sizes, sizes[1:])])

        def forward(self, x):
            for layer in self.fcs[:-1]:
                x = torch.tanh(layer(x))
            return self.fcs[-1](x)

    model = Actor(lambda m, x: m.actor.pi_net(x), actor__pi_net=Layers(3, 8, 6, 2), actor__logstd=torch.zeros(2),
                  critic__v_net=Layers(3, 8, 1))
    optimizer = torch.optim.Adam(model.parameters()).state_dict()
    torch.save({"agent": {"ac": model.state_dict(), "actor_opt": optimizer, "critic_opt": optimizer},
                "obs_normalizer": {"mean": mean, "var": variance},
                "reward_normalizer": {"mean": np.zeros(()), "var": np.ones(())},
                "total_steps": 100, "obs": generator.normal(0, 1, (4, 3)),
                "random_state": {"random": random.Random(1).getstate(), "np": np.random.RandomState(1).get_state(),
                                 "torch": torch.get_rng_state()}}, OUT / "safe_control_gym.pt")
    golden(normalized(model, torch.from_numpy(mean), torch.from_numpy(variance), 1e-8, 10.0), vectors(3),
           "safe_control_gym")


def external_onnx():
    folder = OUT.parent / "architectures"
    model = onnx.load(str(folder / "scaled.onnx"))
    (folder / "external.onnx.data").unlink(missing_ok=True)
    onnx.save(model, str(folder / "external.onnx"), save_as_external_data=True, all_tensors_to_one_file=True,
              location="external.onnx.data", size_threshold=64)


if __name__ == "__main__":
    torch.manual_seed(12)
    choices()
    rl_games()
    sample_factory()
    safe_control_gym()
    external_onnx()

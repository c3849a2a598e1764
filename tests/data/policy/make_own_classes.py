#!/usr/bin/python3
"""Writes libraries/ppo_own_policy.zip, libraries/ppo_normalized.zip and their golden rows, with Debian's python3-torch:
    cd tests/data/policy && ./make_own_classes.py
ppo_own_policy: a policy class of the user's own, as in Stable-Baselines3's guide ("Custom Policy Network", advanced example): the tensors
have MlpPolicy's names, but relu is between them. `data` has what save_util.data_to_json() writes of such a class.
ppo_some_normalized.pkl: VecNormalize of a part of ppo_dict_obs.zip (norm_obs_keys), which make_more_libraries.py writes.
ppo_normalized: PPO whose actions were from -1 to 1 in training, with answers beyond that.
"""
import io
import json
import pickle
import sys
import types
import zipfile

import numpy as np
import torch
from torch import nn

import make_stable_baselines as make
from make_stable_baselines import COMMON, Flat, OUT, box, golden, ppo, save_zip

CLIP, EPSILON = 1.5, 1e-8


def stand_in(module, name, **values):
    """An object that pickles as module.name."""
    for i in range(1, module.count(".") + 2):
        part = ".".join(module.split(".")[:i])
        sys.modules.setdefault(part, types.ModuleType(part))
    if not hasattr(sys.modules[module], name):
        setattr(sys.modules[module], name, type(name, (), {"__module__": module}))
    made = getattr(sys.modules[module], name)()
    made.__dict__.update(values)
    return made


def some_normalized():
    """angle is normalised and clipped; gear, a choice, and speed, beyond the clip, are not."""
    mean, variance = np.array([0.5, -1.0]), np.array([0.8, 2.5])
    rms = stand_in("stable_baselines3.common.running_mean_std", "RunningMeanStd", mean=mean, var=variance, count=100.0)
    statistics = stand_in("stable_baselines3.common.vec_env.vec_normalize", "VecNormalize", norm_obs=True, norm_obs_keys=["angle"],
                          obs_rms={"angle": rms}, clip_obs=CLIP, epsilon=EPSILON, training=False, gamma=0.99)
    (OUT / "ppo_some_normalized.pkl").write_bytes(pickle.dumps(statistics, 4))
    with zipfile.ZipFile(OUT / "ppo_dict_obs.zip") as file:
        weights = {name: value.double() for name, value in torch.load(io.BytesIO(file.read("policy.pth"))).items()}
    rng = np.random.default_rng(7)
    columns = {"obs": [], "network_out": [], "network_out_f64": []}
    for _ in range(24):
        x = np.array([*rng.normal(0, 2, 2), rng.integers(0, 3), rng.normal(0, 9)], np.float32)
        angle = np.clip((x[:2] - mean) / np.sqrt(variance + EPSILON), -CLIP, CLIP).astype(np.float32)
        row = torch.tensor(np.concatenate([angle, np.eye(3, dtype=np.float32)[int(x[2])], x[3:]])).double()
        hidden = torch.tanh(weights["mlp_extractor.policy_net.0.weight"] @ row + weights["mlp_extractor.policy_net.0.bias"])
        y = (weights["action_net.weight"] @ hidden + weights["action_net.bias"]).numpy()
        columns["obs"].append(x)
        columns["network_out"].append(y.astype(np.float32))
        columns["network_out_f64"].append(y)
    np.savez_compressed(OUT / "ppo_some_normalized_golden.npz", **{key: np.array(value) for key, value in columns.items()})


def main():
    torch.manual_seed(23)
    model = ppo(Flat(), 3, 2, net=(8,), activation=nn.ReLU)
    save_zip("ppo_own_policy", model, COMMON, box(-3.0, 3.0, (3,)), box(make.LOW, make.HIGH, (2,)), {"n_epochs": 10})
    path = OUT / "ppo_own_policy.zip"
    with zipfile.ZipFile(path) as file:
        entries = {name: file.read(name) for name in file.namelist()}
    data = json.loads(entries["data"])
    name = "CustomActorCriticPolicy"
    data["policy_class"] = {
        ":type:": "<class 'abc.ABCMeta'>", "__module__": "__main__", "__doc__": None,
        "__init__": f"<function {name}.__init__ at 0x7f3a5c0d1870>",
        "_build_mlp_extractor": f"<function {name}._build_mlp_extractor at 0x7f3a5c0d1900>",
        "__abstractmethods__": "frozenset()", "_abc_impl": "<_abc._abc_data object at 0x7f3a5c0e2c40>"}
    entries["data"] = json.dumps(data).encode()
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as file:
        for entry, content in entries.items():
            file.writestr(zipfile.ZipInfo(entry), content, zipfile.ZIP_DEFLATED)
    golden(model, (3,), "ppo_own_policy", make.clipped)

    model = ppo(Flat(), 3, 2)
    with torch.no_grad():
        model.action_net.weight *= 4
    save_zip("ppo_normalized", model, COMMON, box(-3.0, 3.0, (3,)), box(-1.0, 1.0, (2,)), {"n_epochs": 10}, {"net_arch": [6]})
    golden(model, (3,), "ppo_normalized", lambda y: np.clip(y, -1.0, 1.0))

    some_normalized()


if __name__ == "__main__":
    main()

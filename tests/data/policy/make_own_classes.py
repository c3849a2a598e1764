#!/usr/bin/python3
"""Writes libraries/ppo_own_policy.zip and its golden rows, with Debian's python3-torch:
    cd tests/data/policy && /usr/bin/python3 make_own_classes.py
A policy class of the user's own, as in Stable-Baselines3's guide ("Custom Policy Network", advanced example): the tensors
have MlpPolicy's names, but relu is between them. `data` has what save_util.data_to_json() writes of such a class.
"""
import json
import zipfile

import torch
from torch import nn

import make_stable_baselines as make
from make_stable_baselines import COMMON, Flat, OUT, box, golden, ppo, save_zip


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


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Trains on the graph with Stable-Baselines3, and runs the saved policy on an emulated Cortex-M4F.

    ./train_with_sb3.py [--algorithm PPO|SAC] [--steps N] [--seed S] [--output FOLDER]

Needs eagerx-gen (on PATH, or the variable EAGERX_GEN), its Python package, stable-baselines3 with torch and, for the
board, the packages of `toolchains/install-packages boards`. Writes into FOLDER (default: trained): policy.zip,
vecnormalize.pkl, golden.csv, graph.yaml. Exit code 1: the policy does not swing up, or the board's trace differs.
"""
import argparse
import os
import pathlib
import re
import subprocess
import sys

import numpy as np
import stable_baselines3
from stable_baselines3.common.vec_env import VecNormalize

import eagerx_gen

GRAPH = pathlib.Path(__file__).resolve().parent / "graph.yaml"
EPISODES = 20


def make_model(algorithm, envs, seed):
    if algorithm == "SAC":
        # As many updates as steps of all environments.
        return stable_baselines3.SAC("MlpPolicy", envs, learning_rate=1e-3, gradient_steps=-1, train_freq=1, learning_starts=2000,
                                     policy_kwargs={"net_arch": [64, 64]}, seed=seed, device="cpu")
    return stable_baselines3.PPO("MlpPolicy", envs, n_steps=32, batch_size=512, n_epochs=10, learning_rate=1e-3, gae_lambda=0.95,
                                 gamma=0.99, policy_kwargs={"net_arch": [64, 64]}, seed=seed, device="cpu")


def train(algorithm, steps, seed, folder):
    # SAC learns from few steps, PPO from many at once.
    # SAC stores rewards, whose scale must not change afterwards.
    envs = VecNormalize(eagerx_gen.make_vec_env(GRAPH, n_envs=4 if algorithm == "SAC" else 256), norm_reward=algorithm != "SAC")
    model = make_model(algorithm, envs, seed)
    envs.seed(seed)
    model.learn(steps)
    model.save(folder / "policy.zip")
    envs.save(folder / "vecnormalize.pkl")
    return model, envs


def write_golden(model, envs, folder):
    """Known answers: observations of the environment, and the model's actions."""
    envs.training = False
    envs.reset()
    raw = []
    for _ in range(8):
        envs.step(np.array([envs.action_space.sample() for _ in range(envs.num_envs)]))
        raw.append(envs.get_original_obs()[:4])
    raw = np.concatenate(raw)
    action, _ = model.predict(envs.normalize_obs(raw), deterministic=True)
    names = [f"obs{i}" for i in range(raw.shape[1])] + [f"action{i}" for i in range(action.shape[1])]
    np.savetxt(folder / "golden.csv", np.hstack([raw, action]), delimiter=",", header=",".join(names), comments="", fmt="%.9g")


def write_graph(folder):
    agent = ("agent: {policy: policy.zip, normalize: vecnormalize.pkl, golden: golden.csv,\n"
             "  observations: [angle, theta_dot]} # columns are in the order of their names\n")
    text = re.sub(r"^agent: .*\n", agent, GRAPH.read_text(), flags=re.M)
    (folder / "graph.yaml").write_text(re.sub(r"^# yaml-language-server.*\n", "", text))


def run(folder, *arguments):
    program = os.environ.get("EAGERX_GEN", "eagerx-gen")
    command = [program, "run", str(folder / "graph.yaml"), *arguments]
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"`{' '.join(command)}` failed with exit code {done.returncode}\n{done.stdout}")
    return done.stdout


def line(text, name):
    return next(line.removeprefix(name).strip() for line in text.splitlines() if line.startswith(name))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--algorithm", choices=["PPO", "SAC"], default="PPO")
    parser.add_argument("--steps", type=int, help="of training (default: PPO 400000, SAC 30000)")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("trained"))
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    steps = options.steps or {"PPO": 400_000, "SAC": 30_000}[options.algorithm]
    model, envs = train(options.algorithm, steps, options.seed, options.output)
    write_golden(model, envs, options.output)
    write_graph(options.output)
    linux = run(options.output, "--seed", "1000", "--episodes", str(EPISODES), "--summary")
    print(f"{options.algorithm}, {model.num_timesteps} steps, seed {options.seed}")
    print("return:", line(linux, "return:"))
    print("success:", line(linux, "success:"))
    few = ("--seed", "1000", "--episodes", "2")
    hashes = [line(run(options.output, *few, "--hash"), "trace hash"),
              line(run(options.output, "--target", "mps2-an386", *few), "trace hash")]
    print("trace hash of two episodes, Linux and mps2-an386:", *hashes)
    good = int(line(linux, "success:").split()[0]) >= EPISODES * 9 // 10
    return 0 if good and hashes[0] == hashes[1] else 1


if __name__ == "__main__":
    sys.exit(main())

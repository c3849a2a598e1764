#!/usr/bin/env python3
"""Stable-Baselines3's SAC goes on learning on hardware, from the policy that pendulum_swing_up ships.

    ./fine_tune.py [PROGRAM] [--episodes N] [--seed S] [--output FOLDER]

PROGRAM is a program of graph.yaml that is built already, such as build/examples/pendulum_fine_tuning.hardware.emulated on
the emulated adapter; without it graph.yaml is built, and drives the adapter that is plugged in. Needs eagerx-gen (on PATH,
or the variable EAGERX_GEN), its Python package, stable-baselines3 with torch, and onnx. Writes into FOLDER (default:
fine_tuned): policy.zip, curve.csv, curve.svg. Exit code 1: the policy has not become better.
"""
import argparse
import copy
import pathlib
import sys

import gymnasium
import numpy as np
import onnx.numpy_helper
import stable_baselines3
import torch
from stable_baselines3.common.callbacks import BaseCallback

import eagerx_gen

HERE = pathlib.Path(__file__).resolve().parent
SHIPPED = HERE.parent / "pendulum_swing_up/swing_up.onnx"
TRIED = 10  # episodes without noise, before and after
WARM_UP = 8  # episodes from which the critics learn alone
ENOUGH = 8  # successes in ten episodes end the training


class BeginWhenTold(gymnasium.Wrapper):
    """An episode on hardware begins when somebody is there for it.

    Stable-Baselines3 resets as soon as an episode has ended, and then learns for seconds, in which the robot would go on.
    Such a reset does nothing here, and the robot stands still with its safe action until begin().
    """

    observation = None
    late = 0

    def begin(self):
        self.observation, _ = self.env.reset()
        self.late, self.reward = 0, 0.0
        return self.observation

    def reset(self, **keywords):
        return (self.begin() if self.observation is None else self.observation), {}

    def step(self, action):
        self.observation, reward, terminated, truncated, info = self.env.step(action)
        self.late += info["late"]
        self.reward += reward
        return self.observation, reward, terminated, truncated, info


class Episodes(BaseCallback):
    """Begins each episode, keeps what came of it, and which policy was the best: of five episodes together."""

    def __init__(self, robot):
        super().__init__()
        self.robot, self.rows, self.best, self.best_return = robot, [], None, -np.inf

    def _on_rollout_start(self):
        self.model._last_obs = self.robot.begin()[None]

    def _on_step(self):
        if self.locals["dones"][0]:
            self.rows.append((self.robot.reward, self.locals["infos"][0]["success"], self.robot.late))
            last_five = np.mean([row[0] for row in self.rows[-5:]])
            if len(self.rows) > WARM_UP + 5 and last_five > self.best_return:
                self.best_return, self.best = last_five, copy.deepcopy(self.model.policy.state_dict())
            print(f"episode {len(self.rows)}: return {self.robot.reward:.1f}, {'a success' if self.rows[-1][1] else 'no success'}", flush=True)
        return sum(row[1] for row in self.rows[-10:]) < ENOUGH


def take_weights(policy):
    """The shipped actor, which is one of Stable-Baselines3's SAC, 3-64-64-1."""
    tensors = {each.name: onnx.numpy_helper.to_array(each) for each in onnx.load(SHIPPED).graph.initializer}
    own = policy.actor.state_dict()
    names = {"latent_pi.0": "a.latent_pi.0", "latent_pi.2": "a.latent_pi.2", "mu": "a.mu", "log_std": "a.log_std"}
    for ours, theirs in names.items():
        for part in ("weight", "bias"):
            own[f"{ours}.{part}"] = torch.as_tensor(np.array(tensors[f"{theirs}.{part}"]))
    policy.actor.load_state_dict(own)


def tried(model, robot):
    """[TRIED] returns without noise, and how many episodes succeeded."""
    returns, successes = [], 0
    for _ in range(TRIED):
        observation, ended = robot.begin(), False
        while not ended:
            action, _ = model.predict(observation, deterministic=True)
            observation, _, terminated, truncated, info = robot.step(action)
            ended = terminated or truncated
        returns.append(robot.reward)
        successes += info["success"]
    return np.array(returns), successes


def write_curve(rows, folder):
    header = "episode,return,success,late_steps"
    table = [[k, *row] for k, row in enumerate(rows, 1)]
    np.savetxt(folder / "curve.csv", table, delimiter=",", header=header, comments="", fmt=["%d", "%.3f", "%d", "%d"])
    width, height, left, bottom, top = 640, 320, 60, 280, 20
    returns = np.array([row[0] for row in rows])
    low, high = min(returns.min(), -1.0) * 1.05, 0.0
    x = left + (width - left - 20) * np.arange(len(rows)) / max(len(rows) - 1, 1)
    y = lambda value: top + (bottom - top) * (high - value) / (high - low)
    smooth = [returns[max(0, k - 4):k + 5].mean() for k in range(len(returns))]
    line = lambda values: " ".join(f"{a:.1f},{y(b):.1f}" for a, b in zip(x, values))
    ticks = [t for t in np.linspace(low, high, 5)]
    (folder / "curve.svg").write_text("\n".join([
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="12">',
        f'<rect width="{width}" height="{height}" fill="white"/>',
        *[f'<path d="M{left} {y(t):.1f}H{width - 20}" stroke="#ddd"/><text x="{left - 6}" y="{y(t) + 4:.1f}" text-anchor="end">{t:.0f}</text>'
          for t in ticks],
        *[f'<circle cx="{a:.1f}" cy="{y(b):.1f}" r="2" fill="#9bb8d3"/>' for a, b in zip(x, returns)],
        f'<polyline points="{line(smooth)}" fill="none" stroke="#1f5a92" stroke-width="2"/>',
        f'<text x="{left}" y="{bottom + 24}">return of an episode on the hardware, 1 to {len(rows)}; line: mean of nine</text>', "</svg>", ""]))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", nargs="?", default=HERE / "graph.yaml")
    parser.add_argument("--episodes", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("fine_tuned"))
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    torch.set_num_threads(1)
    robot = BeginWhenTold(eagerx_gen.make(options.program, flatten=True, normalize_actions=True, real_time_factor=1))
    robot.env.reset(seed=options.seed)
    # Updates between episodes only; none of the actor before the critics know something.
    model = stable_baselines3.SAC("MlpPolicy", robot, learning_rate=3e-4, train_freq=(1, "episode"), gradient_steps=300, learning_starts=0,
                                  ent_coef=0.02, policy_kwargs={"net_arch": [64, 64]}, seed=options.seed, device="cpu")
    take_weights(model.policy)
    before, good_before = tried(model, robot)
    print(f"before: mean return {before.mean():.1f}, {good_before} of {TRIED} episodes succeed", flush=True)
    episodes = Episodes(robot)
    for phase, count in (("critics", WARM_UP), ("all", options.episodes - WARM_UP)):
        model.actor.requires_grad_(phase == "all")
        model.learn(300 * count, callback=episodes, reset_num_timesteps=False)
    if episodes.best is not None:
        model.policy.load_state_dict(episodes.best)
    after, good_after = tried(model, robot)
    print(f"after:  mean return {after.mean():.1f}, {good_after} of {TRIED} episodes succeed; "
          f"{len(episodes.rows)} episodes, {sum(row[2] for row in episodes.rows)} late steps", flush=True)
    model.save(options.output / "policy.zip")
    write_curve(episodes.rows, options.output)
    robot.close()
    return 0 if after.mean() > before.mean() else 1


if __name__ == "__main__":
    sys.exit(main())

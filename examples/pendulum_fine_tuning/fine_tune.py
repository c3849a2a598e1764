#!/usr/bin/env python3
"""Stable-Baselines3's PPO continues to learn on hardware, from the policy of policy_from_stable_baselines.

    ./fine_tune.py [PROGRAM] [--episodes N] [--seed S] [--output FOLDER]

PROGRAM is a built program of graph.yaml, such as build/examples/pendulum_fine_tuning.hardware.emulated on
the emulated adapter; the default is to build graph.yaml and drive the connected adapter. Needs eagerx-gen (on PATH,
or the variable EAGERX_GEN), its Python package, and stable-baselines3 with torch. Writes into FOLDER (default: fine_tuned):
fine_tuned.zip, fine_tuned.yaml (for this folder), curve.csv, curve.svg. Exit code 1: success is not more frequent.
"""
import argparse
import io
import pathlib
import sys
import zipfile

import gymnasium
import numpy as np
import stable_baselines3
import torch
from stable_baselines3.common.callbacks import BaseCallback
from stable_baselines3.common.vec_env import DummyVecEnv, VecNormalize

import eagerx_gen

HERE = pathlib.Path(__file__).resolve().parent
SHIPPED = HERE.parent / "policy_from_stable_baselines"
STEPS = 300  # of an episode: 10 s
ROLLOUT = 4  # episodes before the policy changes
TRIED = 20  # episodes without noise, before and after


class BeginWhenTold(gymnasium.Wrapper):
    """Begins an episode on hardware only when the agent is ready.

    Stable-Baselines3 resets as soon as an episode ends, and learns after the last one of a rollout, while the robot
    would continue. Such a reset does nothing here, and the robot stands still with its safe action until begin().
    """

    def __init__(self, env):
        super().__init__(env)
        self.observation, self.left = None, 0

    def begin(self, left=0):
        """`left`: steps until the agent pauses."""
        self.left = left or self.left
        self.observation, _ = self.env.reset()
        self.total, self.late = 0.0, 0
        return self.observation

    def reset(self, **keywords):
        return (self.observation if self.left == 0 and self.observation is not None else self.begin()), {}

    def step(self, action):
        self.left -= 1
        self.observation, reward, terminated, truncated, info = self.env.step(action)
        self.total += reward
        self.late += info["late"]
        if terminated or truncated:
            info["whole"] = (self.total, info["success"], self.late)
        return self.observation, reward, terminated, truncated, info


class Episodes(BaseCallback):
    """Begins each rollout, and keeps the results of its episodes."""

    def __init__(self, robot, envs):
        super().__init__()
        self.robot, self.envs, self.rows = robot, envs, []

    def _on_rollout_start(self):
        self.model._last_obs = self.envs.normalize_obs(self.robot.begin(self.model.n_steps)[None])

    def _on_step(self):
        self.rows += [info["whole"] for info in self.locals["infos"] if "whole" in info]
        return True


def tried(model, robot, envs):
    """[TRIED] returns without noise, and the number of successful episodes."""
    returns, successes, robot.left = [], 0, 0
    for _ in range(TRIED):
        observation, ended = robot.begin(), False
        while not ended:
            action, _ = model.predict(envs.normalize_obs(observation), deterministic=True)
            observation, _, terminated, truncated, info = robot.step(action)
            ended = terminated or truncated
        returns.append(robot.total)
        successes += info["success"]
    return np.array(returns), successes


def save(model, folder):
    """The policy without its optimizer, and the graph with it."""
    model.save(folder / "whole.zip")
    with zipfile.ZipFile(folder / "whole.zip") as whole, zipfile.ZipFile(folder / "fine_tuned.zip", "w", zipfile.ZIP_DEFLATED) as kept:
        for name in ("data", "policy.pth", "_stable_baselines3_version"):
            kept.writestr(zipfile.ZipInfo(name), whole.read(name), zipfile.ZIP_DEFLATED)
    (folder / "whole.zip").unlink()
    (folder / "fine_tuned.yaml").write_text((HERE / "fine_tuned.yaml").read_text())


def write_curve(rows, folder):
    header = "episode,return,success,late_steps"
    table = [[k, *row] for k, row in enumerate(rows, 1)]
    np.savetxt(folder / "curve.csv", table, delimiter=",", header=header, comments="", fmt=["%d", "%.3f", "%d", "%d"])
    width, height, left, bottom, top = 640, 320, 60, 280, 20
    returns = np.array([row[0] for row in rows])
    low, high = np.floor(returns.min() / 500) * 500, 0.0
    x = left + (width - left - 20) * np.arange(len(rows)) / max(len(rows) - 1, 1)
    y = lambda value: top + (bottom - top) * (high - value) / (high - low)
    smooth = [returns[max(0, k - 4):k + 5].mean() for k in range(len(returns))]
    line = lambda values: " ".join(f"{a:.1f},{y(b):.1f}" for a, b in zip(x, values))
    ticks = np.arange(low, high + 1, 500)
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
    parser.add_argument("--episodes", type=int, default=160)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--output", type=pathlib.Path, default=pathlib.Path("fine_tuned"))
    options = parser.parse_args()
    options.output.mkdir(parents=True, exist_ok=True)
    torch.set_num_threads(1)
    robot = BeginWhenTold(eagerx_gen.make(options.program, flatten=True, real_time_factor=1))
    robot.env.reset(seed=options.seed)
    envs = VecNormalize.load(str(SHIPPED / "vecnormalize.pkl"), DummyVecEnv([lambda: robot]))
    envs.training = False  # the statistics are those that the policy was trained with
    model = stable_baselines3.PPO("MlpPolicy", envs, gamma=0.95, learning_rate=1e-4, n_steps=ROLLOUT * STEPS, batch_size=100, n_epochs=10,
                                  clip_range=0.1, policy_kwargs={"net_arch": [64, 64]}, seed=options.seed, device="cpu")
    with zipfile.ZipFile(SHIPPED / "swing_up.zip") as archive:
        model.policy.load_state_dict(torch.load(io.BytesIO(archive.read("policy.pth")), map_location="cpu"))
    before, good_before = tried(model, robot, envs)
    print(f"before: mean return {before.mean():.1f}, {good_before} of {TRIED} episodes succeed", flush=True)
    episodes = Episodes(robot, envs)
    model.learn(options.episodes * STEPS, callback=episodes)
    after, good_after = tried(model, robot, envs)
    print(f"after:  mean return {after.mean():.1f}, {good_after} of {TRIED} episodes succeed; "
          f"{len(episodes.rows)} episodes, {sum(row[2] for row in episodes.rows)} late steps", flush=True)
    save(model, options.output)
    write_curve(episodes.rows, options.output)
    robot.close()
    return 0 if good_after > good_before else 1


if __name__ == "__main__":
    sys.exit(main())

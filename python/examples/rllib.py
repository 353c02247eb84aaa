"""Ray RLlib's PPO: cameras that turn and zoom by rates, and share one policy.

    python rllib.py mate-4v8-9 --updates 30

Needs `pip install 'ray[tune]' torch dm-tree lz4 ormsgpack`; `ray[rllib]` asks for an older Gymnasium.
"""

from __future__ import annotations

import argparse
import os

os.environ.setdefault("OMP_NUM_THREADS", "1")  # the world and the network take turns
os.environ.setdefault("RAY_AUTH_MODE", "disabled")  # or it leaves a token in the home folder

import ray
from ray.rllib.algorithms.ppo import PPOConfig
from ray.rllib.env.wrappers.pettingzoo_env import ParallelPettingZooEnv
from ray.tune import register_env

import hificamsim


def train(scenario: str, updates: int, seed: int = 0) -> list[float]:
    """The mean share of the targets that cameras covered in an episode of each update."""
    ray.init(num_cpus=1, include_dashboard=False, log_to_driver=False)
    settings = {"actions": "rates", "reward": "coverage", "steps": 100}
    register_env(scenario, lambda config: ParallelPettingZooEnv(hificamsim.parallel_env(scenario, **settings)))
    config = (
        PPOConfig()
        .environment(scenario)
        .env_runners(num_env_runners=0)
        .training(train_batch_size=1_000, minibatch_size=250, num_epochs=4, lr=1e-3, gamma=0.9)
        .multi_agent(policies={"cameras"}, policy_mapping_fn=lambda agent, episode, **kwargs: "cameras")
        .debugging(seed=seed, log_level="ERROR")
    )
    algorithm = config.build_algo()
    scores = []
    for _ in range(updates):
        episodes = algorithm.train()["env_runners"]
        returns = episodes["agent_episode_returns_mean"]
        scores.append(sum(returns.values()) / len(returns) / settings["steps"])
        print(f"update {len(scores)}: {scores[-1]:.3f} of the targets covered", flush=True)
    algorithm.stop()
    ray.shutdown()
    return scores


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenario", nargs="?", default="mate-4v8-9")
    parser.add_argument("--updates", type=int, default=30)
    parser.add_argument("--seed", type=int, default=0)
    asked = parser.parse_args()
    train(asked.scenario, asked.updates, asked.seed)


if __name__ == "__main__":
    main()

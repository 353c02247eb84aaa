"""What brings torch: `gradle :python:torchTest`, beside ./test."""

from __future__ import annotations

import pytest

import hificamsim

pytest.importorskip("torch")


def test_stable_baselines_checks_the_environment_and_learns() -> None:
    stable_baselines3 = pytest.importorskip("stable_baselines3")
    from stable_baselines3.common.env_checker import check_env

    single = hificamsim.single_env("campus", steps=50)
    check_env(single)
    single.close()
    env = hificamsim.sb3_vec_env("campus", 2, steps=50, reward="difference")
    model = stable_baselines3.PPO("MlpPolicy", env, n_steps=32, seed=1)
    model.learn(1_000)
    assert model.num_timesteps >= 1_000
    env.close()


def test_torchrl_checks_the_environment() -> None:
    pytest.importorskip("torchrl")
    from torchrl.envs.utils import check_env_specs

    env = hificamsim.torchrl_env("campus", steps=50)
    check_env_specs(env)
    assert env.rollout(20).shape[0] == 20
    env.close()


def test_benchmarl_has_a_task() -> None:
    pytest.importorskip("benchmarl")
    task = hificamsim.benchmarl_task("campus", steps=50)
    env = task.get_env_fun(1, False, 1, "cpu")()
    assert task.max_steps(env) == 50
    assert list(task.group_map(env)) == ["cameras"]
    env.close()

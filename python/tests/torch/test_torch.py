"""What brings torch: `gradle :python:torchTest`, beside ./test."""

from __future__ import annotations

import pathlib

import numpy as np
import pytest

import hificamsim

torch = pytest.importorskip("torch", reason="no torch, 6 GB from PyPI: gradle :python:torchTest fetches it and runs these")
torch.set_num_threads(1)


@pytest.mark.parametrize("actions", ["view", "rates"])
def test_stable_baselines_checks_environment_and_learns(actions: str, tmp_path: pathlib.Path) -> None:
    stable_baselines3 = pytest.importorskip("stable_baselines3")
    from stable_baselines3.common.env_checker import check_env

    single = hificamsim.single_env("mate-4v8-9", steps=50, actions=actions)
    check_env(single)
    single.close()
    env = hificamsim.sb3_vec_env("campus", 2, steps=50, reward="difference", actions=actions)
    model = stable_baselines3.PPO("MlpPolicy", env, n_steps=32, seed=1)
    model.learn(1_000)
    assert model.num_timesteps >= 1_000
    model.save(tmp_path / "model")
    read = stable_baselines3.PPO.load(tmp_path / "model", env=env)
    observations = env.reset()
    assert (read.predict(observations, deterministic=True)[0] == model.predict(observations, deterministic=True)[0]).all()
    env.close()


def test_maskable_ppo_obeys_masks() -> None:
    contributed = pytest.importorskip("sb3_contrib")
    env = hificamsim.sb3_vec_env("campus", 1, steps=50)
    model = contributed.MaskablePPO("MlpPolicy", env, n_steps=32, seed=1)
    model.learn(200)
    observations = env.reset()
    forbidden = 0
    for _ in range(30):
        masks = np.stack(env.env_method("action_masks"))
        actions, _ = model.predict(observations, action_masks=masks)
        assert masks[np.arange(env.num_envs), actions].all()
        forbidden += (~masks).sum()
        observations, *_ = env.step(actions)
    assert forbidden > 0
    env.close()


@pytest.mark.parametrize("actions", ["view", "steps", "rates"])
def test_torchrl_checks_environment(actions: str) -> None:
    pytest.importorskip("torchrl")
    from torchrl.envs.utils import check_env_specs

    env = hificamsim.torchrl_env("campus", steps=50, actions=actions)
    check_env_specs(env)
    assert env.rollout(20).shape[0] == 20
    env.close()


def test_torchrl_obeys_masks() -> None:
    pytest.importorskip("torchrl")
    env = hificamsim.torchrl_env("campus", steps=50)
    views = torch.tensor([env.worlds.views]).T
    rollout = env.rollout(40)["cameras"]
    masks, actions = rollout["action_mask"], rollout["action"]
    assert len(views.unique()) > 1, "cameras differ"
    assert (actions < views.T).all()
    assert not masks.all() and masks.gather(-1, actions.unsqueeze(-1)).all()
    env.close()


@pytest.mark.parametrize("algorithm", ["MappoConfig", "QmixConfig"])
def test_benchmarl_trains_on_its_task(algorithm: str, tmp_path: pathlib.Path) -> None:
    pytest.importorskip("benchmarl")
    from benchmarl import algorithms
    from benchmarl.experiment import Experiment, ExperimentConfig
    from benchmarl.models.mlp import MlpConfig

    config = ExperimentConfig.get_from_yaml()
    config.max_n_frames = 200
    config.on_policy_collected_frames_per_batch = config.off_policy_collected_frames_per_batch = 100
    config.on_policy_n_envs_per_worker = config.off_policy_n_envs_per_worker = 2
    config.on_policy_n_minibatch_iters = config.off_policy_n_optimizer_steps = 2
    config.on_policy_minibatch_size = config.off_policy_train_batch_size = 50
    config.evaluation_interval, config.evaluation_episodes = 200, 1
    config.loggers, config.create_json, config.save_folder = [], False, str(tmp_path)
    experiment = Experiment(
        task=hificamsim.benchmarl_task("campus", steps=50, reward="difference"),
        algorithm_config=getattr(algorithms, algorithm).get_from_yaml(),
        model_config=MlpConfig.get_from_yaml(),
        critic_model_config=MlpConfig.get_from_yaml(),
        seed=1,
        config=config,
    )
    experiment.run()
    assert experiment.total_frames == 200


def test_rllib_trains_cameras_that_turn_and_zoom_by_rates(monkeypatch: pytest.MonkeyPatch) -> None:
    ray = pytest.importorskip("ray")
    from ray.rllib.algorithms.ppo import PPOConfig
    from ray.rllib.env.wrappers.pettingzoo_env import ParallelPettingZooEnv
    from ray.tune import register_env

    monkeypatch.setenv("RAY_AUTH_MODE", "disabled")  # or it leaves a token in the home folder
    ray.init(num_cpus=1, include_dashboard=False, log_to_driver=False)
    settings = {"actions": "rates", "reward": "coverage", "steps": 100}
    register_env("mate", lambda config: ParallelPettingZooEnv(hificamsim.parallel_env("mate-4v8-9", **settings)))
    config = PPOConfig().environment("mate").env_runners(num_env_runners=0).debugging(seed=0, log_level="ERROR")
    config = config.training(train_batch_size=1_000, minibatch_size=250, num_epochs=4)
    config = config.multi_agent(policies={"cameras"}, policy_mapping_fn=lambda agent, episode, **kwargs: "cameras")
    algorithm = config.build_algo()
    for _ in range(2):
        returns = algorithm.train()["env_runners"]["agent_episode_returns_mean"]
    assert 0.2 < sum(returns.values()) / len(returns) / settings["steps"] < 0.8
    algorithm.stop()
    ray.shutdown()

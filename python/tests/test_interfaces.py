"""Runs the tests of PettingZoo and Gymnasium, and tests what they omit."""

from __future__ import annotations

import pathlib

import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from gymnasium.vector import AutoresetMode
from pettingzoo.test import api_test, max_cycles_test, parallel_api_test, parallel_seed_test, render_test, seed_test
from pettingzoo.test.state_test import state_test

import hificamsim

SCENARIOS = ["campus", "campus-heights", "mate-4v8-9", "cluster-random"]


@pytest.mark.parametrize("scenario", SCENARIOS)
@pytest.mark.parametrize("actions", ["view", "rates"])
def test_pettingzoo_parallel_api(scenario: str, actions: str, backend: str) -> None:
    env = hificamsim.parallel_env(scenario, steps=60, actions=actions, backend=backend)
    parallel_api_test(env, num_cycles=200)
    env.close()


@pytest.mark.parametrize("actions", ["view", "steps", "rates"])
def test_pettingzoo_parallel_seed(actions: str) -> None:
    parallel_seed_test(lambda: hificamsim.parallel_env("campus", steps=60, actions=actions))


@pytest.mark.parametrize("actions", ["view", "rates"])
def test_pettingzoo_turn_by_turn(actions: str) -> None:
    env = hificamsim.env("mate-4v8-9", steps=30, actions=actions)
    api_test(env, num_cycles=300)
    seed_test(lambda: hificamsim.env("mate-4v8-9", steps=30, actions=actions), num_cycles=50)
    env.close()


def test_pettingzoo_equal_action_spaces() -> None:
    plain = hificamsim.parallel_env("campus", steps=30)
    env = hificamsim.parallel_env("campus", steps=30, equal_spaces=True)
    assert len({space.n for space in plain.action_spaces.values()}) > 1
    assert {space.n for space in env.action_spaces.values()} == {max(env.worlds.views)}
    _, infos = env.reset(seed=1)
    for camera, views in zip(env.agents, env.worlds.views):
        mask = infos[camera]["action_mask"]
        assert len(mask) == max(env.worlds.views) and not mask[views:].any()
    env.step(dict.fromkeys(env.agents, max(env.worlds.views) - 1))
    parallel_api_test(env, num_cycles=60)
    plain.close()
    env.close()


def test_pettingzoo_max_cycles() -> None:
    class Module:
        """A module as max_cycles_test expects it."""

        @staticmethod
        def parallel_env(max_cycles: int) -> hificamsim.CameraEnv:
            return hificamsim.parallel_env("mate-4v8-9", steps=max_cycles)

        @staticmethod
        def env(max_cycles: int) -> object:
            return hificamsim.env("mate-4v8-9", steps=max_cycles)

    max_cycles_test(Module)


def test_pettingzoo_state() -> None:
    parallel = hificamsim.parallel_env("campus", steps=30)
    parallel.reset(seed=1)
    state_test(hificamsim.env("campus", steps=30), parallel)
    parallel.close()


def test_pettingzoo_render() -> None:
    render_test(lambda render_mode=None: hificamsim.env("cluster-random", steps=30, render_mode=render_mode))


def test_rates_turn_cameras_by_any_amount_and_are_reported(tmp_path: pathlib.Path) -> None:
    env = hificamsim.make("mate-4v8-9-v1", actions="rates", steps=40)
    _, infos = env.reset(seed=1)
    assert env.action_space("north-east") == gymnasium.spaces.Box(-1, 1, (2,), np.float32)
    assert "action_mask" not in infos["north-east"]
    index = next(i for i, feature in enumerate(env.worlds.features) if feature["name"] == "goal_pan")
    for _ in range(40):
        observations, *_ = env.step({camera: [0.5, 0] for camera in env.agents})
    assert observations["north-east"][index] == np.float32(100 / 180)  # half of five degrees a step
    assert env.report(tmp_path).exists()
    env.close()


@pytest.mark.filterwarnings("ignore:.*")
@pytest.mark.parametrize("scenario", SCENARIOS)
@pytest.mark.parametrize("actions", ["view", "rates"])
def test_gymnasium_check_env(scenario: str, actions: str, backend: str) -> None:
    env = hificamsim.single_env(scenario, steps=30, actions=actions, backend=backend)
    check_env(env, skip_render_check=True)
    env.close()


def test_gymnasium_makes_registered_environments() -> None:
    hificamsim.register()
    hificamsim.register()
    env = gymnasium.make("hificamsim/campus-v1", steps=30)
    env.reset(seed=1)
    env.step(env.action_space.sample())
    env.close()
    many = gymnasium.make_vec(
        "hificamsim/campus-v1", num_envs=3, vectorization_mode="vector_entry_point", steps=30
    )
    assert many.reset(seed=1)[0].shape[0] == 3
    many.close()


def test_make_knows_every_scenario() -> None:
    env = hificamsim.make("campus-v1", steps=5)
    assert env.worlds.name == "campus"
    env.close()
    with pytest.raises(hificamsim.InputError, match="id is 'campsu-v0', expected one of .*campus-v1"):
        hificamsim.make("campsu-v0")


@pytest.mark.parametrize("per", ["world", "camera"])
def test_vector_environment_declares_and_performs_autoreset(per: str, backend: str) -> None:
    envs = hificamsim.vector_env("campus", 3, per=per, steps=40, seed=2, backend=backend)
    assert envs.metadata["autoreset_mode"] == AutoresetMode.SAME_STEP
    observations, infos = envs.reset()
    envs.action_space.seed(1)
    for step in range(1, 121):
        assert observations in envs.observation_space
        observations, rewards, terminations, truncations, infos = envs.step(envs.action_space.sample())
        assert rewards.shape == truncations.shape == (envs.num_envs,)
        assert not terminations.any()
        assert truncations.all() == truncations.any() == (step % 40 == 0)
        assert ("final_obs" in infos) == (step % 40 == 0)
        if step % 40 == 0:
            assert infos["final_obs"][0] in envs.single_observation_space
            assert (infos["final_obs"][0] != observations[0]).any()
    envs.close()


def test_worlds_of_vector_environment_have_different_seeds() -> None:
    envs = hificamsim.vector_env("campus", 3, seed=5)
    alone = hificamsim.vector_env("campus", 1, seed=7)
    action = envs.action_space.sample()
    envs.reset()
    alone.reset()
    for _ in range(30):
        together = envs.step(action)[0]
        single = alone.step(action[2:])[0]
    assert (together[2] == single[0]).all()
    assert (together[0] != together[2]).any()
    envs.close()
    alone.close()


def test_results_of_a_step_do_not_change_later() -> None:
    envs = hificamsim.vector_env("campus", 2)
    first, _ = envs.reset(seed=1)
    kept = first.copy()
    for _ in range(20):
        envs.step(envs.action_space.sample())
    assert (first == kept).all()
    envs.close()


@pytest.mark.parametrize(
    ("scenario", "actions", "detect"),
    [("campus", "view", None), ("mate-4v8-9", "steps", None), ("junction", "view", "chance"), ("cluster-random", "steps", None)],
)
def test_every_number_is_within_its_bounds(scenario: str, actions: str, detect: str | None) -> None:
    """Plays 3,000 steps of random actions, half of which the masks forbid."""
    steps = 3000
    detection = "hifi:orb-lin" if detect else None  # chance needs a model with the scatter of its fit
    with hificamsim.Worlds(
        scenario, 2, actions=actions, detection=detection, detect=detect, steps=700, reward="difference"
    ) as worlds:
        low, high = worlds.bounds()
        least, most = np.full(low.size, np.inf), np.full(low.size, -np.inf)
        random = np.random.default_rng(3)
        for _ in range(steps):
            worlds.actions[...] = random.integers(0, worlds.choices, size=worlds.actions.shape)
            worlds.step()
            seen = worlds.observations.reshape(-1, low.size)
            assert ((seen >= low) & (seen <= high)).all()
            assert ((worlds.finals >= low) & (worlds.finals <= high)).all()
            assert (np.abs(worlds.state()) <= 1).all()
            assert ((worlds.rewards >= 0) & (worlds.rewards <= 1)).all()
            assert (worlds.masks.max(axis=2) == 1).all(), "some choice is always allowed"
            least, most = np.minimum(least, seen.min(axis=0)), np.maximum(most, seen.max(axis=0))
        assert (most > least).sum() >= 14, "many numbers change"


def test_failed_camera_stays_agent_and_sees_nothing() -> None:
    env = hificamsim.parallel_env("campus", steps=200, seed=0)
    env.reset()
    for step in range(190):
        observations, rewards, _, _, _ = env.step(dict.fromkeys(env.agents, 0))
        assert (observations["hall"] == 0).all() == (step + 1 >= 180)
    assert "hall" in env.agents
    env.close()


def test_renders_picture_and_page_of_episode(backend: str, tmp_path: object) -> None:
    env = hificamsim.make("campus-v1", render_mode="rgb_array", width=400, steps=50, backend=backend)
    env.reset(seed=4)
    before = env.render()
    covered = []
    for _ in range(20):
        _, _, _, _, infos = env.step({agent: env.action_space(agent).sample() for agent in env.agents})
        covered.append(infos["hall"]["k_min"])
    after = env.render()
    assert before.shape[1:] == (400, 3) and before.dtype == np.uint8
    assert (before != after).any()
    page = env.report(f"{tmp_path}/episode")
    assert "<html" in page.read_text(encoding="utf-8")
    steps = hificamsim.read_results(page.parent)["steps"]
    assert steps["k_min"].tolist() == covered
    env.close()

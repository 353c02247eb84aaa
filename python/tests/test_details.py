"""Tests the details of each camera: the targets that it saw and added, and the bits that it sent."""

from __future__ import annotations

import contextlib

import numpy as np
import pytest

import hificamsim

SETTINGS = {"steps": 30, "reward": "difference", "details": True}


def test_cameras_add_targets_that_no_other_camera_detects() -> None:
    with hificamsim.Worlds("campus", 2, seed=3, **SETTINGS) as worlds:
        worlds.begin(None)
        found = 0.0
        for _ in range(29):
            worlds.actions[...] = 0
            worlds.step()
            seen, added, sent = np.moveaxis(worlds.details, -1, 0)
            present = added.sum() / max(worlds.rewards.sum(), 1e-9) if added.any() else 1
            assert ((0 <= added) & (added <= seen) & (seen <= worlds.num_targets)).all() and not sent.any()
            assert (added.any(axis=1) == worlds.rewards.any(axis=1)).all() and 1 <= present <= worlds.num_targets
            found += added.sum()
    assert found > 0


def test_cameras_that_share_a_belief_send_bits() -> None:
    with hificamsim.Worlds("campus", belief=True, **SETTINGS) as worlds:
        worlds.begin(None)
        bits = np.zeros(len(worlds.cameras))
        for _ in range(29):
            worlds.actions[...] = 0
            worlds.step()
            bits += worlds.details[0, :, 2]
    assert (bits > 0).all()


@pytest.mark.parametrize("per", ["world", "camera"])
def test_infos_have_details_of_each_camera(per: str) -> None:
    with contextlib.closing(hificamsim.vector_env("campus", 2, per=per, seed=3, **SETTINGS)) as envs:
        envs.reset(seed=3)
        *_, infos = envs.step(np.zeros_like(envs.action_space.sample()))
        cameras = len(envs.worlds.cameras)
        assert infos["seen"].shape == ((2, cameras) if per == "world" else (2 * cameras,))
        assert (infos["seen"].reshape(2, cameras) == envs.worlds.details[..., 0]).all()
    with contextlib.closing(hificamsim.parallel_env("campus", **SETTINGS)) as env:
        env.reset(seed=3)
        *_, camera_infos = env.step(dict.fromkeys(env.agents, 0))
        assert [camera_infos[camera]["seen"] for camera in env.agents] == infos["seen"].reshape(2, cameras)[0].tolist()


def test_single_environment_has_details_of_its_cameras() -> None:
    env = hificamsim.single_env("campus", details=True)
    env.reset(seed=1)
    info = env.step(env.action_space.sample() * 0)[-1]
    for i, name in enumerate(("seen", "added", "sent")):
        assert (info[name] == env.worlds.details[0, :, i]).all()
    env.close()


def test_infos_have_no_details_unless_asked() -> None:
    with contextlib.closing(hificamsim.parallel_env("campus", steps=30)) as env:
        _, infos = env.reset(seed=3)
        assert not {"seen", "added", "sent"} & infos[env.possible_agents[0]].keys()
        assert not env.worlds.details.any()

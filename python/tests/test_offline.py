"""Tests writing and reading decisions of an expert as Minari datasets."""

from __future__ import annotations

import pathlib

import numpy as np
import pytest

import hificamsim

minari = pytest.importorskip("minari")

SETTINGS = {"steps": 40, "seed": 7}


@pytest.fixture(autouse=True)
def _kept_in(tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("MINARI_DATASETS_PATH", str(tmp_path))


@pytest.mark.parametrize("data_format", ["hdf5", "arrow"])
def test_minari_returns_decisions_as_written(data_format: str) -> None:
    decisions = hificamsim.dataset("junction", episodes=2, idle=True, **SETTINGS)
    hificamsim.to_minari(decisions, "cameras/junction-v0", data_format=data_format)
    read = hificamsim.from_minari("cameras/junction-v0")
    assert read.keys() == decisions.keys()
    for name, array in decisions.items():
        assert read[name].dtype == array.dtype and (read[name] == array).all(), name


def test_minari_has_an_episode_for_each_camera() -> None:
    decisions = hificamsim.dataset("junction", episodes=2, idle=True, **SETTINGS)
    kept = hificamsim.to_minari(decisions, "junction-v0", description="by cooperative cameras")
    cameras = decisions["camera"].max() + 1
    assert (kept.total_episodes, kept.total_steps) == (2 * cameras, 80 * cameras)
    for episode in kept.iterate_episodes():
        assert episode.observations.shape[0] == 41 and episode.truncations.tolist() == [False] * 39 + [True]
        assert not episode.terminations.any()
        assert all(kept.observation_space.contains(observation) for observation in episode.observations)
        assert episode.infos["action_mask"][np.arange(40), episode.actions].all()


def test_idle_adds_rows_to_decisions() -> None:
    chosen = hificamsim.dataset("junction", **SETTINGS)
    whole = hificamsim.dataset("junction", idle=True, **SETTINGS)
    kept = {(step, camera): i for i, (step, camera) in enumerate(zip(whole["step"], whole["camera"]))}
    rows = [kept[key] for key in zip(chosen["step"], chosen["camera"])]
    assert len(kept) == 40 * (whole["camera"].max() + 1) > len(rows)
    assert all((chosen[name] == whole[name][rows]).all() for name in chosen)


def test_rejects_decisions_that_lack_steps() -> None:
    with pytest.raises(hificamsim.InputError, match="lack steps"):
        hificamsim.to_minari(hificamsim.dataset("junction", **SETTINGS), "junction-v0")


def test_rejects_foreign_datasets() -> None:
    from gymnasium.spaces import Discrete
    from minari.data_collector import EpisodeBuffer

    episode = EpisodeBuffer(observations=[0, 1], actions=[0], rewards=[0.0], terminations=[False], truncations=[True])
    other = minari.create_dataset_from_buffers(
        "other-v0", [episode], observation_space=Discrete(2), action_space=Discrete(2)
    )
    with pytest.raises(hificamsim.InputError, match="has no action_mask"):
        hificamsim.from_minari(other)

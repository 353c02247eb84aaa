"""Tests experts, and the data of their decisions."""

from __future__ import annotations

import numpy as np
import pytest

import hificamsim

SETTINGS = {"steps": 60, "seed": 7}


def test_expert_plays_like_a_run_of_its_policy() -> None:
    with hificamsim.Worlds("junction", 2, expert="cooperative", auto_reset=False, **SETTINGS) as worlds:
        worlds.begin(None)
        worlds.actions[...] = -1
        scores = np.zeros(2)
        for _ in range(60):
            worlds.step()
            scores += worlds.measures[:, 2]
    played = hificamsim.run("junction", policy="cooperative", repeat=2, **SETTINGS)
    assert np.allclose(scores, played["steps"].groupby("run")["score"].sum(), rtol=1e-5)


def test_dataset_has_only_decisions_allowed_by_masks() -> None:
    pairs = hificamsim.dataset("junction", episodes=2, **SETTINGS)
    count = len(pairs["actions"])
    assert {len(array) for array in pairs.values()} == {count} and count > 100
    assert pairs["masks"][np.arange(count), pairs["actions"]].all()
    first = hificamsim.dataset("junction", **SETTINGS)
    mine = pairs["episode"] == 0
    assert (pairs["observations"][mine] == first["observations"]).all()
    assert (pairs["actions"][mine] == first["actions"]).all()


def test_dataset_has_consequences_of_decisions() -> None:
    pairs = hificamsim.dataset("junction", **SETTINGS)
    step, camera = pairs["step"], pairs["camera"]
    assert (pairs["ends"] == (step == 59)).all()
    assert ((pairs["rewards"] >= 0) & (pairs["rewards"] <= 1)).all() and pairs["rewards"].any()
    rows = {key: i for i, key in enumerate(zip(step, camera))}
    compared = 0
    for (when, camera), i in rows.items():
        after = rows.get((when + 1, camera))
        if after is not None:
            assert (pairs["next_observations"][i] == pairs["observations"][after]).all()
            assert (pairs["next_masks"][i] == pairs["masks"][after]).all()
            compared += 1
    assert compared > 50


def test_expert_advises_other_players() -> None:
    with hificamsim.Worlds("junction", expert="zoom-in", **SETTINGS) as worlds:
        worlds.actions[...] = worlds.choices[0] - 1
        worlds.step()
        assert (worlds.advice >= 0).all()


def test_rejects_following_advice_without_expert() -> None:
    with hificamsim.Worlds("junction", **SETTINGS) as worlds:
        worlds.actions[...] = -1
        with pytest.raises(hificamsim.InputError, match="action -1 of camera"):
            worlds.step()


@pytest.mark.parametrize("name", ["best-fixed", "nobody"])
def test_rejects_experts_that_need_whole_run(name: str) -> None:
    with pytest.raises(hificamsim.InputError, match=f"'{name}'"):
        hificamsim.Worlds("junction", expert=name)

"""Tests tasks, and entries of policies in Python."""

from __future__ import annotations

import importlib.util
import json
import pathlib
import sys
from types import SimpleNamespace

import gymnasium
import numpy as np
import pytest
from gymnasium.vector import AutoresetMode

import hificamsim

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "examples"))


def test_every_task_can_be_made_and_played(backend: str) -> None:
    assert len(hificamsim.tasks()) == 12
    for task in hificamsim.tasks():
        env = hificamsim.make(task, backend=backend)
        env.reset(seed=7)
        env.step({camera: 0 for camera in env.agents})
        env.close()


def test_every_site_has_current_and_old_id() -> None:
    for name in hificamsim.scenarios():
        assert name + "-v1" in hificamsim.ids()
    env = hificamsim.make("corridor-v0", steps=2)
    assert env.worlds.name == "corridor"
    env.close()
    hificamsim.register()
    for id in ("bench/campus-v1", "hificamsim/corridor-v1", "hificamsim/corridor-v0"):
        single = gymnasium.make(id)
        single.reset(seed=1)
        single.close()


def test_site_of_a_task_depends_only_on_seed() -> None:
    with hificamsim.Worlds("bench/campus-v1", 3, seed=5) as many, hificamsim.Worlds("bench/campus-v1", 1, seed=6) as one:
        many.reset(5)
        one.reset(6)
        assert (many.observations[1] == one.observations[0]).all()
        assert (many.observations[1][:, 1:5] != many.observations[0][:, 1:5]).any()
        first = one.observations.copy()
        for _ in range(one.episode_steps):
            one.step()
        assert (one.observations[0][:, 1:5] != first[0][:, 1:5]).any()  # the next episode is elsewhere


def test_task_keeps_its_settings() -> None:
    with pytest.raises(hificamsim.InputError, match="with steps=, expected the seed alone"):
        hificamsim.make("bench/campus-v1", steps=5)
    with pytest.raises(hificamsim.InputError, match="is no file"):
        hificamsim.Worlds("bench/moon-v1")


def test_short_policy_enters_benchmark_and_page(tmp_path: pathlib.Path) -> None:
    import enter

    scores = hificamsim.benchmark(enter.Stay(), tmp_path / "mine", name="<stay>", only=["passage-v1", "bench/street-v1"])
    entry = json.loads((tmp_path / "mine" / "entry.json").read_text())
    assert entry["name"] == "<stay>" and entry["policy"] == "played"
    assert np.allclose(scores["bench/street-v1"], entry["tasks"]["street-v1"]["scores"], atol=1e-6)
    assert scores["bench/street-v1"].mean() > 0.1
    assert "2 tasks, agrees" in hificamsim.execute("benchmark", "check", str(tmp_path / "mine"))
    hificamsim.execute("benchmark", "leaderboard", str(tmp_path / "mine"), "--out", str(tmp_path / "board"))
    assert r"\u003cstay>" in (tmp_path / "board" / "leaderboard.html").read_text()
    with pytest.raises(hificamsim.InputError, match="task is 'bench/moon-v1', expected one of bench/lattice-v1"):
        hificamsim.benchmark(enter.Stay(), tmp_path / "no", name="no", only=["moon-v1"])


@pytest.mark.parametrize("per", ["world", "camera"])
def test_each_world_takes_its_seed(per: str, backend: str) -> None:
    envs = hificamsim.vector_env("bench/campus-v1", 3, per=per, backend=backend)
    each = envs.num_envs // 3
    first, _ = envs.reset(seed=[9 for _ in range(each)] + [4] * each + [9] * each)
    parts = np.split(first, 3)
    assert (parts[0] == parts[2]).all() and (parts[0] != parts[1]).any()
    alone = hificamsim.vector_env("bench/campus-v1", 1, per=per, backend=backend)
    assert (alone.reset(seed=4)[0] == parts[1]).all()
    with pytest.raises(hificamsim.InputError, match=f"expected {envs.num_envs} values"):
        envs.reset(seed=[1])
    envs.close()
    alone.close()


def test_next_episode_begins_in_following_step(backend: str) -> None:
    envs = hificamsim.vector_env("campus", 2, steps=5, autoreset_mode=AutoresetMode.NEXT_STEP, backend=backend)
    same = hificamsim.vector_env("campus", 2, steps=5, backend=backend)
    assert envs.metadata["autoreset_mode"] == AutoresetMode.NEXT_STEP
    envs.reset(seed=3)
    same.reset(seed=3)
    actions = np.zeros(envs.action_space.shape, int)
    for step in range(1, 13):
        now = envs.step(actions)
        assert now[3].all() == now[3].any() == (step in (5, 11))
        if step == 6:
            assert not now[1].any() and (now[0] == began).all()  # noqa: F821
            continue
        other = same.step(actions)
        if step == 5:
            began = other[0]
            assert (now[0][0] == other[4]["final_obs"][0]).all()
        elif step < 11:
            assert (now[0] == other[0]).all()
    envs.close()
    same.close()


def test_rejects_seeds_that_are_not_numbers() -> None:
    envs = hificamsim.vector_env("campus", 2, steps=3)
    for wrong in (np.array("a"), np.zeros((2, 2), object), "ab", [1, "b"]):
        with pytest.raises(hificamsim.InputError, match="seed|expected"):
            envs.reset(seed=wrong)
    envs.close()


def test_reset_mask_selects_worlds_without_autoreset(backend: str) -> None:
    envs = hificamsim.vector_env("campus", 2, steps=3, autoreset_mode="Disabled", backend=backend)
    envs.reset(seed=3)
    actions = np.zeros(envs.action_space.shape, int)
    for _ in range(3):
        last, _, _, truncations, _ = envs.step(actions)
    assert truncations.all()
    with pytest.raises(hificamsim.NoEpisode, match="episode of 3 steps is over"):
        envs.step(actions)
    first, _ = envs.reset(options={"reset_mask": np.array([True, False])})
    assert (first[1] == last[1]).all() and (first[0] != last[0]).any()
    envs.close()
    with pytest.raises(hificamsim.InputError, match="autoreset_mode is 'never', expected one of"):
        hificamsim.vector_env("campus", autoreset_mode="never")


def test_rate_policy_enters_benchmark(tmp_path: pathlib.Path) -> None:
    random = np.random.default_rng(1)

    def drift(observations: np.ndarray, masks: np.ndarray) -> np.ndarray:
        return random.uniform(-1, 1, (len(observations), 2))

    hificamsim.benchmark(drift, tmp_path / "entry", name="drift", only=["mate-4v8-9-v1"], actions="rates")
    assert "drift, 1 task, agrees" in hificamsim.execute("benchmark", "check", str(tmp_path / "entry"))


class Clip:
    """A stand-in for the class of MoviePy, which needs a program under the GPL: saves the frames as an array."""

    def __init__(self, frames: list[np.ndarray], fps: float) -> None:
        self.frames, self.fps = np.stack(frames), fps

    def write_videofile(self, path: str, logger: object) -> None:
        np.save(path, self.frames)


def test_films_vector_environments(tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    envs = hificamsim.vector_env("bench/campus-v1", 2, render_mode="rgb_array")
    envs.reset(seed=1)
    frames = envs.render()
    assert frames is not None and len(frames) == envs.num_envs
    assert frames[0].shape == frames[1].shape and frames[0].dtype == np.uint8
    assert (frames[0] != frames[1]).any()  # each its own site
    real = importlib.util.find_spec("moviepy") is not None
    if not real:
        for name in ("moviepy", "moviepy.video", "moviepy.video.io", "moviepy.video.io.ImageSequenceClip"):
            monkeypatch.setitem(sys.modules, name, SimpleNamespace(ImageSequenceClip=Clip, __path__=[]))  # type: ignore[arg-type]
    from gymnasium.wrappers.vector import RecordVideo

    film = RecordVideo(envs, str(tmp_path), video_length=4)
    film.reset(seed=1)
    for _ in range(6):
        film.step(np.zeros(envs.action_space.shape, int))
    film.close()
    made = list(tmp_path.glob("*.mp4*"))
    assert len(made) == 1
    if not real:
        filmed = np.load(made[0])
        assert filmed.shape[0] == 5 and filmed.shape[3] == 3 and filmed.dtype == np.uint8
        assert (filmed[0] != filmed[3]).any()

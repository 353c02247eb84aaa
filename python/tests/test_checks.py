"""Tests that values and actions are checked before a step, and that errors name the value and what is allowed."""

from __future__ import annotations

import contextlib
import pathlib
import re
from types import SimpleNamespace
from typing import Any

import gymnasium
import numpy as np
import pytest

import hificamsim
from hificamsim import errors, spaces
from hificamsim.worlds import rendered, scenario_file

COUNTS = np.array([[3, 5], [2, 9]], np.uint64)
LAST = [[2, 4], [1, 8]]


def checked(actions: Any) -> Any:
    return spaces.checked(actions, COUNTS, lambda index: f"camera {index[0]}{index[1]}")


@pytest.mark.parametrize("actions", [[[0, 0], [0, 0]], LAST, tuple(map(tuple, LAST))])
def test_accepts_whole_numbers_below_count_of_any_type(actions: Any) -> None:
    assert (checked(actions) == np.array(actions)).all()
    for kind in "bBhHiIlLqQ":
        assert (checked(np.array(actions, kind)) == np.array(actions)).all()


NO_ACTIONS = [-1, -128, 2**31, 2**63, 2**64, -(2**64), 1.0, 0.5, float("nan"), "1", "a\nb", None, True, np.True_, b"1", (), {}]


@pytest.mark.parametrize("index", [(0, 0), (0, 1), (1, 0), (1, 1)])
@pytest.mark.parametrize("value", [*NO_ACTIONS, "count"])
def test_error_names_invalid_action(index: tuple[int, int], value: Any) -> None:
    count = int(COUNTS[index])
    value = count if value == "count" else value
    actions = np.array(LAST, object)
    actions[index] = value
    text = value if isinstance(value, (int, float)) else errors.shown(value)
    line = f"action {text} of camera {index[0]}{index[1]}, expected a whole number from 0 to {count - 1}"
    with pytest.raises(ValueError, match=f"^{re.escape(line)}$"):
        checked(actions)


@pytest.mark.parametrize("kind", "bBhHiIlLqQ")
def test_error_names_invalid_action_in_integer_array(kind: str) -> None:
    for index, count in np.ndenumerate(COUNTS):
        for value in (-1, int(count)):
            actions = np.array(LAST, kind)
            actions[index] = np.array(value).astype(kind)
            with pytest.raises(hificamsim.InputError, match=f"^action -?[0-9]+ of camera {index[0]}{index[1]}, expected"):
                checked(actions)


@pytest.mark.parametrize(
    ("actions", "line"),
    [
        (np.array(LAST, object), "actions are of type object, expected whole numbers"),
        (LAST[0], "actions have shape (2,), expected (2, 2)"),
        (np.zeros((2, 3), int), "actions have shape (2, 3), expected (2, 2)"),
        ([[0], [0, 1]], "actions have shape (0,), expected (2, 2)"),
        (None, "actions have shape (), expected (2, 2)"),
        (np.array(LAST, float), "action 2.0 of camera 00, expected a whole number from 0 to 2"),
        (np.ones((2, 2), bool), "action True of camera 00, expected a whole number from 0 to 2"),
    ],
)
def test_rejects_values_that_are_not_integer_arrays(actions: Any, line: str) -> None:
    with pytest.raises(hificamsim.InputError, match=f"^{re.escape(line)}$"):
        checked(actions)


def test_space_sizes_equal_choices_of_cameras() -> None:
    by_view: Any = SimpleNamespace(kind="view", choices=[5], views=[3, 5], cameras=["a", "b"])
    by_step: Any = SimpleNamespace(kind="steps", choices=[3, 2], views=[3, 5], cameras=["a", "b"])
    with_state: Any = SimpleNamespace(states=np.zeros((2, 7)))
    assert spaces.state(with_state) == gymnasium.spaces.Box(-1, 1, (7,), np.float32)
    assert spaces.action(by_view) == gymnasium.spaces.Discrete(5)
    assert spaces.action(by_view, 0) == gymnasium.spaces.Discrete(3)
    assert spaces.action(by_step, 0) == gymnasium.spaces.MultiDiscrete([3, 2])
    assert spaces.joint_action(by_view) == gymnasium.spaces.MultiDiscrete([3, 5])
    assert spaces.joint_action(by_step) == gymnasium.spaces.MultiDiscrete([3, 2, 3, 2])
    assert spaces.counts(spaces.action(by_view, 0)) == 3
    assert spaces.counts(spaces.joint_action(by_step)).tolist() == [3, 2, 3, 2]
    assert spaces.mask(by_view, 0, np.array([1, 0, 1, 0, 0])).tolist() == [1, 0, 1]
    by_parts: Any = SimpleNamespace(choices=[3, 2, 1])
    by_rate: Any = SimpleNamespace(kind="rates", cameras=["a", "b"])
    assert spaces.action(by_rate, 0) == gymnasium.spaces.Box(-1, 1, (2,), np.float32)
    assert spaces.joint_action(by_rate) == gymnasium.spaces.Box(-1, 1, (4,), np.float32)
    limits = spaces.counts(spaces.action(by_rate))
    assert spaces.checked([-1, 0.5], limits, str).tolist() == [0, 1500]
    assert spaces.checked(np.array([1, 0]), limits, str).dtype == np.int32
    assert spaces.checked(np.array([1, -1], np.int8), limits, str).tolist() == [2000, 0]
    with pytest.raises(ValueError, match="action -128 of .0,., expected a rate from -1 to 1"):
        spaces.checked(np.array([-128, 0], np.int8), limits, str)
    for wrong, said in ((1.5, "1.5"), (float("nan"), "nan"), (-2, "-2"), (True, "True"), ("x", "'x'")):
        with pytest.raises(ValueError, match=f"action {said} of .0,., expected a rate from -1 to 1"):
            spaces.checked([wrong, 0.5] if wrong is not True else np.array([True, 0.5], object), limits, str)
    with pytest.raises(ValueError, match="expected a rate|expected rates"):
        spaces.checked(np.array([True, False]), limits, str)
    parts = spaces.mask(by_parts, 0, np.array([1, 0, 1, 1, 0, 1]))
    assert [part.tolist() for part in parts] == [[1, 0, 1], [1, 0], [1]]


@pytest.mark.parametrize("per", ["world", "camera"])
@pytest.mark.parametrize("actions", ["view", "steps"])
def test_error_names_camera_and_world_of_wrong_action(per: str, actions: str) -> None:
    with contextlib.closing(hificamsim.vector_env("campus", 2, per=per, actions=actions, backend="jvm")) as envs:
        envs.reset(seed=1)
        cameras = envs.worlds.cameras
        for world in range(2):
            for number, camera in enumerate(cameras):
                for part in range(len(envs.worlds.choices)):
                    wrong = np.zeros((2, len(cameras), len(envs.worlds.choices)), int)
                    wrong[world, number, part] = 999
                    with pytest.raises(ValueError, match=f"action 999 of camera {camera} in world {world}, expected"):
                        envs.step(wrong.reshape(envs.action_space.shape))
    with contextlib.closing(hificamsim.single_env("campus", actions=actions, backend="jvm")) as env:
        env.reset(seed=1)
        assert env.action_space.shape is not None
        wrong = np.zeros(env.action_space.shape, int)
        wrong[-1] = 999
        with pytest.raises(ValueError, match=f"action 999 of camera {cameras[-1]}, expected"):
            env.step(wrong)


def test_shows_values_in_one_line_of_80_characters() -> None:
    assert errors.shown("a\n  b") == "'a\\n b'"
    assert errors.shown("x" * 78) == "'" + "x" * 78 + "'"
    assert errors.shown("x" * 79) == "'" + "x" * 79 + "..."


def test_long_message_keeps_both_ends() -> None:
    assert errors.line("a\n  b\t") == "a b"
    whole = "a" * 400 + "b" * 400
    assert errors.line(whole) == whole
    assert errors.line("a" * 400 + "c" + "b" * 400) == "a" * 400 + "..." + "b" * 400


def test_path_accepts_text_bytes_and_paths_without_nul() -> None:
    for path in ("a/b", b"a/b", pathlib.Path("a/b")):
        assert errors.path(path, "scenario") == "a/b"
    for wrong, expected in [(3, "a name or a file"), (None, "a name or a file"), ("a\0", "no NUL in it")]:
        with pytest.raises(hificamsim.InputError, match=f"^scenario is .*, expected {expected}$"):
            errors.path(wrong, "scenario")


@pytest.mark.parametrize("value", [-3, 0, 7, np.int8(7), np.uint64(7), np.array(7)])
def test_accepts_whole_numbers_within_limits(value: Any) -> None:
    taken = errors.whole(value, "n", -3, 7)
    assert taken == value
    assert type(taken) is int


@pytest.mark.parametrize("value", [-4, 8, 2**64, -(2**64), 1.0, "1", None, True, False, np.float32(1), [1], np.zeros(2, int)])
def test_rejects_other_values_and_names_limits(value: Any) -> None:
    with pytest.raises(hificamsim.InputError, match="^n is .*, expected a whole number from -3 to 7$"):
        errors.whole(value, "n", -3, 7)


def test_whole_numbers_have_64_bits() -> None:
    for most in (-(2**63), 2**63 - 1):
        assert errors.whole(most, "n") == most
    for beyond in (-(2**63) - 1, 2**63):
        with pytest.raises(hificamsim.InputError, match="from -9223372036854775808 to 9223372036854775807$"):
            errors.whole(beyond, "n")


def test_settings_are_numbers_texts_or_booleans() -> None:
    for value in (3, 0.5, "a", True, np.int16(3), np.float32(0.5), np.bool_(True), np.array(3)):
        taken = errors.plain(value, "x")
        assert taken == value
        assert type(taken) in (int, float, str, bool)
    for wrong in ([1], None, b"a", np.zeros(1), np.zeros((1, 1)), 1j):
        with pytest.raises(hificamsim.InputError, match="^x is .*, expected a finite number, a text, True or False$"):
            errors.plain(wrong, "x")


def test_ids_are_scenario_names_with_version() -> None:
    assert "campus-v1" in hificamsim.ids()
    assert len(hificamsim.ids()) == len(hificamsim.scenarios()) + len(hificamsim.tasks()) > 1
    for wrong in ("campus", "campus-v2", "", 3, "a\0-v0"):
        with pytest.raises(hificamsim.InputError, match="^id is .*, expected (one of .*campus-v1|a name or a file|no NUL)"):
            hificamsim.make(wrong)  # type: ignore[arg-type]
    with contextlib.closing(hificamsim.make("campus-v0", backend="jvm", steps=3)) as env:
        assert env.worlds.name == "campus"
        assert env.worlds.episode_steps == 3
    hificamsim.register()
    hificamsim.register()  # a second time does nothing
    with contextlib.closing(gymnasium.make("hificamsim/campus-v0", backend="jvm")) as single:
        assert single.unwrapped.worlds.name == "campus"  # type: ignore[attr-defined]


def test_scenario_file_takes_precedence_over_name(tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    shipped = scenario_file("campus")
    assert pathlib.Path(shipped).is_file()
    assert scenario_file(shipped.encode()) == shipped
    monkeypatch.chdir(tmp_path)
    pathlib.Path("campus").write_text("mine", encoding="utf-8")
    assert scenario_file("campus") == str(tmp_path / "campus")
    pathlib.Path("own.xml").write_text("mine", encoding="utf-8")
    monkeypatch.setenv("HIFICAMSIM_SCENARIOS", str(tmp_path))
    assert scenario_file("own") == str(tmp_path / "own.xml")
    with pytest.raises(hificamsim.InputError, match=r"^scenario 'ring' is no file, and none of .* package: own$"):
        scenario_file("ring")


def test_rejects_settings_that_environments_set_themselves() -> None:
    for name in ("paints", "num_envs"):
        with pytest.raises(hificamsim.InputError, match=f"^unknown setting '{name}': the environment has its own"):
            rendered("campus", None, ["rgb_array"], {name: 1}, num_envs=1)
    for mode in ("human", "", 3, ["rgb_array"]):
        with pytest.raises(hificamsim.InputError, match="^render_mode is .*, expected None or 'rgb_array'$"):
            rendered("campus", mode, ["rgb_array"], {}, num_envs=1)  # type: ignore[arg-type]
    for per in ("World", "", 3, None, ["world"]):
        with pytest.raises(hificamsim.InputError, match="^per is .*, expected 'world' or 'camera'$"):
            hificamsim.vector_env("campus", per=per)


@pytest.mark.parametrize("value", ["maybe", "no", 1, None, np.array([True])])
def test_rejects_what_is_neither_true_nor_false(value: Any) -> None:
    for name, open_with in (
        ("equal_spaces", lambda **given: hificamsim.parallel_env("campus", **given)),
        ("copy", lambda **given: hificamsim.vector_env("campus", **given)),
        ("testing", lambda **given: hificamsim.Worlds("campus", **given)),
        ("idle", lambda **given: hificamsim.dataset("campus", **given)),
        ("per_task", lambda **given: hificamsim.benchmark(len, "out", name="mine", **given)),
    ):
        with pytest.raises(hificamsim.InputError, match=f"^{name} is .*, expected True or False$"):
            open_with(**{name: value})
    with contextlib.closing(hificamsim.parallel_env("campus", equal_spaces=np.True_)) as env:
        assert env.possible_agents


def test_rejects_dataset_without_episodes() -> None:
    with pytest.raises(hificamsim.InputError, match="^episodes is 0, expected a whole number from 1 to"):
        hificamsim.dataset("campus", episodes=0)

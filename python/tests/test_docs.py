"""Tests that the programs of docs/python.md run, and that the page has everything public."""

from __future__ import annotations

import inspect
import pathlib
import re
from typing import Any

import pytest

import hificamsim

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "python.md"
FEWER = {"steps=500": "steps=50", "range(1000)": "range(20)", "repeat=10": "repeat=2"}


def test_every_snippet_runs(tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    snippets = re.findall(r"^```python\n(.*?)^```", PAGE.read_text(encoding="utf-8"), re.MULTILINE | re.DOTALL)
    assert len(snippets) == 3
    text = "\n".join(snippets)
    for much, less in FEWER.items():
        assert much in text
        text = text.replace(much, less)
    names: dict[str, Any] = {}
    exec(compile(text, str(PAGE), "exec"), names)
    names["envs"].close()
    assert names["observations"].shape[0] == names["envs"].num_envs
    assert (tmp_path / "out" / "tracker" / "report.html").exists()


def public(cls: type) -> list[str]:
    return [name for name, member in vars(cls).items() if not name.startswith("_") and inspect.isfunction(member)]


def test_reference_names_everything_public() -> None:
    api = PAGE.read_text(encoding="utf-8").split("## API")[1]
    names = [*hificamsim.__all__]
    for cls in (hificamsim.Worlds, hificamsim.CameraEnv, hificamsim.CameraVectorEnv, hificamsim.NetworkEnv):
        names += public(cls)
    gymnasiums = {"begin", "observation_space", "action_space", "close_extras"}
    missing = [name for name in sorted({*names} - gymnasiums) if f"`{name}" not in api and f" {name}" not in api]
    assert not missing
    undocumented = [name for name in hificamsim.__all__ if not inspect.getdoc(getattr(hificamsim, name))]
    assert not undocumented


def test_page_lists_every_observation_feature_and_reward() -> None:
    page = PAGE.read_text(encoding="utf-8")
    with hificamsim.Worlds("campus", belief=True) as worlds:
        for feature in worlds.features:
            name = re.sub(r"^(target|neighbour|view)\d+_", "", feature["name"])
            assert f"`{name}`" in page, feature
    with pytest.raises(hificamsim.InputError) as fault:
        hificamsim.Worlds("campus", reward="none")
    for reward in re.findall(r"[a-z]+", str(fault.value).split("expected one of ")[1]):
        assert f"`{reward}" in page

"""Runs, comparisons and folders of results as frames."""

from __future__ import annotations

import pathlib

import pytest

import hificamsim


def test_a_run_gives_its_tables() -> None:
    run = hificamsim.run("cluster-random", policy="zoom-out", steps=50, repeat=2)
    assert len(run["steps"]) == 100
    assert run.settings["policy"] == "zoom-out"
    assert run.folder is None
    with pytest.raises(hificamsim.InputError, match="no table 'step', expected one of .*steps"):
        run["step"]


def test_a_comparison_gives_its_tables_and_stays_where_it_is_told(tmp_path: pathlib.Path) -> None:
    folder = tmp_path / "results"
    made = hificamsim.compare(
        "cluster-random",
        policies=["zoom-out", "random"],
        detections="hifi:orb-lin",
        steps=30,
        repeat=2,
        out=folder,
    )
    assert sorted(made["results"]["policy"].unique()) == ["random", "zoom-out"]
    assert {"results", "metrics", "summary", "steps"} <= set(made.frames)
    again = hificamsim.read_results(folder)
    assert again["results"].equals(made["results"])


def test_a_column_without_a_value_is_numbers() -> None:
    # one detection has no other to differ from, and an optimum of 0 has no parts
    made = hificamsim.compare("cluster-random", policies="zoom-out", detections="hifi:orb-lin", steps=5)
    for table, column in [
        ("results", "proportion_of_optimal"),
        ("summary", "difference"),
        ("aggregate", "value"),
        ("profile", "share"),
    ]:
        values = made[table][column]
        assert len(values) and values.isna().all(), column
        assert values.dtype == float, column


def test_what_the_command_line_refuses_is_a_line(tmp_path: pathlib.Path) -> None:
    with pytest.raises(hificamsim.InputError, match="unknown policy 'zoom', expected one of"):
        hificamsim.run("cluster-random", policy="zoom", steps=5)
    with pytest.raises(hificamsim.InputError, match="has no tables, expected a folder of results"):
        hificamsim.read_results(tmp_path)

"""Tests runs, comparisons and folders of results as frames."""

from __future__ import annotations

import json
import pathlib
import sys

import pandas as pd
import pytest

import hificamsim

PARQUET = pathlib.Path(__file__).resolve().parents[2] / "parquet/build/install/parquet"


def test_run_returns_tables() -> None:
    run = hificamsim.run("cluster-random", policy="zoom-out", steps=50, repeat=2)
    assert len(run["steps"]) == 100
    assert run.settings["policy"] == "zoom-out"
    assert run.folder is None
    with pytest.raises(hificamsim.InputError, match="no table 'step', expected one of .*steps"):
        run["step"]


def test_comparison_returns_tables_and_keeps_its_folder(tmp_path: pathlib.Path) -> None:
    folder = tmp_path / "results"
    comparison = hificamsim.compare(
        "cluster-random",
        policies=["zoom-out", "random"],
        detections="hifi:orb-lin",
        steps=30,
        repeat=2,
        out=folder,
    )
    assert sorted(comparison["results"]["policy"].unique()) == ["random", "zoom-out"]
    assert {"results", "metrics", "summary", "steps"} <= set(comparison.frames)
    again = hificamsim.read_results(folder)
    assert again["results"].equals(comparison["results"])


def test_run_reads_model_file_of_boxes(tmp_path: pathlib.Path) -> None:
    model = {
        "schema": "hificamsim-model",
        "version": 4,
        "name": "mine",
        "found": {"intercept": 2, "height": 3, "hidden": 7, "width": {"slope": 1.5, "usualShape": 0.34}},
        "falseAlarms": 0.5,
    }
    file = tmp_path / "mine.json"
    file.write_text(json.dumps(model), encoding="utf-8")
    run = hificamsim.run("hall", policy="zoom-out", detection=str(file), steps=20)
    assert run.settings["detect"] == "probability"
    model["found"]["hidden"] = 0
    file.write_text(json.dumps(model), encoding="utf-8")
    unhidden = hificamsim.run("hall", policy="zoom-out", detection=str(file), steps=20)
    assert run["steps"]["expected_mean_k"].mean() < unhidden["steps"]["expected_mean_k"].mean()


def test_columns_equal_csv_with_types(tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    if not list(PARQUET.glob("parquet-*.jar")):
        pytest.skip("no Parquet: gradle :parquet:libraries")
    pytest.importorskip("pyarrow")
    monkeypatch.setenv("CLASSPATH", str(PARQUET / "*"))
    settings = {"policy": "random", "steps": 300, "repeat": 2, "record": True, "detect": "chance"}
    text = hificamsim.run("cluster-random", **settings)
    columns = hificamsim.run("cluster-random", format="parquet", out=tmp_path, **settings)
    assert set(columns.frames) == {"steps", "zooms", "targets"}
    for table, frame in columns.frames.items():
        pd.testing.assert_frame_equal(frame, text[table].astype(frame.dtypes), check_exact=True)
    assert str(columns["steps"].dtypes["step"]) == "int64"
    assert str(columns["steps"].dtypes["k_min"]) == "int32"
    schema = pytest.importorskip("pyarrow.parquet").read_schema(tmp_path / "targets.parquet")
    assert schema.metadata[b"x.unit"] == b"m"


def test_reports_missing_libraries_in_one_line(tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("CLASSPATH", raising=False)
    with pytest.raises(hificamsim.InputError, match="format 'parquet' is not on the class path, expected its jars"):
        hificamsim.run("cluster-random", format="parquet", steps=5)
    (tmp_path / "steps.parquet").touch()
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    with pytest.raises(hificamsim.Error, match=r"needs pyarrow, expected .*pip install 'hificamsim\[parquet\]'"):
        hificamsim.read_results(tmp_path)


def test_empty_column_is_numeric() -> None:
    # one detection has no other to differ from, and an optimum of 0 has no parts
    comparison = hificamsim.compare("cluster-random", policies="zoom-out", detections="hifi:orb-lin", steps=5)
    for table, column in [
        ("results", "proportion_of_optimal"),
        ("summary", "difference"),
        ("aggregate", "value"),
        ("profile", "share"),
    ]:
        values = comparison[table][column]
        assert len(values) and values.isna().all(), column
        assert values.dtype == float, column


def test_command_line_errors_are_one_line(tmp_path: pathlib.Path) -> None:
    with pytest.raises(hificamsim.InputError, match="unknown policy 'zoom', expected one of"):
        hificamsim.run("cluster-random", policy="zoom", steps=5)
    with pytest.raises(hificamsim.InputError, match="has no tables, expected a folder of results"):
        hificamsim.read_results(tmp_path)


def test_plan_returns_tables_and_matrix(tmp_path: pathlib.Path) -> None:
    pytest.importorskip("scipy")
    options = {"cameras": 2, "catalogue": "site", "cells": 12, "candidates": "every=10"}
    plan = hificamsim.place("car-park", out=tmp_path / "plan", **options)
    assert 0 < plan.share <= plan.bound <= 1
    assert plan.matrix.shape == (plan.settings["candidates"], len(plan["samples"]))
    assert plan["curve"].share.iloc[-1] == pytest.approx(plan.share)
    assert plan.matrix.sum(axis=0).max() > 0

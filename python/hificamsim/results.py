"""Runs and comparisons of the command line as functions, and their folders as pandas frames."""

from __future__ import annotations

import json
import os
import pathlib
import re
import subprocess
import tempfile
import warnings
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import Any

import pandas as pd

from . import java
from .errors import Error, InputError, path, shown
from .worlds import Worlds, scenario_file, shipped

BAD_INPUT = 2
WARNING = "warning: "


@dataclass(frozen=True)
class Results:
    """A folder of results.

    :ivar settings: the settings of the runs (``settings.json``, or ``summary.json``)
    :ivar frames: the tables by the names of their files: ``frames["steps"]`` is ``steps.csv`` or ``steps.parquet``
    :ivar folder: the folder; None if it was deleted
    """

    settings: dict[str, Any]
    frames: dict[str, pd.DataFrame] = field(repr=False)
    folder: pathlib.Path | None = None

    def __getitem__(self, table: str) -> pd.DataFrame:
        try:
            return self.frames[table]
        except KeyError:
            raise InputError(f"no table {table!r}, expected one of {', '.join(self.frames)}") from None


def read_results(folder: str | os.PathLike[str]) -> Results:
    """Reads a folder that ``run``, ``compare`` or another command wrote."""
    base = pathlib.Path(path(folder, "folder"))
    if not os.path.isdir(base):
        raise InputError(f"folder {shown(str(base))} is none, expected one of results")
    if (base / ".hificamsim" / "commit").exists():
        raise InputError(f"{base} is half written by a command that was killed, expected it whole: hificamsim report {base}")
    tables = sorted(file for ending in ("*.csv", "*.csv.gz", "*.parquet") for file in base.glob(ending))
    if not tables:
        raise InputError(f"{shown(str(base))} has no tables, expected a folder of results")
    frames = {file.name.split(".")[0]: _frame(file) for file in tables}
    return Results(_settings(base), frames, base)


def _frame(file: pathlib.Path) -> pd.DataFrame:
    if file.suffix == ".parquet":
        return _columns(file)
    return pd.read_csv(file, keep_default_na=False, na_values=[""])  # a name may be NA


def _columns(file: pathlib.Path) -> pd.DataFrame:
    try:
        return pd.read_parquet(file, engine="pyarrow")
    except ImportError as missing:
        raise Error(f"{file} needs pyarrow, expected it in addition to pandas: pip install 'hificamsim[parquet]'") from missing


def _settings(base: pathlib.Path) -> dict[str, Any]:
    for name in ("settings.json", "summary.json"):
        if (base / name).exists():
            read: dict[str, Any] = json.loads((base / name).read_text(encoding="utf-8"))
            return read
    return {}


def run(
    scenario: str | os.PathLike[str], *, out: str | os.PathLike[str] | None = None, **options: Any
) -> Results:
    """Runs a scenario: ``run("campus", policy="sarsa", repeat=3)`` is ``hificamsim run campus.xml --policy sarsa ...``.
    Detection, objective and steps are the scenario's unless options override them. ``run("campus")["steps"].score`` has the
    score of each step, and ``settings["score_words"]`` its meaning.
    :param out: the folder of the files; without it they are read and deleted
    :param options: the options of the command, with ``_`` for ``-``; True for an option without a value, a list for several
    """
    return _command("run", [scenario_file(scenario)], out, options)


def compare(
    *scenarios: str | os.PathLike[str], out: str | os.PathLike[str] | None = None, **options: Any
) -> Results:
    """Compares policies and detection models: ``compare("campus", policies=["zoom-out", "sarsa"])``; options as for ``run``."""
    return _command("compare", [scenario_file(scenario) for scenario in scenarios], out, options)


@dataclass(frozen=True)
class Plan(Results):
    """A plan of cameras: ``frames`` has cameras, samples and curve; ``settings`` is ``summary.json``.

    :ivar matrix: a sparse array of SciPy, candidates by samples: 1 if a candidate covers a sample of ``frames["samples"]``
    """

    matrix: Any = field(repr=False, default=None)

    @property
    def share(self) -> float:
        """The weighted share of the samples that is met, which ``bound`` limits."""
        return float(self.settings["share"])

    @property
    def share_of_area(self) -> float:
        """The share of the zones' area that is met, which is measured on a finer raster."""
        return float(self.settings["share_of_area"])

    @property
    def bound(self) -> float:
        """A share that no plan of the same candidates exceeds; with ``cover=True``, the share that all candidates meet."""
        return float(self.settings["share_bound"])


def place(site: str | os.PathLike[str], *, out: str | os.PathLike[str] | None = None, **options: Any) -> Plan:
    """Plans cameras: ``place("museum", cameras=40)`` is ``hificamsim place museum.xml --cameras 40``; options as for ``run``."""
    from scipy.sparse import csr_array

    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch if out is None else out)
        results = _command("place", [scenario_file(site)], folder, {**options, "form": "candidates"})
        first, *rows = (folder / "instance.txt").read_text(encoding="ascii").splitlines()
        seen = [[int(number) - 1 for number in row.split()[2:]] for row in rows]
    samples, candidates = (int(number) for number in first.split())
    ends = [0]
    for row in seen:
        ends.append(ends[-1] + len(row))
    indices = [sample for row in seen for sample in row]
    matrix = csr_array(([1] * len(indices), indices, ends), shape=(candidates, samples), dtype="int8")
    return Plan(results.settings, results.frames, None if out is None else folder, matrix)


def _command(
    name: str, files: list[str], out: str | os.PathLike[str] | None, options: dict[str, Any]
) -> Results:
    words = [word for key, value in options.items() for word in _words(key, value)]
    if out is not None:
        _execute_with_keywords(name, *files, "--out", os.fspath(out), *words)
        return read_results(out)
    with tempfile.TemporaryDirectory() as scratch:
        _execute_with_keywords(name, *files, "--out", scratch, *words)
        read = read_results(scratch)
    return Results(read.settings, read.frames)


def _execute_with_keywords(*words: str) -> None:
    """Runs a command for a caller who passed keywords: its errors name ``steps=`` instead of ``--steps``.
    Warnings of the command become warnings of Python.
    """
    try:
        done = _finished(*words)
    except Error as e:
        raise type(e)(_with_keywords(str(e))) from None
    for message in done.stderr.splitlines():
        if message.startswith(WARNING):
            warnings.warn(_with_keywords(message.removeprefix(WARNING)), stacklevel=4)


def _with_keywords(message: str) -> str:
    return re.sub(r"(?<![\w-])--(?!help\b)([a-z]+(?:-[a-z]+)*)", lambda flag: flag[1].replace("-", "_") + "=", message)


def _words(key: str, value: Any) -> list[str]:
    option = "--" + key.replace("_", "-")
    if value is None or value is False:
        return []
    if value is True:
        return [option]
    if isinstance(value, Iterable) and not isinstance(value, str):
        return [option, ",".join(str(item) for item in value)]
    return [option, str(value)]


def execute(*words: str) -> str:
    """Runs any command of ``hificamsim``, and returns its output."""
    return _finished(*words).stdout


def _finished(*words: str) -> subprocess.CompletedProcess[str]:
    root = f"-Dhificamsim.root={shipped().resolve().parent}"
    command = [java.executable(), *java.options(), root, "-cp", os.pathsep.join(java.class_path())]
    done = subprocess.run(
        [*command, "org.hificamsim.cli.Main", *words],
        capture_output=True,
        text=True,
        encoding="utf-8",
        stdin=subprocess.DEVNULL,
        check=False,
    )
    if done.returncode == BAD_INPUT:
        hint = "; ONNX Runtime is not on CLASSPATH" if "unknown policy 'onnx:" in done.stderr else ""
        raise InputError(done.stderr.strip() + hint)
    if done.returncode:
        raise Error(done.stderr.strip())
    return done


def record(
    worlds: Worlds, actions: pathlib.Path, steps: int, folder: str | os.PathLike[str]
) -> pathlib.Path:
    """Replays actions, writes the run into a folder, and returns its page."""
    if worlds.file.endswith(".json"):
        raise InputError("a task has no report, expected a scenario: its site is drawn for each episode")
    settings = {key: value for key, value in worlds.settings.items() if key in worlds.run_settings}
    episode = {"policy": f"played:actions={worlds.kind},file={actions}", "steps": steps, "seed": worlds.episode_seed()}
    run(worlds.file, out=folder, record=True, **{**settings, **episode})
    return pathlib.Path(folder, "report.html")

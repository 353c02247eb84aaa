"""Tests that the Python programs of the tutorials print the output on their pages, in which ``...`` stands for any text."""

from __future__ import annotations

import os
import pathlib
import re
import subprocess
import sys

import pytest

from hificamsim import java

PAGES = pathlib.Path(__file__).resolve().parents[2] / "docs" / "tutorials"
PROGRAM = re.compile(r'^```python title="([^"]+)"\n(.*?)^```', re.M | re.S)


@pytest.mark.parametrize("page", [page.stem for page in sorted(PAGES.glob("*.md")) if PROGRAM.search(page.read_text())])
def test_program_prints_output_of_its_page(page: str, tmp_path: pathlib.Path) -> None:
    text = (PAGES / f"{page}.md").read_text(encoding="utf-8")
    for name, program in PROGRAM.findall(text):
        (tmp_path / name).write_text(program, encoding="utf-8")
        shown = re.search(rf"^\$ python {re.escape(name)}.*?\n(.*?)^(?:```|\$)", text, re.M | re.S)
        assert shown, f"{page} does not run {name}"
        run = subprocess.run([sys.executable, name], cwd=tmp_path, capture_output=True, text=True, check=False)
        assert run.returncode == 0, run.stderr
        expected = ".*".join(re.escape(part) for part in shown[1].strip().split("..."))
        assert re.fullmatch(expected, run.stdout.strip(), re.S), run.stdout


def test_benchmark_tutorial_runs_unchanged(tmp_path: pathlib.Path) -> None:
    for needed in ("onnx", "jax", "optax"):
        pytest.importorskip(needed)
    root = PAGES.parents[1]
    onnx = root / "onnx" / "build" / "install" / "onnx"
    if not onnx.exists():
        pytest.skip("no ONNX Runtime: gradle :onnx:libraries")
    (tmp_path / "python").symlink_to(root / "python")
    jars = os.pathsep.join([*java.class_path(), f"{onnx}/*"])
    start = f"exec '{java.executable()}' -XX:+UseSerialGC -Dhificamsim.root='{root}' -cp '{jars}' org.hificamsim.cli.Main \"$@\""
    (tmp_path / "hificamsim").write_text(f"#!/bin/sh\n{start}\n", encoding="utf-8")
    (tmp_path / "hificamsim").chmod(0o755)
    text = (PAGES / "benchmark.md").read_text(encoding="utf-8")
    typed = re.findall(r"^\$ (.*)\n((?:(?!\$ |```).*\n)*)", text, re.M)
    assert len(typed) == 5
    for command, shown in typed:
        line = command.replace("python ", f"'{sys.executable}' ", 1) if command.startswith("python ") else command
        run = subprocess.run(line, shell=True, cwd=tmp_path, capture_output=True, text=True, check=False)
        assert run.returncode == 0, command + run.stderr
        expected = ".*".join(re.escape(part) for part in shown.strip().split("..."))
        assert re.fullmatch(expected, run.stdout.strip(), re.S), command + run.stdout

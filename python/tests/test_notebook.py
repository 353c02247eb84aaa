"""Tests that the notebooks run, and that their statements hold."""

from __future__ import annotations

import os
import pathlib
from typing import Any

import pytest

EXAMPLES = pathlib.Path(__file__).resolve().parents[1] / "examples"
NOTEBOOK = EXAMPLES / "cameras-that-learn.ipynb"
CHECKS = """
assert (len(built_in), len(table)) == (5, 7)
assert curve.score.iloc[-3:].mean() > 1.5 * curve.score.iloc[0]
assert table["mean"]["mine"] > 1.2 * table["mean"]["epsilon-greedy"]
assert table["mean"]["trained for longer"] > 0.9 * table["mean"]["best-fixed"]
assert (folder / "report.html").exists()
"""


@pytest.fixture
def notebook() -> Any:
    return pytest.importorskip("nbformat").read(NOTEBOOK, as_version=4)


def code(notebook: Any) -> list[Any]:
    return [cell for cell in notebook.cells if cell.cell_type == "code"]


def test_notebook_has_no_outputs(notebook: Any) -> None:
    assert not any(cell.outputs or cell.execution_count for cell in code(notebook))


def test_notebook_runs(notebook: Any) -> None:
    import nbformat

    nbclient = pytest.importorskip("nbclient")
    for name in ("ipykernel", "matplotlib", "onnx"):
        pytest.importorskip(name)
    if not (EXAMPLES.parents[1] / "onnx/build/install/onnx").exists():
        pytest.skip("no ONNX Runtime: gradle :onnx:libraries")
    training = next(cell for cell in notebook.cells if "UPDATES = 60" in cell.source)
    training.source = training.source.replace("UPDATES = 60", "UPDATES = 12")  # that is enough to see it learn
    notebook.cells.append(nbformat.v4.new_code_cell(CHECKS))
    client = nbclient.NotebookClient(notebook, timeout=600, resources={"metadata": {"path": str(EXAMPLES)}})
    client.execute()
    if os.environ.get("NOTEBOOK_OUT"):  # to look at
        nbformat.write(notebook, os.environ["NOTEBOOK_OUT"])
    shown = [out.data for cell in code(notebook) for out in cell.outputs if "data" in out]
    assert sum("image/png" in data for data in shown) == 3


OTHERS = {"compare-policies": 2, "detection-models": 1, "many-worlds": 1, "place-cameras": 1}  # numbers of pictures


@pytest.mark.parametrize("name", OTHERS)
def test_every_other_notebook_runs_and_draws(name: str) -> None:
    nbformat, nbclient = pytest.importorskip("nbformat"), pytest.importorskip("nbclient")
    for needed in ("ipykernel", "matplotlib", "scipy"):
        pytest.importorskip(needed)
    book = nbformat.read(EXAMPLES / f"{name}.ipynb", as_version=4)
    test_notebook_has_no_outputs(book)
    nbclient.NotebookClient(book, timeout=600, resources={"metadata": {"path": str(EXAMPLES)}}).execute()
    shown = [out.data for cell in code(book) for out in cell.outputs if "data" in out]
    assert sum("image/png" in data for data in shown) == OTHERS[name]


def test_every_notebook_is_tested() -> None:
    assert {book.stem for book in EXAMPLES.glob("*.ipynb")} == {NOTEBOOK.stem, *OTHERS}

"""Tests that the notebooks run, and that their statements hold."""

from __future__ import annotations

import os
import pathlib
from typing import Any

import pytest

EXAMPLES = pathlib.Path(__file__).resolve().parents[1] / "examples"
NOTEBOOK = EXAMPLES / "cameras-that-learn.ipynb"
CHECKS = """
assert (len(built_in), len(table)) == (6, 8)
assert curve.agreement.iloc[-1] > 0.7 and curve.minutes.iloc[-1] < 2
assert table["mean"]["mine"] > 2 * table["mean"]["epsilon-greedy"]
assert table["mean"]["mine"] > table["mean"]["best-fixed"]
assert table["mean"]["mine"] > 0.85 * table["mean"]["cooperative"]
assert table["mean"]["trained on all tasks"] > 0.85 * table["mean"]["cooperative"]
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
    for name in ("ipykernel", "matplotlib", "onnx", "jax", "optax"):
        pytest.importorskip(name)
    if not (EXAMPLES.parents[1] / "onnx/build/install/onnx").exists():
        pytest.skip("no ONNX Runtime: gradle :onnx:libraries")
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

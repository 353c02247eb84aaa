"""The Python programs of the tutorials print what their pages show, ``...`` for anything."""

from __future__ import annotations

import pathlib
import re
import subprocess
import sys

import pytest

PAGES = pathlib.Path(__file__).resolve().parents[2] / "docs" / "tutorials"
PROGRAM = re.compile(r'^```python title="([^"]+)"\n(.*?)^```', re.M | re.S)


@pytest.mark.parametrize("page", [page.stem for page in sorted(PAGES.glob("*.md")) if PROGRAM.search(page.read_text())])
def test_a_program_prints_what_its_page_shows(page: str, tmp_path: pathlib.Path) -> None:
    text = (PAGES / f"{page}.md").read_text(encoding="utf-8")
    for name, program in PROGRAM.findall(text):
        (tmp_path / name).write_text(program, encoding="utf-8")
        shown = re.search(rf"^\$ python {re.escape(name)}.*?\n(.*?)^(?:```|\$)", text, re.M | re.S)
        assert shown, f"{page} does not run {name}"
        run = subprocess.run([sys.executable, name], cwd=tmp_path, capture_output=True, text=True, check=False)
        assert run.returncode == 0, run.stderr
        expected = ".*".join(re.escape(part) for part in shown[1].strip().split("..."))
        assert re.fullmatch(expected, run.stdout.strip(), re.S), run.stdout

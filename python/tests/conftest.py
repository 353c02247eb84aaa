"""Fixtures that the tests share."""

from __future__ import annotations

import os
import pathlib

import pytest

os.environ["SDL_VIDEODRIVER"] = "dummy"  # render_mode="human" without a screen

BACKENDS = ["jvm", "process"]


@pytest.fixture(params=BACKENDS)
def backend(request: pytest.FixtureRequest) -> str:
    """Runs a test with each backend."""
    return str(request.param)


@pytest.fixture
def onnx_runtime(monkeypatch: pytest.MonkeyPatch) -> None:
    """Adds ONNX Runtime, which plays trained networks, to the class path."""
    installed = pathlib.Path(__file__).resolve().parents[2] / "onnx/build/install/onnx"
    if not installed.exists():
        pytest.skip("no ONNX Runtime: gradle :onnx:libraries")
    monkeypatch.setenv("CLASSPATH", f"{installed}/*")

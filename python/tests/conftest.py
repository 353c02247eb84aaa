"""What the tests share."""

from __future__ import annotations

import os

import pytest

os.environ["SDL_VIDEODRIVER"] = "dummy"  # render_mode="human" without a screen

BACKENDS = ["jvm", "process"]


@pytest.fixture(params=BACKENDS)
def backend(request: pytest.FixtureRequest) -> str:
    """Either way across."""
    return str(request.param)

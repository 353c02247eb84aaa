"""A window for ``render_mode="human"``; needs pygame."""

from __future__ import annotations

import os

from .errors import Error
from .worlds import Array

os.environ.setdefault("PYGAME_HIDE_SUPPORT_PROMPT", "1")
# SDL would take the signals by which the JVM stops its threads for a moment as crashes, and end the process, while SIGTERM
# would only close a window. SDL reads this variable when it starts.
os.environ["SDL_NO_SIGNAL_HANDLERS"] = "1"


class Screen:
    """A window that shows pictures one after the other."""

    def __init__(self, title: str) -> None:
        try:
            import pygame
        except ImportError as e:
            raise Error("render_mode='human' needs pygame: pip install 'hificamsim[screen]'") from e
        self._pygame = pygame
        self._title = title
        self._window: object = None

    def show(self, picture: Array) -> None:
        """Shows a picture, uint8 (height, width, 3), in a window of its size."""
        pygame = self._pygame
        if self._window is None:
            pygame.display.init()
            pygame.display.set_caption(self._title)
            self._window = pygame.display.set_mode((picture.shape[1], picture.shape[0]))
        pygame.event.pump()
        surface = pygame.surfarray.make_surface(picture.swapaxes(0, 1))
        self._window.blit(surface, (0, 0))  # type: ignore[attr-defined]
        pygame.display.flip()

    def close(self) -> None:
        """Closes the window."""
        if self._window is not None:
            self._pygame.display.quit()
            self._window = None

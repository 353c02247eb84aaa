"""The spaces of worlds."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import gymnasium
import numpy as np

from .errors import InputError, shown
from .worlds import Array, Worlds


RATE = 1000  # of which a rate of 1 is as many


def observation(worlds: Worlds, *shape: int) -> gymnasium.spaces.Box:
    """Of observations, with their true bounds; ``shape`` is what comes before the numbers of a camera."""
    low, high = worlds.bounds()
    full = (*shape, low.size)
    return gymnasium.spaces.Box(np.broadcast_to(low, full), np.broadcast_to(high, full), dtype=np.float32)


def state(worlds: Worlds) -> gymnasium.spaces.Box:
    """Of the state of a world."""
    return gymnasium.spaces.Box(-1, 1, (worlds.states.shape[1],), np.float32)


def action(worlds: Worlds, camera: int | None = None) -> gymnasium.spaces.Space[Any]:
    """Of a camera's action; without a camera, of one that may be any."""
    if worlds.kind == "rates":
        return gymnasium.spaces.Box(-1, 1, (2,), np.float32)
    if len(worlds.choices) > 1:
        return gymnasium.spaces.MultiDiscrete(worlds.choices)
    return gymnasium.spaces.Discrete(worlds.choices[0] if camera is None else worlds.views[camera])


def joint_action(worlds: Worlds) -> gymnasium.spaces.Space[Any]:
    """Of the actions of all cameras, one after the other."""
    if worlds.kind == "rates":
        return gymnasium.spaces.Box(-1, 1, (2 * len(worlds.cameras),), np.float32)
    if len(worlds.choices) > 1:
        return gymnasium.spaces.MultiDiscrete(worlds.choices * len(worlds.cameras))
    return gymnasium.spaces.MultiDiscrete(worlds.views)


def counts(of: gymnasium.spaces.Space[Any]) -> Array:
    """Of how many each number of an action of a space is one; of rates the most that each can be, as floats."""
    if isinstance(of, gymnasium.spaces.Box):
        return of.high
    n = of.n if isinstance(of, gymnasium.spaces.Discrete) else of.nvec  # type: ignore[attr-defined]
    return np.asarray(n, np.uint64)  # as which a negative action is a large one


def told(actions: Any, counts: Array, name: Callable[[tuple[int, ...]], str], least: int = 0) -> Array:
    """Actions of the shape of ``counts``, each a whole number from ``least`` to below its count; rates in thousandths.

    :param name: says whose the action at an index is
    :param least: 0 or -1, see ``Worlds.least_action``
    """
    try:
        values = np.asarray(actions)
    except ValueError:
        values = np.empty(0, object)  # not even rows of one length
    if values.shape != counts.shape:
        raise InputError(f"actions have shape {values.shape}, expected {counts.shape}")
    rated = counts.dtype.kind == "f"
    if rated and values.dtype.kind in "fiu" and ((values >= -1) & (values <= 1)).all():
        return np.rint(RATE * (values.astype(np.float64) + 1)).astype(np.int32)
    if not rated and values.dtype.kind in "iu" and not np.count_nonzero(_from(values, least) >= _from(counts, least)):
        return values
    for index, value in np.ndenumerate(np.asarray(actions, object)):
        number = isinstance(value, (int, np.integer, *((float, np.floating) if rated else ())))
        first, last = (-1, 1) if rated else (least, int(counts[index]) - 1)
        if not number or isinstance(value, bool) or not first <= value <= last:
            said = value if isinstance(value, (int, float, np.number)) else shown(value)
            raise InputError(
                f"action {said} of {name(index)}, expected a {'rate' if rated else 'whole number'} from {first} to {last}"
            )
    raise InputError(f"actions are of type {values.dtype}, expected {'rates' if rated else 'whole numbers'}")


def _from(values: Array, least: int) -> Array:
    """Values counted from ``least`` on, unsigned, so that a lower one is a large number."""
    unsigned = values.astype(np.uint64, copy=False)
    return unsigned if least == 0 else unsigned + np.uint64(-least)


def mask(worlds: Worlds, camera: int, of: Array) -> Array | tuple[Array, ...]:
    """A camera's mask as ``Space.sample`` takes it."""
    if len(worlds.choices) == 1:
        return of[: worlds.views[camera]]
    ends = np.cumsum(worlds.choices)[:-1]
    return tuple(np.split(of, ends))

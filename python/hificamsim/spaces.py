"""The spaces of observations and actions, and the check of actions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import gymnasium
import numpy as np

from .errors import InputError, shown
from .worlds import Array, Worlds


RATE = 1000  # the simulator counts rates in thousandths


def observation(worlds: Worlds, *shape: int) -> gymnasium.spaces.Box:
    """Returns the space of observations with their true bounds; ``shape`` has the dimensions before a camera's numbers."""
    low, high = worlds.bounds()
    full = (*shape, low.size)
    return gymnasium.spaces.Box(np.broadcast_to(low, full), np.broadcast_to(high, full), dtype=np.float32)


def state(worlds: Worlds) -> gymnasium.spaces.Box:
    """Returns the space of the state of a world."""
    return gymnasium.spaces.Box(-1, 1, (worlds.states.shape[1],), np.float32)


def action(worlds: Worlds, camera: int | None = None) -> gymnasium.spaces.Space[Any]:
    """Returns the space of a camera's action; without a camera, a space that suits all cameras."""
    if worlds.kind == "rates":
        return gymnasium.spaces.Box(-1, 1, (2,), np.float32)
    if len(worlds.choices) > 1:
        return gymnasium.spaces.MultiDiscrete(worlds.choices)
    return gymnasium.spaces.Discrete(worlds.choices[0] if camera is None else worlds.views[camera])


def joint_action(worlds: Worlds) -> gymnasium.spaces.Space[Any]:
    """Returns the space of the actions of all cameras, one after the other."""
    if worlds.kind == "rates":
        return gymnasium.spaces.Box(-1, 1, (2 * len(worlds.cameras),), np.float32)
    if len(worlds.choices) > 1:
        return gymnasium.spaces.MultiDiscrete(worlds.choices * len(worlds.cameras))
    return gymnasium.spaces.MultiDiscrete(worlds.views)


def counts(space: gymnasium.spaces.Space[Any]) -> Array:
    """Returns the number of choices of each number of an action; for rates their maximum, as floats."""
    if isinstance(space, gymnasium.spaces.Box):
        return space.high
    n = space.n if isinstance(space, gymnasium.spaces.Discrete) else space.nvec  # type: ignore[attr-defined]
    return np.asarray(n, np.uint64)  # unsigned, so that a negative action becomes a large number


def checked(actions: Any, counts: Array, name: Callable[[tuple[int, ...]], str], least: int = 0) -> Array:
    """Checks actions, which have the shape of ``counts``: each is a whole number from ``least`` to below its count, or a rate.
    Rates are returned in thousandths.
    :param name: returns the name of the camera whose action is at an index
    :param least: 0 or -1, see ``Worlds.least_action``
    """
    try:
        values = np.asarray(actions)
    except ValueError:
        values = np.empty(0, object)  # the rows have different lengths
    if values.shape != counts.shape:
        raise InputError(f"actions have shape {values.shape}, expected {counts.shape}")
    are_rates = counts.dtype.kind == "f"
    if are_rates and values.dtype.kind in "fiu" and ((values >= -1) & (values <= 1)).all():
        return np.rint(RATE * (values.astype(np.float64) + 1)).astype(np.int32)
    if not are_rates and values.dtype.kind in "iu" and not np.count_nonzero(_offset(values, least) >= _offset(counts, least)):
        return values
    for index, value in np.ndenumerate(np.asarray(actions, object)):
        number = isinstance(value, (int, np.integer, *((float, np.floating) if are_rates else ())))
        first, last = (-1, 1) if are_rates else (least, int(counts[index]) - 1)
        if not number or isinstance(value, bool) or not first <= value <= last:
            text = value if isinstance(value, (int, float, np.number)) else shown(value)
            raise InputError(
                f"action {text} of {name(index)}, expected a {'rate' if are_rates else 'whole number'} from {first} to {last}"
            )
    raise InputError(f"actions are of type {values.dtype}, expected {'rates' if are_rates else 'whole numbers'}")


def _offset(values: Array, least: int) -> Array:
    """Counts values from ``least`` on, unsigned, so that a lower value becomes a large number."""
    unsigned = values.astype(np.uint64, copy=False)
    return unsigned if least == 0 else unsigned + np.uint64(-least)


def mask(worlds: Worlds, camera: int, row: Array) -> Array | tuple[Array, ...]:
    """Returns the mask of a camera as ``Space.sample`` takes it, given its row of ``masks``."""
    if len(worlds.choices) == 1:
        return row[: worlds.views[camera]]
    ends = np.cumsum(worlds.choices)[:-1]
    return tuple(np.split(row, ends))

"""VDN and QMIX: cameras learn what their views are worth to all of them together.

    python qmix.py vdn --rounds 6 --out nets/vdn
    python qmix.py qmix --start nets/imitation --rounds 6 --out nets/qmix

A network values each view of a camera; what the team has of a step is, in VDN (Sunehag et al. 2018,
https://arxiv.org/abs/1706.05296), the sum of the values of the chosen views, and in QMIX (Rashid et al. 2018,
https://arxiv.org/abs/1803.11485) a mixture of them that grows with each, with weights by what the cameras' views promise;
the mixer is for training alone. Sums are over cameras, so that both fit any site; here they are means, for one network to
fit sites of three and of forty cameras. Double Q-learning with a slow copy of the networks, from episodes of training seeds that
are kept; called again with more rounds, it goes on from its checkpoint.
"""

from __future__ import annotations

import pathlib
from collections.abc import Callable
from typing import Any

import jax
import jax.numpy as jnp
import learners
import numpy as np
import optax

import hificamsim

WORLDS, KEPT, BATCH, UPDATES, RATE = 2, 6, 32, 60, 1e-3
GAMMA, AHEAD, SLOWLY, MIXED = 0.9, 4, 0.02, 16
Networks = dict[str, learners.Weights]
Array = learners.Array


def networks(method: str, hidden: int, start: pathlib.Path | None, random: np.random.Generator) -> Networks:
    """The networks at the start: of views, of cameras, and for QMIX of the mixer."""
    sizes = [hidden, hidden]
    of_view = learners.actor_of(start) if start else learners.network([learners.NUMBERS, *sizes, 1], random)
    of_view[-2:] = [0.1 * w for w in of_view[-2:]]
    about = 2 * learners.NUMBERS
    made = {"actor": of_view, "camera": learners.network([about, *sizes, 1], random, 0.1)}
    if method == "qmix":
        made["weights"] = learners.network([2 * about, hidden, MIXED], random)  # of a camera's value
        made["offsets"] = learners.network([about, hidden, MIXED + 1], random)
        made["last"] = learners.network([about, hidden, MIXED], random)
    constant = made["offsets" if method == "qmix" else "camera"]
    constant[-1] = constant[-1].at[-1].set(1 / (1 - GAMMA))  # what the team has of going on as in the first round
    return made


def values(nets: Networks, views: Array, masks: Array) -> Array:
    """What each view of each camera is worth, (..., C, V)."""
    camera = learners.apply(nets["camera"], learners.summary(views))
    return learners.values(nets["actor"], views, masks) + camera


def team(nets: Networks, views: Array, chosen: Array) -> Array:
    """What the team has of the chosen views' values (..., C); it never falls where one of them grows."""
    if "weights" not in nets:
        return chosen.mean(-1)
    own = learners.summary(views)
    every = own.mean(-2)
    both = jnp.concatenate([own, jnp.broadcast_to(every[..., None, :], own.shape)], -1)
    weights = jnp.abs(learners.apply(nets["weights"], both))  # (..., C, MIXED)
    offsets = learners.apply(nets["offsets"], every)
    mixed = jax.nn.elu((weights * chosen[..., None]).mean(-2) + offsets[..., :-1])
    return (jnp.abs(learners.apply(nets["last"], every)) * mixed).sum(-1) / MIXED + offsets[..., -1]


def error(nets: Networks, slow: Networks, batch: dict[str, Array]) -> Array:
    """The squared error of what the team has of what it chose, by what followed."""
    now = jnp.take_along_axis(values(nets, batch["views"], batch["masks"]), batch["actions"][..., None], -1)[..., 0]
    best = values(nets, batch["next_views"], batch["next_masks"]).argmax(-1)
    after = jnp.take_along_axis(values(slow, batch["next_views"], batch["next_masks"]), best[..., None], -1)[..., 0]
    target = batch["returns"] + GAMMA**AHEAD * team(slow, batch["next_views"], after)
    return optax.huber_loss(team(nets, batch["views"], now), jax.lax.stop_gradient(target)).mean()


def exploring(nets: Networks, share: float, random: np.random.Generator) -> Callable[[Array, Array], Array]:
    """Takes the best view, but for a share of the choices, which are drawn."""

    def choose(views: Array, masks: Array) -> Array:
        best = np.asarray(learners.values(nets["actor"], views, masks)).argmax(-1)
        drawn = np.where(masks, random.random(masks.shape), -1).argmax(-1)
        return np.where(random.random(best.shape) < share, drawn, best)

    return choose


def played(task: str, choose: Callable[[Array, Array], Array], random: np.random.Generator) -> dict[str, Array]:
    """New episodes of a task, with the rewards of the next steps added up."""
    with hificamsim.Worlds(task, WORLDS, auto_reset=False, reward="score", **learners.SETTINGS) as worlds:
        worlds.reset(int(random.integers(0, learners.SEEDS)))
        seen = learners.episode(worlds, choose)
    rewards = seen.pop("rewards").mean(-1)
    steps = len(rewards) - AHEAD
    seen["returns"] = sum(GAMMA**i * rewards[i : steps + i] for i in range(AHEAD)).astype(np.float32)
    return seen


def batch_of(kept: list[dict[str, Array]], scale: float, random: np.random.Generator) -> dict[str, Array]:
    """Steps of the kept episodes at random, and what followed."""
    seen = kept[random.integers(len(kept))]
    steps = random.integers(0, len(seen["returns"]), BATCH)
    worlds = random.integers(0, WORLDS, BATCH)
    made = {name: seen[name][steps, worlds] for name in ("views", "masks", "actions")}
    made |= {f"next_{name}": seen[name][steps + AHEAD, worlds] for name in ("views", "masks")}
    return made | {"returns": seen["returns"][steps, worlds] / np.float32(scale)}


def main() -> None:
    parser = learners.reads(__doc__, 6)
    parser.add_argument("method", choices=["vdn", "qmix"])
    parser.add_argument("--start", type=pathlib.Path, help="folder of a training to go on from")
    asked = parser.parse_args()
    keeper = learners.Keeper(asked.out)
    optimizer = optax.chain(optax.clip_by_global_norm(1.0), optax.adam(RATE))
    nets = networks(asked.method, asked.hidden, asked.start, np.random.default_rng(asked.seed))
    begun = {**nets, "slow": nets, "memory": optimizer.init(nets), "scales": np.zeros(len(asked.tasks))}
    learned = keeper.resume(begun)

    @jax.jit
    def step(learned: dict[str, Any], batch: dict[str, Array]) -> tuple[dict[str, Any], Array]:
        nets = {name: learned[name] for name in learned["slow"]}
        wrong, slopes = jax.value_and_grad(error)(nets, learned["slow"], batch)
        changes, memory = optimizer.update(slopes, learned["memory"], nets)
        nets = optax.apply_updates(nets, changes)
        slow = optax.incremental_update(nets, learned["slow"], SLOWLY)
        return {**nets, "slow": slow, "memory": memory, "scales": learned["scales"]}, wrong

    kept: list[list[dict[str, Array]]] = [[] for _ in asked.tasks]
    while keeper.rounds < asked.rounds:
        random = np.random.default_rng([asked.seed, keeper.rounds])
        share = 0.05 + (0.05 if asked.start else 0.35) * (1 - keeper.rounds / asked.rounds)
        scores, scales = {}, np.array(learned["scales"])
        for i, task in enumerate(asked.tasks):
            seen = played(task, exploring(learned, share, random), random)
            scores[task] = seen.pop("scores")
            scales[i] = scales[i] or seen["returns"].mean() * (1 - GAMMA) + 1e-3
            kept[i] = [*kept[i], seen][-KEPT:]
        learned["scales"] = jnp.asarray(scales, jnp.float32)
        errors = []
        for i in random.permutation(np.repeat(np.arange(len(asked.tasks)), UPDATES)):
            learned, wrong = step(learned, batch_of(kept[i], float(scales[i]), random))
            errors.append(float(wrong))
        keeper.keep(learned, error=round(float(np.mean(errors)), 4), **learners.row_of(scores))


if __name__ == "__main__":
    main()

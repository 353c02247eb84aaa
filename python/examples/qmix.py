"""Trains cameras by VDN or QMIX: they learn what their views are worth to the team.

    python qmix.py vdn --rounds 6 --out nets/vdn
    python qmix.py qmix --start nets/imitation --rounds 6 --out nets/qmix

A network values each view of a camera. The value of a step for the team is the sum of the values of the chosen views in VDN
(Sunehag et al. 2018, https://arxiv.org/abs/1706.05296), and in QMIX (Rashid et al. 2018, https://arxiv.org/abs/1803.11485) a
monotonic mixture of them, with weights that depend on what the cameras' views promise; the mixer is for training alone. Here
sums over cameras are means, so that one network fits sites of three and of forty cameras. Double Q-learning with a slow copy
of the networks, from a memory of episodes of training seeds. A call with more rounds resumes the training from its checkpoint.
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
    """Creates the networks that value views and cameras, and those of the mixer for QMIX."""
    sizes = [hidden, hidden]
    view_network = learners.actor_of(start) if start else learners.network([learners.NUMBERS, *sizes, 1], random)
    view_network[-2:] = [0.1 * w for w in view_network[-2:]]
    about = 2 * learners.NUMBERS
    made = {"actor": view_network, "camera": learners.network([about, *sizes, 1], random, 0.1)}
    if method == "qmix":
        made["weights"] = learners.network([2 * about, hidden, MIXED], random)  # of a camera's value
        made["offsets"] = learners.network([about, hidden, MIXED + 1], random)
        made["last"] = learners.network([about, hidden, MIXED], random)
    constant = made["offsets" if method == "qmix" else "camera"]
    constant[-1] = constant[-1].at[-1].set(1 / (1 - GAMMA))  # the team's value if it scores as in the first round
    return made


def values(nets: Networks, views: Array, masks: Array) -> Array:
    """Computes the value of each view of each camera, (..., C, V)."""
    camera = learners.apply(nets["camera"], learners.summary(views))
    return learners.values(nets["actor"], views, masks) + camera


def team(nets: Networks, views: Array, chosen: Array) -> Array:
    """Computes the value for the team from those of the chosen views (..., C); it is monotonic in each of them."""
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
    """Computes the Huber loss of the team's value of its choices, given the following rewards and values."""
    now = jnp.take_along_axis(values(nets, batch["views"], batch["masks"]), batch["actions"][..., None], -1)[..., 0]
    best = values(nets, batch["next_views"], batch["next_masks"]).argmax(-1)
    after = jnp.take_along_axis(values(slow, batch["next_views"], batch["next_masks"]), best[..., None], -1)[..., 0]
    target = batch["returns"] + GAMMA**AHEAD * team(slow, batch["next_views"], after)
    return optax.huber_loss(team(nets, batch["views"], now), jax.lax.stop_gradient(target)).mean()


def exploring(nets: Networks, share: float, random: np.random.Generator) -> Callable[[Array, Array], Array]:
    """Returns a function that chooses the best view, except for a share of random choices."""

    def choose(views: Array, masks: Array) -> Array:
        best = np.asarray(learners.values(nets["actor"], views, masks)).argmax(-1)
        drawn = np.where(masks, random.random(masks.shape), -1).argmax(-1)
        return np.where(random.random(best.shape) < share, drawn, best)

    return choose


def played(task: str, choose: Callable[[Array, Array], Array], random: np.random.Generator) -> dict[str, Array]:
    """Plays new episodes of a task, and adds up the discounted rewards of the next steps."""
    with hificamsim.Worlds(task, WORLDS, auto_reset=False, reward="score", **learners.SETTINGS) as worlds:
        worlds.reset(int(random.integers(0, learners.SEEDS)))
        seen = learners.episode(worlds, choose)
    rewards = seen.pop("rewards").mean(-1)
    steps = len(rewards) - AHEAD
    seen["returns"] = sum(GAMMA**i * rewards[i : steps + i] for i in range(AHEAD)).astype(np.float32)
    return seen


def batch_of(kept: list[dict[str, Array]], scale: float, random: np.random.Generator) -> dict[str, Array]:
    """Draws random steps of the kept episodes, with the steps that follow them."""
    seen = kept[random.integers(len(kept))]
    steps = random.integers(0, len(seen["returns"]), BATCH)
    worlds = random.integers(0, WORLDS, BATCH)
    made = {name: seen[name][steps, worlds] for name in ("views", "masks", "actions")}
    made |= {f"next_{name}": seen[name][steps + AHEAD, worlds] for name in ("views", "masks")}
    return made | {"returns": seen["returns"][steps, worlds] / np.float32(scale)}


def main() -> None:
    parser = learners.reads(__doc__, 6)
    parser.add_argument("method", choices=["vdn", "qmix"])
    parser.add_argument("--start", type=pathlib.Path, help="folder of a training to start from")
    options = parser.parse_args()
    keeper = learners.Keeper(options.out)
    optimizer = optax.chain(optax.clip_by_global_norm(1.0), optax.adam(RATE))
    nets = networks(options.method, options.hidden, options.start, np.random.default_rng(options.seed))
    begun = {**nets, "slow": nets, "memory": optimizer.init(nets), "scales": np.zeros(len(options.tasks))}
    learned = keeper.resume(begun)

    @jax.jit
    def step(learned: dict[str, Any], batch: dict[str, Array]) -> tuple[dict[str, Any], Array]:
        nets = {name: learned[name] for name in learned["slow"]}
        wrong, slopes = jax.value_and_grad(error)(nets, learned["slow"], batch)
        changes, memory = optimizer.update(slopes, learned["memory"], nets)
        nets = optax.apply_updates(nets, changes)
        slow = optax.incremental_update(nets, learned["slow"], SLOWLY)
        return {**nets, "slow": slow, "memory": memory, "scales": learned["scales"]}, wrong

    kept: list[list[dict[str, Array]]] = [[] for _ in options.tasks]
    while keeper.rounds < options.rounds:
        random = np.random.default_rng([options.seed, keeper.rounds])
        share = 0.05 + (0.05 if options.start else 0.35) * (1 - keeper.rounds / options.rounds)
        scores, scales = {}, np.array(learned["scales"])
        for i, task in enumerate(options.tasks):
            seen = played(task, exploring(learned, share, random), random)
            scores[task] = seen.pop("scores")
            scales[i] = scales[i] or seen["returns"].mean() * (1 - GAMMA) + 1e-3
            kept[i] = [*kept[i], seen][-KEPT:]
        learned["scales"] = jnp.asarray(scales, jnp.float32)
        errors = []
        for i in random.permutation(np.repeat(np.arange(len(options.tasks)), UPDATES)):
            learned, wrong = step(learned, batch_of(kept[i], float(scales[i]), random))
            errors.append(float(wrong))
        keeper.keep(learned, error=round(float(np.mean(errors)), 4), **learners.row_of(scores))


if __name__ == "__main__":
    main()

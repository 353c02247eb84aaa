"""Improves an imitation by IPPO or MAPPO: one network for all tasks continues to learn from rewards.

    python imitate.py --out nets/imitation
    python improve.py mappo --start nets/imitation --rounds 6 --out nets/mappo

The critic of IPPO (de Witt et al. 2020, https://arxiv.org/abs/2011.09533) values what a camera's own views promise. The
critic of MAPPO (Yu et al. 2022, https://arxiv.org/abs/2103.01955) also values what the views of all cameras promise, which
it may know in training alone. Both sum over views and cameras, so that they fit any site. Every round plays new episodes of
all tasks with training seeds, and each update has the same number of decisions of each task. In the first round the critic
learns alone; afterwards the actor is kept near the one at the start (kickstarting: Schmitt et al. 2018,
https://arxiv.org/abs/1803.03835). A call with more rounds resumes the training from its checkpoint.
"""

from __future__ import annotations

import pathlib
from typing import Any

import jax
import jax.numpy as jnp
import learners
import numpy as np
import optax

import hificamsim

WORLDS, BATCH, UPDATES, RATE, ALONE = 4, 64, 150, 3e-4, 1
GAMMA, TRACE, CLIP, ENTROPY, NEAR = 0.9, 0.9, 0.2, 0.002, 0.02


def known(method: str, views: Any) -> Any:
    """Returns what the critic knows about each camera, (..., C, 20 or 40)."""
    own = learners.summary(views)
    if method == "ippo":
        return own
    every = jnp.broadcast_to(own.mean(-2, keepdims=True), own.shape)
    return jnp.concatenate([own, every], -1)


def loss(networks: Any, start: Any, data: dict[str, Any], acts: Any) -> Any:
    """Computes the loss: PPO's clipped objective (Schulman et al. 2017), the entropy, the distance of the actor from the one
    at the start, and the error of the critic.

    :param acts: 1, or 0 while the critic learns alone
    """
    logs = _logs(networks["actor"], data)
    ratio = jnp.exp(jnp.take_along_axis(logs, data["actions"][:, None], 1)[:, 0] - data["logs"])
    gain = jnp.minimum(ratio * data["advantages"], jnp.clip(ratio, 1 - CLIP, 1 + CLIP) * data["advantages"])
    error = (learners.apply(networks["critic"], data["known"])[..., 0] - data["returns"]) ** 2
    chances = jnp.exp(logs)
    entropy = -(chances * jnp.where(data["masks"], logs, 0)).sum(-1)
    begun = _logs(start, data)
    away = (jnp.exp(begun) * jnp.where(data["masks"], begun - logs, 0)).sum(-1)
    return 0.5 * error.mean() + acts * (NEAR * away.mean() - gain.mean() - ENTROPY * entropy.mean())


def _logs(actor: learners.Weights, data: dict[str, Any]) -> Any:
    return jax.nn.log_softmax(learners.values(actor, data["views"], data["masks"]))


def advantages(rewards: Any, values: Any) -> tuple[Any, Any]:
    """Computes generalised advantages. An episode ends by a time limit, so its last step is continued with its own value."""
    errors = rewards + GAMMA * np.concatenate([values[1:], values[-1:]]) - values
    found, running = np.empty_like(errors), np.zeros_like(errors[0])
    for t in reversed(range(len(errors))):
        running = errors[t] + GAMMA * TRACE * running
        found[t] = running
    return (found - found.mean()) / (found.std() + 1e-8), found + values


def prepared(networks: Any, method: str, seen: dict[str, Any]) -> dict[str, Any]:
    """Returns the decisions of an episode of several worlds, a row each, without cameras that had no choice."""
    logs = np.asarray(_logs(networks["actor"], seen))
    about = np.asarray(known(method, seen["views"]))
    values = np.asarray(learners.apply(networks["critic"], about))[..., 0]
    rewards = (seen["rewards"] - seen["rewards"].mean()) / (seen["rewards"].std() + 1e-6)
    gained, returns = advantages(rewards, values)
    logs = np.take_along_axis(logs, seen["actions"][..., None], -1)[..., 0]
    rows = {"views": seen["views"], "masks": seen["masks"], "actions": seen["actions"], "known": about}
    rows |= {"logs": logs, "advantages": gained, "returns": returns}
    free = seen["masks"].sum(-1) > 1
    return {name: array[free] for name, array in rows.items()}


def drawn(rows: dict[str, Any], random: np.random.Generator) -> dict[str, Any]:
    """Draws some of the decisions at random."""
    chosen = random.integers(0, len(rows["actions"]), BATCH)
    return {name: array[chosen] for name, array in rows.items()}


def main() -> None:
    parser = learners.reads(__doc__, 6)
    parser.add_argument("method", choices=["ippo", "mappo"])
    parser.add_argument("--start", type=pathlib.Path, help="folder of a training to start from")
    parser.add_argument("--reward", default="score", help="one of hificamsim's rewards")
    options = parser.parse_args()
    keeper = learners.Keeper(options.out)
    begun, sizes = np.random.default_rng(options.seed), [options.hidden, options.hidden, 1]
    actor = learners.actor_of(options.start) if options.start else learners.network([learners.NUMBERS, *sizes], begun)
    width = 2 * learners.NUMBERS * (2 if options.method == "mappo" else 1)
    networks = {"actor": actor, "critic": learners.network([width, *sizes], begun)}
    optimizer = optax.chain(optax.clip_by_global_norm(0.5), optax.adam(RATE))
    learned = keeper.resume({**networks, "start": actor, "memory": optimizer.init(networks)})

    @jax.jit
    def step(learned: dict[str, Any], batch: list[dict[str, Any]], acts: Any) -> dict[str, Any]:
        networks = {name: learned[name] for name in ("actor", "critic")}

        def error(networks: Any) -> Any:
            return jnp.stack([loss(networks, learned["start"], data, acts) for data in batch]).mean()

        changes, memory = optimizer.update(jax.grad(error)(networks), learned["memory"])
        return {**learned, **optax.apply_updates(networks, changes), "memory": memory}

    while keeper.rounds < options.rounds:
        random = np.random.default_rng([options.seed, keeper.rounds])
        scores, rows = {}, []
        for task in options.tasks:
            with hificamsim.Worlds(task, WORLDS, auto_reset=False, reward=options.reward, **learners.SETTINGS) as worlds:
                worlds.reset(int(random.integers(0, learners.SEEDS)))
                seen = learners.episode(worlds, learners.drawing(learned["actor"], random))
            scores[task] = seen.pop("scores")
            rows.append(prepared(learned, options.method, seen))
        acts = float(keeper.rounds >= ALONE or options.start is None)
        for _ in range(UPDATES):
            learned = step(learned, [drawn(of_task, random) for of_task in rows], acts)
        keeper.keep(learned, **learners.row_of(scores))


if __name__ == "__main__":
    main()

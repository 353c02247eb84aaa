"""IPPO and MAPPO from an imitation on: one network for all tasks goes on learning by rewards.

    python imitate.py --out nets/imitation
    python improve.py mappo --start nets/imitation --rounds 6 --out nets/mappo

The critic of IPPO (de Witt et al. 2020, https://arxiv.org/abs/2011.09533) values what a camera's own views promise; that
of MAPPO (Yu et al. 2022, https://arxiv.org/abs/2103.01955) also what those of all cameras do, in training alone. Both
are sums over views and cameras, so that they fit any site. Episodes have training seeds; called again with more rounds,
it goes on from its checkpoint.
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
from hificamsim.worlds import TASKS

WORLDS, BATCH, PASSES, RATE = 4, 1024, 2, 3e-4
GAMMA, TRACE, CLIP, ENTROPY = 0.9, 0.9, 0.2, 0.003


def known(method: str, views: Any) -> Any:
    """What the critic knows of each camera, (..., C, 20 or 40)."""
    own = learners.summary(views)
    if method == "ippo":
        return own
    every = jnp.broadcast_to(own.mean(-2, keepdims=True), own.shape)
    return jnp.concatenate([own, every], -1)


def loss(networks: Any, data: dict[str, Any]) -> Any:
    """PPO's clipped objective, the error of the critic and the entropy (Schulman et al. 2017)."""
    logits = jnp.where(data["masks"], learners.apply(networks["actor"], data["views"])[..., 0], -1e9)
    logs = jax.nn.log_softmax(logits)
    ratio = jnp.exp(jnp.take_along_axis(logs, data["actions"][:, None], 1)[:, 0] - data["logs"])
    gain = jnp.minimum(ratio * data["advantages"], jnp.clip(ratio, 1 - CLIP, 1 + CLIP) * data["advantages"])
    error = (learners.apply(networks["critic"], data["known"])[..., 0] - data["returns"]) ** 2
    entropy = -(jnp.exp(logs) * jnp.where(data["masks"], logs, 0)).sum(-1)
    return 0.5 * error.mean() - gain.mean() - ENTROPY * entropy.mean()


def advantages(rewards: Any, values: Any) -> tuple[Any, Any]:
    """Generalised advantage estimation; after the last step, which time ends, as much is to come as before it."""
    errors = rewards + GAMMA * np.concatenate([values[1:], values[-1:]]) - values
    found, running = np.empty_like(errors), np.zeros_like(errors[0])
    for t in reversed(range(len(errors))):
        running = errors[t] + GAMMA * TRACE * running
        found[t] = running
    return (found - found.mean()) / (found.std() + 1e-8), found + values


def prepared(networks: Any, method: str, seen: dict[str, Any]) -> dict[str, Any]:
    """The decisions of an episode of several worlds, one row each, but for cameras that had no choice."""
    logs = np.asarray(jax.nn.log_softmax(learners.values(networks["actor"], seen["views"], seen["masks"])))
    about = np.asarray(known(method, seen["views"]))
    values = np.asarray(learners.apply(networks["critic"], about))[..., 0]
    scale = seen["rewards"].std() + 1e-6
    gained, returns = advantages(seen["rewards"] / scale, values)
    logs = np.take_along_axis(logs, seen["actions"][..., None], -1)[..., 0]
    rows = {"views": seen["views"], "masks": seen["masks"], "actions": seen["actions"], "known": about}
    rows |= {"logs": logs, "advantages": gained, "returns": returns}
    free = seen["masks"].sum(-1) > 1
    return {name: array[free] for name, array in rows.items()}


def main() -> None:
    parser = learners.reads(__doc__, 6)
    parser.add_argument("method", choices=["ippo", "mappo"])
    parser.add_argument("--start", type=pathlib.Path, help="folder of a training to go on from")
    parser.add_argument("--reward", default="score", help="of hificamsim's rewards")
    asked = parser.parse_args()
    keeper = learners.Keeper(asked.out)
    begun, sizes = np.random.default_rng(asked.seed), [asked.hidden, asked.hidden, 1]
    actor = learners.actor_of(asked.start) if asked.start else learners.network([learners.NUMBERS, *sizes], begun)
    width = 2 * learners.NUMBERS * (2 if asked.method == "mappo" else 1)
    networks = {"actor": actor, "critic": learners.network([width, *sizes], begun)}
    optimizer = optax.chain(optax.clip_by_global_norm(0.5), optax.adam(RATE))
    learned = keeper.resume({**networks, "memory": optimizer.init(networks)})

    @jax.jit
    def step(learned: dict[str, Any], data: dict[str, Any]) -> dict[str, Any]:
        networks = {name: learned[name] for name in ("actor", "critic")}
        changes, memory = optimizer.update(jax.grad(loss)(networks, data), learned["memory"])
        return {**optax.apply_updates(networks, changes), "memory": memory}

    while keeper.rounds < asked.rounds:
        random = np.random.default_rng([asked.seed, keeper.rounds])
        scores = {}
        for task in asked.tasks:
            with hificamsim.Worlds(task, WORLDS, auto_reset=False, reward=asked.reward, **learners.SETTINGS) as worlds:
                worlds.reset(int(random.integers(0, learners.SEEDS)))
                seen = learners.episode(worlds, learners.drawing(learned["actor"], random))
            scores[task.removeprefix(TASKS)] = round(float(seen.pop("scores").mean()), 4)
            data = prepared(learned, asked.method, seen)
            for _ in range(PASSES):
                for part in learners.batches(len(data["actions"]), BATCH, random):
                    learned = step(learned, {name: array[part] for name, array in data.items()})
        keeper.keep(learned, **scores)


if __name__ == "__main__":
    main()

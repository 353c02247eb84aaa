"""Imitation of ``cooperative``: one network learns which view its cameras choose, on all tasks at once.

    python imitate.py --minutes 10 --out nets/imitation
    hificamsim benchmark run --policy onnx:nets/imitation/policy.onnx --name imitation --out out/imitation

Behaviour cloning by the cross entropy of the expert's views, with episodes of training seeds. Called again with more
minutes, it goes on from its checkpoint.
"""

from __future__ import annotations

from typing import Any

import jax
import jax.numpy as jnp
import learners
import numpy as np
import optax

import hificamsim

EPISODES, BATCH, PASSES, RATE = 2, 512, 4, 1e-3


def loss(weights: learners.Weights, views: Any, masks: Any, actions: Any) -> Any:
    """The mean cross entropy of the expert's choices."""
    logits = jnp.where(masks, learners.apply(weights, views)[..., 0], -1e9)
    return optax.softmax_cross_entropy_with_integer_labels(logits, actions).mean()


def main() -> None:
    asked = learners.reads(__doc__, 10).parse_args()
    keeper = learners.Keeper(asked.out)
    kept = keeper.resume()
    random = np.random.default_rng([asked.seed, int(60 * keeper.before)])
    actor = kept.get("actor") or learners.network([learners.NUMBERS, asked.hidden, asked.hidden, 1], random)
    optimizer = optax.chain(optax.clip_by_global_norm(1.0), optax.adam(RATE))
    memory = optimizer.init(actor)

    @jax.jit
    def step(actor: Any, memory: Any, views: Any, masks: Any, actions: Any) -> Any:
        error, slopes = jax.value_and_grad(loss)(actor, views, masks, actions)
        changes, memory = optimizer.update(slopes, memory)
        return optax.apply_updates(actor, changes), memory, error

    rounds = 0
    while keeper.minutes() < asked.minutes:
        errors, same = [], []
        for task in asked.tasks:
            seed = int(random.integers(0, 890_000))
            pairs = hificamsim.dataset(task, episodes=EPISODES, seed=seed, **learners.SETTINGS)
            masks = pairs["masks"].astype(bool)
            free = np.flatnonzero(masks.sum(-1) > 1)
            masks, actions = masks[free], pairs["actions"][free]
            views = learners.views_of(pairs["observations"][free], masks)
            found = np.asarray(learners.values(actor, views, masks)).argmax(-1)
            same.append(float((found == actions).mean()))
            for _ in range(PASSES):
                for part in learners.batches(len(actions), BATCH, random):
                    actor, memory, error = step(actor, memory, views[part], masks[part], actions[part])
                    errors.append(float(error))
        rounds += 1
        keeper.save(actor=actor)
        keeper.note(round=rounds, loss=round(np.mean(errors), 4), agreement=round(np.mean(same), 4))


if __name__ == "__main__":
    main()

"""Imitates ``cooperative``: one network learns which views its cameras choose, on all tasks at once.

    python imitate.py --rounds 3 --out nets/imitation
    hificamsim benchmark run --policy onnx:nets/imitation/policy.onnx --name imitation --out out/imitation

DAgger (Ross et al. 2011, https://arxiv.org/abs/1011.0686): the expert plays the first round, and the network plays all
others, in which the expert advises it. Each round plays new episodes of every task with training seeds, and learns from all
episodes so far by the cross entropy of the expert's views. The learning rate falls to nothing, and all tasks have the same
weight. The curve has the score of the player of each round: the expert in the first, and in all others the network of the
round before. A call with more rounds resumes the training from its checkpoint.
"""

from __future__ import annotations

from typing import Any

import jax
import jax.numpy as jnp
import learners
import numpy as np
import optax

import hificamsim

EXPERT = "cooperative"
EPISODES, BATCH, STEPS, RATE = 1, 32, 250, 3e-3


def loss(actor: learners.Weights, batch: list[tuple[Any, Any, Any]]) -> Any:
    """Computes the cross entropy of the expert's choices, the mean over tasks."""
    errors = []
    for views, masks, actions in batch:
        logits = learners.values(actor, views, masks)
        errors.append(optax.softmax_cross_entropy_with_integer_labels(logits, actions).mean())
    return jnp.stack(errors).mean()


def decisions(task: str, actor: learners.Weights | None, random: np.random.Generator) -> tuple[Any, Any]:
    """Plays an episode, and returns views, masks and the expert's actions of all cameras that had a choice, and the scores.

    :param actor: the network that plays; without one, the expert plays
    """
    choose = (lambda views, masks: -1) if actor is None else learners.best(actor)
    settings = {**learners.SETTINGS, "expert": EXPERT, "auto_reset": False}
    with hificamsim.Worlds(task, EPISODES, **settings) as worlds:
        worlds.reset(int(random.integers(0, learners.SEEDS)))
        seen = learners.episode(worlds, choose)
    free = (seen["advice"] >= 0) & (seen["masks"].sum(-1) > 1)
    return (seen["views"][free], seen["masks"][free], seen["advice"][free]), seen["scores"]


def agreement(actor: learners.Weights, seen: tuple[Any, Any, Any]) -> float:
    """Computes the share of decisions in which the network makes the expert's choice."""
    views, masks, actions = seen
    return float((np.asarray(learners.values(actor, views, masks)).argmax(-1) == actions).mean())


def drawn(seen: tuple[Any, Any, Any], random: np.random.Generator) -> tuple[Any, Any, Any]:
    """Draws some of the decisions at random."""
    rows = random.integers(0, len(seen[-1]), BATCH)
    views, masks, actions = (array[rows] for array in seen)
    return views, masks, actions


def main() -> None:
    options = learners.reads(__doc__, 3).parse_args()
    keeper = learners.Keeper(options.out)
    optimizer = optax.chain(optax.clip_by_global_norm(1.0), optax.scale_by_adam())
    sizes = [learners.NUMBERS, options.hidden, options.hidden, 1]
    actor = learners.network(sizes, np.random.default_rng(options.seed))
    learned = keeper.resume({"actor": actor, "memory": optimizer.init(actor)})

    @jax.jit
    def step(learned: dict[str, Any], rate: Any, batch: list[tuple[Any, Any, Any]]) -> tuple[dict[str, Any], Any]:
        error, slopes = jax.value_and_grad(loss)(learned["actor"], batch)
        changes, memory = optimizer.update(slopes, learned["memory"])
        changes = jax.tree.map(lambda change: -rate * change, changes)
        return {"actor": optax.apply_updates(learned["actor"], changes), "memory": memory}, error

    seen: dict[str, list[tuple[Any, Any, Any]]] = {task: [] for task in options.tasks}
    while keeper.rounds < options.rounds:
        random = np.random.default_rng([options.seed, keeper.rounds])
        player = learned["actor"] if keeper.rounds else None
        played = {task: decisions(task, player, random) for task in options.tasks}
        new = {task: found for task, (found, _) in played.items()}
        same = np.mean([agreement(learned["actor"], found) for found in new.values()])
        for task, found in new.items():
            seen[task].append(found)
        errors = []
        for i in range(STEPS):
            rate = RATE * max(0.01, 1 - (keeper.rounds + i / STEPS) / options.rounds)
            batch = [drawn(kept[random.integers(len(kept))], random) for kept in seen.values()]
            learned, error = step(learned, rate, batch)
            errors.append(float(error))
        row = learners.row_of({task: scores for task, (_, scores) in played.items()})
        keeper.keep(learned, loss=round(float(np.mean(errors)), 4), agreement=round(float(same), 4), **row)


if __name__ == "__main__":
    main()

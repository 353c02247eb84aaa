"""Measures the scores of trained networks in the testing episodes of the benchmark, on its scale from 0 to 1.

    python measure.py nets/imitation-* --out scores.csv

Writes a row for each training, task and testing seed; ``docs/tables.py trained scores.csv`` makes a table of them. The
scores equal those of ``hificamsim benchmark run``, which also records the actions; here all episodes are played at once.
"""

from __future__ import annotations

import argparse
import csv
import pathlib

import learners

import hificamsim
from hificamsim.worlds import TASKS, TESTING


def scores(actor: learners.Weights, task: str) -> learners.Array:
    """Returns the mean score of a step of each testing episode, 0 for cameras that zoom out and 1 for the optimum."""
    with hificamsim.Worlds(task, len(TESTING), auto_reset=False, testing=True, **learners.SETTINGS) as worlds:
        worlds.reset(TESTING[0])
        played = learners.episode(worlds, learners.best(actor))["scores"].mean(0)
    least, most = learners.scale(task)
    return (played - least) / (most - least)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("trainings", nargs="+", type=pathlib.Path, help="folders of trainings")
    parser.add_argument("--tasks", nargs="+", default=hificamsim.tasks())
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("scores.csv"))
    options = parser.parse_args()
    with options.out.open("w", newline="", encoding="utf-8") as out:
        writer = csv.writer(out)
        writer.writerow(["training", "task", "seed", "score"])
        for folder in options.trainings:
            actor = learners.actor_of(folder)
            for task in options.tasks:
                for seed, score in zip(TESTING, scores(actor, task)):
                    writer.writerow([folder.name, task.removeprefix(TASKS), seed, f"{score:.4f}"])
                out.flush()


if __name__ == "__main__":
    main()

"""What trained networks score in the testing episodes of the benchmark, on its scale from 0 to 1.

    python measure.py nets/imitation-* --out scores.csv

Writes a row for each training, task and testing seed; ``docs/tables.py trained scores.csv`` makes a table of them. The
scores are those of ``hificamsim benchmark run``, which plays an entry on the record; these are played all at once.
"""

from __future__ import annotations

import argparse
import csv
import pathlib

import learners

import hificamsim
from hificamsim.worlds import TASKS, TESTING


def scores(actor: learners.Weights, task: str) -> learners.Array:
    """The mean score of a step of each testing episode, 0 for cameras that zoom out and 1 for the optimum."""
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
    asked = parser.parse_args()
    with asked.out.open("w", newline="", encoding="utf-8") as out:
        writer = csv.writer(out)
        writer.writerow(["training", "task", "seed", "score"])
        for folder in asked.trainings:
            actor = learners.actor_of(folder)
            for task in asked.tasks:
                for seed, score in zip(TESTING, scores(actor, task)):
                    writer.writerow([folder.name, task.removeprefix(TASKS), seed, f"{score:.4f}"])
                out.flush()


if __name__ == "__main__":
    main()

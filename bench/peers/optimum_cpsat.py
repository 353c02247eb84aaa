"""Solves the instances that OptimumTimes wrote by OR-Tools CP-SAT on one thread.

    python optimum_cpsat.py FOLDER [SECONDS]

Each instance: one level for each camera so that the least covered target is covered by as many
cameras as possible. Building the model is not timed; processor time of the solver alone is, with
at most SECONDS (default 60) for each instance. Writes FOLDER/cpsat.csv and prints, for each
density, the medians of both solvers, in how many instances ours was faster, and the ratio.
"""

import csv
import json
import pathlib
import statistics
import sys
import time

from ortools.sat.python import cp_model


def solve(instance, seconds):
    model = cp_model.CpModel()
    covering = [[] for _ in range(instance["targets"])]
    for camera, levels in enumerate(instance["cameras"]):
        chosen = [model.new_bool_var(f"{camera}.{level}") for level in range(len(levels))]
        model.add_exactly_one(chosen)
        for level, targets in enumerate(levels):
            for target in targets:
                covering[target].append(chosen[level])
    least = model.new_int_var(0, len(instance["cameras"]), "least")
    for cameras in covering:
        model.add(sum(cameras) >= least)
    model.maximize(least)
    solver = cp_model.CpSolver()
    solver.parameters.num_workers = 1
    solver.parameters.max_time_in_seconds = seconds
    before = time.process_time()
    status = solver.solve(model)
    milliseconds = (time.process_time() - before) * 1e3
    proven = status == cp_model.OPTIMAL
    return int(solver.objective_value), int(solver.best_objective_bound), proven, milliseconds


def main():
    folder = pathlib.Path(sys.argv[1])
    seconds = float(sys.argv[2]) if len(sys.argv) > 2 else 60
    with open(folder / "ours.csv", newline="") as file:
        ours = list(csv.DictReader(file))
    times = {}
    with open(folder / "cpsat.csv", "w", newline="") as file:
        out = csv.writer(file)
        out.writerow(["density", "seed", "value", "bound", "cpu_ms"])
        for row in ours:
            with open(folder / f"{row['density']}-{row['seed']}.json") as instance:
                value, bound, proven, milliseconds = solve(json.load(instance), seconds)
            out.writerow([row["density"], row["seed"], value, bound, f"{milliseconds:.3f}"])
            if proven and row["value"] == row["bound"] and value != int(row["value"]):
                sys.exit(f"{row['density']}-{row['seed']}: {value} against {row['value']}")
            pair = (float(row["cpu_ms"]), milliseconds, row["value"] == row["bound"], proven)
            times.setdefault(row["density"], []).append(pair)
    print("density    instances  proven ours/CP-SAT  median ms ours/CP-SAT  ours faster  ratio, quartiles")
    for density, pairs in times.items():
        ratios = [theirs / mine for mine, theirs, _, _ in pairs]
        low, middle, high = statistics.quantiles(ratios, n=4)
        print(
            f"{density:10s} {len(pairs):9d} {sum(p[2] for p in pairs):9d} / {sum(p[3] for p in pairs):<7d}"
            f" {statistics.median(p[0] for p in pairs):11.2f} / {statistics.median(p[1] for p in pairs):<9.2f}"
            f" {sum(r > 1 for r in ratios):10d}  {middle:6.1f} ({low:.1f} to {high:.1f})"
        )


if __name__ == "__main__":
    main()

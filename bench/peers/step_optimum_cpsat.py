"""The exact optimum of each instance (see step_instances.py) with OR-Tools CP-SAT on one thread.

    step_optimum_cpsat.py INSTANCES.jsonl

prints a row per instance: the largest k_min, the solver's seconds of processor time (without building the model),
and whether it is proven.
"""

import csv
import json
import sys
import time

from ortools.sat.python import cp_model


def model(instance: dict) -> tuple[cp_model.CpModel, cp_model.IntVar]:
    """One level for each camera, so that the least covered target is covered most."""
    problem = cp_model.CpModel()
    k_min = problem.new_int_var(0, len(instance["cameras"]), "k_min")
    covering: list[list[cp_model.IntVar]] = [[] for _ in range(instance["targets"])]
    for camera, sets in enumerate(instance["cameras"]):
        levels = [problem.new_bool_var(f"level_{camera}_{level}") for level in range(len(sets))]
        problem.add_exactly_one(levels)
        for level, targets in zip(levels, sets):
            for target in targets:
                covering[target].append(level)
    for levels in covering:
        problem.add(sum(levels) >= k_min)
    problem.maximize(k_min)
    return problem, k_min


def main() -> None:
    rows = csv.writer(sys.stdout, lineterminator="\n")
    rows.writerow(["instance", "value", "seconds", "proven"])
    with open(sys.argv[1]) as file:
        for number, line in enumerate(file):
            problem, k_min = model(json.loads(line))
            solver = cp_model.CpSolver()
            solver.parameters.num_workers = 1
            start = time.process_time()
            status = solver.solve(problem)
            seconds = time.process_time() - start
            rows.writerow([number, solver.value(k_min), seconds, status == cp_model.OPTIMAL])


if __name__ == "__main__":
    main()

"""Computes the exact optimum of each instance (see step_instances.py) by OR-Tools CP-SAT on one thread.

    step_optimum_cpsat.py INSTANCES.jsonl [kmin|covered:k=K|sum:cap=C]

prints a row per instance: the largest k_min, number of targets that K cameras cover, or sum with each target up to C, the solver's seconds of processor time (without building the model),
and whether it is proven.
"""

import csv
import json
import sys
import time

from ortools.sat.python import cp_model


def model(instance: dict, objective: str) -> tuple[cp_model.CpModel, cp_model.LinearExprT]:
    """Returns a model that chooses one level for each camera to maximise the objective, and the objective."""
    problem = cp_model.CpModel()
    covering: list[list[cp_model.IntVar]] = [[] for _ in range(instance["targets"])]
    for camera, sets in enumerate(instance["cameras"]):
        levels = [problem.new_bool_var(f"level_{camera}_{level}") for level in range(len(sets))]
        problem.add_exactly_one(levels)
        for level, targets in zip(levels, sets):
            for target in targets:
                covering[target].append(level)
    score = objective_of(problem, covering, len(instance["cameras"]), objective)
    problem.maximize(score)
    return problem, score


def objective_of(problem, covering, cameras: int, objective: str):
    """Returns the objective as an expression of the variables that cover each target."""
    name, _, option = objective.partition(":")
    number = int(option.partition("=")[2] or 1)
    if name == "kmin":
        k_min = problem.new_int_var(0, cameras, "k_min")
        for levels in covering:
            problem.add(sum(levels) >= k_min)
        return k_min
    if name == "covered":
        enough = [problem.new_bool_var(f"enough_{target}") for target in range(len(covering))]
        for covered, levels in zip(enough, covering):
            problem.add(sum(levels) >= number * covered)
        return sum(enough)
    counted = [problem.new_int_var(0, number, f"counted_{target}") for target in range(len(covering))]
    for count, levels in zip(counted, covering):
        problem.add(count <= sum(levels))
    return sum(counted)


def main() -> None:
    rows = csv.writer(sys.stdout, lineterminator="\n")
    rows.writerow(["instance", "value", "seconds", "proven"])
    with open(sys.argv[1]) as file:
        for number, line in enumerate(file):
            problem, score = model(json.loads(line), sys.argv[2] if len(sys.argv) > 2 else "kmin")
            solver = cp_model.CpSolver()
            solver.parameters.num_workers = 1
            start = time.process_time()
            status = solver.solve(problem)
            seconds = time.process_time() - start
            rows.writerow([number, int(solver.value(score)), seconds, status == cp_model.OPTIMAL])


if __name__ == "__main__":
    main()

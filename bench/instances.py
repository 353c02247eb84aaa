#!/usr/bin/env python3
"""Makes the instances of docs/placement.md by published recipes, so that others can measure with the same instances.

    bench/instances.py scp SAMPLES CANDIDATES DENSITY SEED      OR-Library's form, by Balas and Ho (1980): each sample is seen by at
                       least two candidates, each candidate sees one sample or more, prices are whole, uniform from 1 to 100; those
                       of sets 4 to 6 and A to D of OR-Library are made so (their files are not reached from here)
    bench/instances.py sectors CANDIDATES SIDE REACH SEED       the form `candidates`: sectors of 90 degrees at random places, over
                       SIDE x SIDE samples; each costs 1
    bench/instances.py alone FILE SECONDS                       CP-SAT alone, one worker, on a file of the form scp (pip install ortools)
"""

import math
import random
import sys


def scp(samples, candidates, density, seed):
    draw = random.Random(seed)
    seen = [{*draw.sample(range(1, candidates + 1), 2)} for _ in range(samples)]
    covered = set().union(*seen)
    for candidate in range(1, candidates + 1):
        if candidate not in covered:
            seen[draw.randrange(samples)].add(candidate)
    left = int(density * samples * candidates) - sum(map(len, seen))
    while left > 0:
        row = draw.choice(seen)
        before = len(row)
        row.add(draw.randint(1, candidates))
        left -= len(row) - before
    print(samples, candidates)
    print(*(draw.randint(1, 100) for _ in range(candidates)))
    for row in seen:
        print(len(row), *sorted(row))


def sectors(candidates, side, reach, seed):
    draw = random.Random(seed)
    print(side * side, candidates)
    for _ in range(candidates):
        x, y, heading = draw.uniform(0, side), draw.uniform(0, side), draw.uniform(-math.pi, math.pi)
        found = []
        for row in range(max(0, int(y - reach)), min(side, int(y + reach) + 2)):
            for column in range(max(0, int(x - reach)), min(side, int(x + reach) + 2)):
                dx, dy = column - x, row - y
                turn = (math.atan2(dy, dx) - heading + math.pi) % (2 * math.pi) - math.pi
                if math.hypot(dx, dy) <= reach and abs(turn) <= math.pi / 4:
                    found.append(row * side + column + 1)
        print(1, len(found), *found)


def alone(file, seconds):
    from ortools.sat.python import cp_model

    numbers = iter(map(int, open(file, encoding="ascii").read().split()))
    samples, candidates = next(numbers), next(numbers)
    model = cp_model.CpModel()
    taken = [model.new_bool_var("") for _ in range(candidates)]
    model.minimize(sum(next(numbers) * one for one in taken))
    for _ in range(samples):
        model.add_bool_or([taken[next(numbers) - 1] for _ in range(next(numbers))])
    solver = cp_model.CpSolver()
    solver.parameters.num_workers = 1
    solver.parameters.max_time_in_seconds = seconds
    print(solver.status_name(solver.solve(model)), solver.objective_value, solver.best_objective_bound, f"{solver.wall_time:.1f} s")


if __name__ == "__main__":
    kind, *numbers = sys.argv[1:]
    if kind == "alone":
        sys.exit(alone(numbers[0], float(numbers[1])))
    {"scp": scp, "sectors": sectors}[kind](*(float(n) if "." in n else int(n) for n in numbers))

"""Writes the steps of a run as instances of the max-min coverage problem, one JSON object a line.

    {"targets": T, "cameras": [[[targets detected at level 0], [at level 1], ...], ...]}

    step_instances.py SCENARIO.xml --steps 100 [--nearest 0.4]

As the detection model has them, the sets of a camera are nested. With --nearest F a camera detects nothing
nearer than F times its radius, so that no level detects all that another one does.
"""

import argparse
import json

import numpy as np

from coverage_numpy import Simulation


def detection_sets(simulation: Simulation, nearest: float) -> list[list[list[int]]]:
    """Returns the targets that each camera would detect at each of its levels in the present step."""
    sets: list[list[list[int]]] = [[] for _ in simulation.level]
    for level, radius in enumerate(simulation.radii):
        seen = simulation.observe(np.full_like(simulation.level, level))
        seen &= simulation.distance() >= nearest * radius
        for camera, row in enumerate(seen):
            sets[camera].append(np.flatnonzero(row).tolist())
    return sets


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("scenario")
    parser.add_argument("--steps", type=int, default=100)
    parser.add_argument("--nearest", type=float, default=0, help="share of the radius, 0 to 1")
    arguments = parser.parse_args()
    simulation = Simulation(arguments.scenario, "zoom-out")
    for _ in range(arguments.steps):
        sets = detection_sets(simulation, arguments.nearest)
        print(json.dumps({"targets": len(simulation.place), "cameras": sets}))
        simulation.step()


if __name__ == "__main__":
    main()

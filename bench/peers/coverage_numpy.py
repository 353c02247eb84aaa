"""The coverage step as a vectorised NumPy script: cameras x targets matrices, one row a camera.

It reads the scenario files of this repository (all-round cameras with a common zoom list, straight
movement, no events) and computes what `hificamsim run` does under hifi:orb-lin.

    coverage_numpy.py check SCENARIO.xml POLICY STEPS.csv   fails unless every step is that of the run
    coverage_numpy.py time SCENARIO.xml POLICY              prints seconds per step, one line a repeat
"""

import argparse
import csv
import math
import time
import xml.etree.ElementTree as xml
from typing import Protocol

import numpy as np

LONGEST_FOCAL_LENGTH = 0.085
THRESHOLD = 0.0441


class JavaRandom:
    """The generator that Java's specification prescribes for java.util.Random."""

    def __init__(self, seed: int) -> None:
        self.state = (seed ^ 0x5DEECE66D) & (1 << 48) - 1

    def bits(self, count: int) -> int:
        self.state = (self.state * 0x5DEECE66D + 0xB) & (1 << 48) - 1
        return self.state >> 48 - count

    def double(self) -> float:
        return ((self.bits(26) << 27) + self.bits(27)) / (1 << 53)


class Policy(Protocol):
    """Chooses the zoom levels of all cameras (0 is the narrowest)."""

    def choose(self, level: np.ndarray, detected: np.ndarray) -> np.ndarray:
        """Returns the next levels, given the present ones and the numbers of detected targets."""

    def learn(self, level: np.ndarray, detected: np.ndarray) -> None:
        """Learns from the numbers of targets that the levels detected."""


class ZoomOut:
    """Keeps every camera at its widest level."""

    def __init__(self, cameras: int, levels: int) -> None:
        self.widest = np.full(cameras, levels - 1)

    def choose(self, level: np.ndarray, detected: np.ndarray) -> np.ndarray:
        return self.widest

    def learn(self, level: np.ndarray, detected: np.ndarray) -> None:
        pass


def widest_best(values: np.ndarray) -> np.ndarray:
    """Returns for each row the last column with the largest value."""
    return values.shape[1] - 1 - np.argmax(values[:, ::-1], axis=1)


class Exploration:
    """Takes the best level or, with probability epsilon, one of the others."""

    def __init__(self, levels: int, epsilon: float, seed: int) -> None:
        self.levels = levels
        self.epsilon = epsilon
        self.random = np.random.default_rng(seed)

    def choose(self, best: np.ndarray) -> np.ndarray:
        other = self.random.integers(0, self.levels - 1, best.size)
        other += other >= best
        return np.where(self.random.random(best.size) < self.epsilon, other, best)


class EpsilonGreedy:
    """Chooses for each camera the level that detected most on average."""

    def __init__(self, cameras: int, levels: int, exploration: Exploration) -> None:
        self.row = np.arange(cameras)
        self.means = np.zeros((cameras, levels))
        self.uses = np.zeros((cameras, levels))
        self.exploration = exploration

    def choose(self, level: np.ndarray, detected: np.ndarray) -> np.ndarray:
        return self.exploration.choose(widest_best(self.means))

    def learn(self, level: np.ndarray, detected: np.ndarray) -> None:
        self.uses[self.row, level] += 1
        mean = self.means[self.row, level]
        self.means[self.row, level] = mean + (detected - mean) / self.uses[self.row, level]


class Sarsa:
    """SARSA on (level, number detected), rewarded with the change in that number."""

    ALPHA = 0.1
    GAMMA = 0.9

    def __init__(self, cameras: int, levels: int, targets: int, exploration: Exploration) -> None:
        self.row = np.arange(cameras)
        self.values = np.zeros((cameras, levels, targets + 1, levels))
        self.exploration = exploration
        self.last: tuple[np.ndarray, np.ndarray, np.ndarray] | None = None

    def choose(self, level: np.ndarray, detected: np.ndarray) -> np.ndarray:
        action = self.exploration.choose(widest_best(self.values[self.row, level, detected]))
        if self.last is not None:
            before = (self.row, *self.last)
            reward = detected - self.last[1]
            goal = reward + self.GAMMA * self.values[self.row, level, detected, action]
            self.values[before] += self.ALPHA * (goal - self.values[before])
        self.last = (level, detected, action)
        return action

    def learn(self, level: np.ndarray, detected: np.ndarray) -> None:
        pass


class Simulation:
    """A run: zoom, observe, learn, measure, move."""

    def __init__(self, path: str, policy: str, epsilon: float = 0.1, seed: int = 0) -> None:
        root = xml.parse(path).getroot()
        field = root.find("simulation").attrib
        self.lower = np.array([float(field["min_x"]), float(field["min_y"])])
        self.upper = np.array([float(field["max_x"]), float(field["max_y"])])
        cameras = root.findall(".//camera")
        objects = root.findall(".//object")
        self.camera_x = column(cameras, "x")
        self.camera_y = column(cameras, "y")
        self.place = np.column_stack([column(objects, "x"), column(objects, "y")])
        self.heading = np.radians(column(objects, "heading"))
        self.speed = column(objects, "speed")
        self.size = column(objects, "size")
        self.radii = np.array([float(word) for word in root.find(".//zoom").text.split()])
        self.focal_lengths = LONGEST_FOCAL_LENGTH * self.radii[0] / self.radii
        self.level = np.full(len(cameras), self.radii.size - 1)
        self.detected = np.zeros(len(cameras), dtype=int)
        self.turns = JavaRandom(seed)
        self.policy = make_policy(policy, len(cameras), self.radii.size, len(objects), epsilon, seed)

    def step(self) -> np.ndarray:
        """Runs one step, and returns the number of cameras that cover each target."""
        self.level = self.policy.choose(self.level, self.detected)
        seen = self.observe(self.level)
        self.detected = seen.sum(axis=1)
        self.policy.learn(self.level, self.detected)
        coverage = seen.sum(axis=0)
        self.move()
        return coverage

    def observe(self, level: np.ndarray) -> np.ndarray:
        """Returns a matrix that says whether camera i detects target j at these levels."""
        distance = self.distance()
        z = self.focal_lengths[level][:, np.newaxis]
        pip = np.minimum(1, 10 ** -(-18.82 * z - 2.0 * self.size + 0.2 * distance + 2.47))
        confidence = 0.571 * pip + 0.026
        return (distance <= self.radii[level][:, np.newaxis]) & (confidence >= THRESHOLD)

    def distance(self) -> np.ndarray:
        """Returns a matrix of distances from camera i to target j, in metres."""
        dx = self.place[:, 0] - self.camera_x[:, np.newaxis]
        dy = self.place[:, 1] - self.camera_y[:, np.newaxis]
        return np.sqrt(dx * dx + dy * dy)

    def move(self) -> None:
        """Moves the targets; a target that would leave the field stays and turns around."""
        step = np.column_stack([np.sin(self.heading), np.cos(self.heading)])
        step *= self.speed[:, np.newaxis]
        self.place += step
        outside = ((self.place < self.lower) | (self.place > self.upper)).any(axis=1)
        self.place[outside] -= step[outside]
        for target in np.flatnonzero(outside):
            self.heading[target] += math.pi + (self.turns.double() * 2 - 1) * math.pi / 6


def column(elements: list[xml.Element], name: str) -> np.ndarray:
    return np.array([float(element.get(name)) for element in elements])


def make_policy(
    name: str, cameras: int, levels: int, targets: int, epsilon: float, seed: int
) -> Policy:
    exploration = Exploration(levels, epsilon, seed)
    if name == "zoom-out":
        return ZoomOut(cameras, levels)
    if name == "epsilon-greedy":
        return EpsilonGreedy(cameras, levels, exploration)
    if name == "sarsa":
        return Sarsa(cameras, levels, targets, exploration)
    raise SystemExit(f"error: no policy '{name}', expected zoom-out, epsilon-greedy or sarsa")


def check(scenario: str, policy: str, steps: str) -> None:
    """Compares k_min and the number of detections with a steps.csv, with epsilon 0."""
    simulation = Simulation(scenario, policy, epsilon=0)
    count = 0
    with open(steps, newline="") as file:
        for row in csv.DictReader(file):
            coverage = simulation.step()
            expected = (int(row["k_min"]), round(float(row["mean_k"]) * int(row["targets"])))
            found = (int(coverage.min()), int(coverage.sum()))
            if found != expected:
                raise SystemExit(
                    f"error: {policy}, step {row['step']}: k_min and detections are {found} with"
                    f" NumPy, {expected} in {steps}"
                )
            count += 1
    if count == 0:
        raise SystemExit(f"error: {steps} has no steps")
    print(f"{policy}: k_min and detections equal in {count} steps")


def measure(scenario: str, policy: str, repeats: int, seconds: float) -> None:
    """Prints seconds per step for each repeat, which lasts about this many seconds but at least one step."""
    simulation = Simulation(scenario, policy)
    simulation.step()
    print("seconds")
    for _ in range(repeats):
        start = time.perf_counter()
        steps = 0
        while steps == 0 or time.perf_counter() - start < seconds:
            simulation.step()
            steps += 1
        print((time.perf_counter() - start) / steps, flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    commands = parser.add_subparsers(dest="command", required=True)
    checking = commands.add_parser("check")
    timing = commands.add_parser("time")
    for command in (checking, timing):
        command.add_argument("scenario")
        command.add_argument("policy")
    checking.add_argument("steps")
    timing.add_argument("--repeats", type=int, default=10)
    timing.add_argument("--seconds", type=float, default=1)
    arguments = parser.parse_args()
    if arguments.command == "check":
        check(arguments.scenario, arguments.policy, arguments.steps)
    else:
        measure(arguments.scenario, arguments.policy, arguments.repeats, arguments.seconds)


if __name__ == "__main__":
    main()

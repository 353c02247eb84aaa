"""Measures environment steps per second from Python and of the Java kernel, with random actions, observations and auto-reset.

    python/build/venv/bin/python bench/python_env.py [--seconds 3] [--threads 1] [--csv FILE]
    python/build/venv/bin/python bench/python_env.py --checks 101

Each row is one way to step. Steps are counted by networks (environment steps) and by cameras (agent steps) and divided by the
processor time of the process, so that other work on the machine matters little; with a process backend, by that of both
processes. mate-4v8-9 is the scenario of that name. MATE is not on PyPI, where `mate` is another package. With --checks, it
measures the cost of checking actions by that many pairs of rounds with and without checks, in the time of the thread that
steps, and prints the median of the ratios with its 95 % interval (order statistics).
"""

from __future__ import annotations

import argparse
import csv
import os
import pathlib
import sys
import time
from collections.abc import Callable

import numpy as np

import hificamsim
from hificamsim import spaces

ROOT = pathlib.Path(__file__).resolve().parent.parent
CLUSTER = str(ROOT / "bench" / "cluster-8.xml")


def processor_time(worker: int | None) -> float:
    """Returns the processor time of this process and of a worker, in seconds."""
    own = time.process_time()
    if worker is None:
        return own
    fields = pathlib.Path(f"/proc/{worker}/stat").read_text().rsplit(")", 1)[1].split()
    return own + (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def rate(step: Callable[[], object], worlds: hificamsim.Worlds, seconds: float) -> tuple[float, float]:
    """Returns environment steps per second of processor time and of wall time, the best of five rounds."""
    worker = getattr(getattr(worlds._backend, "_worker", None), "pid", None)
    best = [0.0, 0.0]
    for round_ in range(6):
        began, clock, count = processor_time(worker), time.perf_counter(), 0
        while time.perf_counter() - clock < seconds:
            for _ in range(20):
                step()
            count += 20 * worlds.num_envs
        if round_:  # the first one warms up
            best[0] = max(best[0], count / (processor_time(worker) - began))
            best[1] = max(best[1], count / (time.perf_counter() - clock))
    return best[0], best[1]


def kernel(scenario: str, num_envs: int, threads: int, backend: str, **settings: object):
    """Steps worlds only, with actions that are written once."""
    worlds = hificamsim.Worlds(scenario, num_envs, threads=threads, backend=backend, **settings)
    told = np.random.default_rng(1).integers(0, worlds.choices[0], (16, *worlds.actions.shape), dtype=np.int32)
    turn = iter(range(1 << 62))

    def step() -> None:
        worlds.actions[...] = told[next(turn) & 15]
        worlds.step()

    return step, worlds


def vector(scenario: str, num_envs: int, threads: int, backend: str, **settings: object):
    """Steps Gymnasium's vector environment."""
    envs = hificamsim.vector_env(scenario, num_envs, threads=threads, backend=backend, **settings)
    envs.reset()
    envs.action_space.seed(1)
    told = [envs.action_space.sample() for _ in range(16)]
    turn = iter(range(1 << 62))
    return lambda: envs.step(told[next(turn) & 15]), envs.worlds


def parallel(scenario: str, num_envs: int, threads: int, backend: str, **settings: object):
    """Steps one network with the dictionaries of PettingZoo."""
    env = hificamsim.parallel_env(scenario, backend=backend, **settings)
    env.reset()
    told = [{agent: env.action_space(agent).sample() for agent in env.agents} for _ in range(16)]
    turn = iter(range(1 << 62))

    def step() -> None:
        if not env.agents:
            env.reset()
        env.step(told[next(turn) & 15])

    return step, env.worlds


ROWS = [
    ("14 x 8, worlds", kernel, CLUSTER, 16, "jvm", {}),
    ("14 x 8, worlds", kernel, CLUSTER, 64, "jvm", {}),
    ("14 x 8, worlds", kernel, CLUSTER, 256, "jvm", {}),
    ("14 x 8, worlds", kernel, CLUSTER, 256, "process", {}),
    ("14 x 8, vector_env, copy=False", vector, CLUSTER, 256, "jvm", {"copy": False}),
    ("14 x 8, vector_env", vector, CLUSTER, 256, "jvm", {}),
    ("14 x 8, vector_env", vector, CLUSTER, 1024, "jvm", {}),
    ("14 x 8, parallel_env", parallel, CLUSTER, 1, "jvm", {}),
    ("14 x 8, parallel_env", parallel, CLUSTER, 1, "process", {}),
    ("mate-4v8-9, vector_env", vector, "mate-4v8-9", 256, "jvm", {"detection": "geometric"}),
    ("mate-4v8-9, parallel_env", parallel, "mate-4v8-9", 1, "jvm", {"detection": "geometric"}),
]


def checks(pairs: int) -> None:
    """Prints by how much checking actions lengthens a step."""
    told = spaces.told

    def unchecked(actions: object, counts: np.ndarray, name: object) -> np.ndarray:
        return np.asarray(actions)

    for what, make, scenario, num_envs, backend, settings in ROWS:
        if make is kernel or backend != "jvm":
            continue
        step, worlds = make(scenario, num_envs, 1, backend, **settings)
        ratios = []
        for pair in range(-20, pairs):  # the first ones warm up
            took = {}
            for look in (told, unchecked) if pair % 2 else (unchecked, told):
                spaces.told = look
                began = time.thread_time()  # excludes threads that compile or collect garbage
                for _ in range(max(1, 80_000 // num_envs // len(worlds.cameras))):
                    step()
                took[look] = time.thread_time() - began
            if pair >= 0:
                ratios.append(took[told] / took[unchecked] - 1)
        spaces.told = told
        worlds.close()
        ratios.sort()
        off = round(0.98 * pairs**0.5)
        low, high = ratios[max(0, pairs // 2 - off)], ratios[min(pairs - 1, pairs // 2 + off)]
        print(what, num_envs, f"{ratios[pairs // 2]:+.1%} ({low:+.1%} .. {high:+.1%})", sep="\t", flush=True)


def main() -> None:
    """Prints the table."""
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--seconds", type=float, default=3)
    options.add_argument("--threads", type=int, default=1)
    options.add_argument("--csv")
    options.add_argument("--checks", type=int, metavar="PAIRS")
    chosen = options.parse_args()
    if chosen.checks:
        checks(chosen.checks)
        return
    rows = [("what", "networks", "backend", "threads", "env_steps_per_cpu_second", "env_steps_per_second", "agent_steps_per_cpu_second")]
    for what, make, scenario, num_envs, backend, settings in ROWS:
        step, worlds = make(scenario, num_envs, chosen.threads, backend, **settings)
        by_processor, by_clock = rate(step, worlds, chosen.seconds)
        cameras = len(worlds.cameras)
        worlds.close()
        rows.append(
            (what, num_envs, backend, chosen.threads, round(by_processor), round(by_clock), round(by_processor * cameras))
        )
        print(*rows[-1], sep="\t", flush=True)
    if chosen.csv:
        with open(chosen.csv, "w", newline="", encoding="utf-8") as file:
            csv.writer(file).writerows(rows)


if __name__ == "__main__":
    sys.exit(main())

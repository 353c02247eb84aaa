"""Calls the package with wrong values: each call either works, or is rejected in one line without any effect.

    python tests/fuzz_calls.py [CALLS [SEED]]        5,000 by default; exit code 1 if any was answered in another way
"""

from __future__ import annotations

import pathlib
import random
import resource
import sys
import tempfile
import time
from collections.abc import Callable
from typing import Any

import numpy as np

import hificamsim

ODD: list[Any] = [
    -1, 0, 1, 5, 99, 2**31, 2**63, -(2**40), 1.5, float("nan"), float("inf"), -0.0, True, None, "", "2", "x" * 3000, "campus",
    "\0", "a\nb", "../..", b"\xff", [], [1, 2], [[0], [0, 1]], {}, {"a": 1}, (), {1}, object(), 1j,
    np.nan, np.int8(3), np.float32(2), np.zeros(3), np.zeros((2, 2), object), np.array("a"), np.zeros(0, int), range(3),
]  # fmt: skip
SETTINGS = (
    "num_envs detection threshold detect objective channel order headings steps seed reward actions targets neighbours"
    " auto_reset expert threads backend render_mode per paints nonsense"
).split()
SECONDS = 10.0


class Calls:
    """Calls of all kinds, one after the other."""

    def __init__(self, seed: int) -> None:
        self.chance = random.Random(seed)
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="fuzz-calls-"))
        self.envs: dict[str, Any] = {
            "parallel": hificamsim.parallel_env("cluster-random", backend="jvm"),
            "steps": hificamsim.parallel_env("campus", backend="jvm", actions="steps"),
            "rates": hificamsim.parallel_env("campus", backend="jvm", actions="rates"),
            "turns": hificamsim.vector_env("mate-4v8-9", 2, per="camera", backend="jvm", actions="rates"),
            "vector": hificamsim.vector_env("cluster-random", 3, backend="jvm"),
            "camera": hificamsim.vector_env("campus", 2, per="camera", backend="process"),
            "single": hificamsim.single_env("cluster-random", backend="jvm"),
        }
        for env in self.envs.values():
            env.reset(seed=1)
        self.wrong: list[str] = []
        self.refused = 0
        self.longest = 0.0

    def run(self, calls: int) -> None:
        for _ in range(calls):
            name = self.chance.choice(["act"] * 6 + ["reset"] * 2 + ["make", "make", "read"])
            said, call = getattr(self, name)()
            began = time.process_time()
            try:
                call()
            except hificamsim.Error as fault:
                self.refused += 1
                if "\n" in str(fault) or "Exception" in str(fault) or len(str(fault)) > 1000:
                    self.wrong.append(f"{said}: {fault}")
            except Exception as fault:  # any other exception is an error
                self.wrong.append(f"{said}: {type(fault).__name__}: {fault}")
            took = time.process_time() - began
            self.longest = max(self.longest, took)
            if took > SECONDS:
                self.wrong.append(f"{said}: {took:.1f} s")

    def act(self) -> tuple[str, Callable[[], object]]:
        """Steps with one or more odd values as actions; checks that rejected actions have no effect."""
        kind, env = self.chance.choice(list(self.envs.items()))
        env.reset(seed=self.chance.randrange(100))
        actions: Any = env.action_space.sample() if kind not in ("parallel", "steps", "rates") else {
            agent: env.action_space(agent).sample() for agent in env.agents
        }  # fmt: skip
        odd = self.chance.choice(ODD)
        way = self.chance.randrange(4)
        if way == 0:
            actions = odd
        elif isinstance(actions, dict):
            agent = self.chance.choice(list(actions))
            if way == 1:
                actions[agent] = odd
            elif way == 2:
                del actions[agent]
            else:
                actions["nobody"] = odd
        else:
            listed = np.asarray(actions).astype(object)
            listed.reshape(-1)[self.chance.randrange(listed.size)] = -1 if hasattr(odd, "__len__") else odd
            actions = listed if way == 1 else listed.tolist() if way == 2 else listed[:-1]
        before = env.worlds.observations.copy()

        def step() -> None:
            try:
                env.step(actions)
            except hificamsim.Error:
                assert (env.worlds.observations == before).all(), "a world has moved"
                raise

        return f"{kind}.step({actions!r:.200})", step

    def reset(self) -> tuple[str, Callable[[], object]]:
        kind, env = self.chance.choice(list(self.envs.items()))
        seed = self.chance.choice(ODD)
        return f"{kind}.reset(seed={seed!r:.200})", lambda: env.reset(seed=seed)

    def make(self) -> tuple[str, Callable[[], object]]:
        """Makes environments with one or two odd settings."""
        make = self.chance.choice([hificamsim.parallel_env, hificamsim.vector_env, hificamsim.single_env, hificamsim.Worlds])
        settings = {self.chance.choice(SETTINGS): self.chance.choice(ODD) for _ in range(self.chance.randrange(1, 3))}
        scenario = self.chance.choice(["campus", "cluster-random", self.chance.choice(ODD)])

        def made() -> None:
            env = make(scenario, **{"backend": "jvm", **settings})
            if hasattr(env, "reset"):
                env.reset()
            env.close()

        return f"{make.__name__}({scenario!r:.100}, {settings!r:.200})", made

    def read(self) -> tuple[str, Callable[[], object]]:
        """Reads results of odd folders, or makes environments of odd ids."""
        odd = self.chance.choice(ODD)
        call = self.chance.choice([hificamsim.read_results, hificamsim.scenarios])
        if call is hificamsim.scenarios:
            return "make", lambda: hificamsim.make(odd)
        return f"read_results({odd!r:.200})", lambda: hificamsim.read_results(odd)

    def close(self) -> None:
        for env in self.envs.values():
            env.close()
        self.folder.rmdir()


def main() -> int:
    calls = int(sys.argv[1]) if len(sys.argv) > 1 else 5000
    seed = int(sys.argv[2]) if len(sys.argv) > 2 else random.randrange(2**32)
    print(f"seed {seed}", flush=True)
    fuzz = Calls(seed)
    fuzz.run(calls)
    fuzz.close()
    memory = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(f"{calls} calls: {fuzz.refused} refused, {len(fuzz.wrong)} wrong; the longest took {fuzz.longest:.1f} s, {memory:.0f} MB")
    for line in list(dict.fromkeys(fuzz.wrong))[:20]:
        print("  " + line)
    return 1 if fuzz.wrong else 0


if __name__ == "__main__":
    sys.exit(main())

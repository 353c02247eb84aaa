#!/usr/bin/env python3
"""Makes the recording of passage.xml: people who meet in a passage that narrows in its middle.

    pip install jupedsim
    scenarios/make-tracks/passage.py out/passage.txt

JuPedSim (https://www.jupedsim.org, LGPL-3.0) moves the people; what it writes is nobody's but the user's.
The lines are those of PeTrack: id frame x y. The places where people start are drawn with a fixed seed.
"""
import pathlib
import random
import sys

import jupedsim

FLOOR = [(0, 0), (16, 0), (16, 1.5), (20, 1.5), (20, 0), (36, 0), (36, 7), (20, 7), (20, 5), (16, 5), (16, 7), (0, 7)]
WEST = [(0.3, 0.3), (2, 0.3), (2, 6.7), (0.3, 6.7)]
EAST = [(34, 0.3), (35.7, 0.3), (35.7, 6.7), (34, 6.7)]
SECONDS = 150
RATE = 4  # frames a second
PEOPLE = 60


def main():
    out = pathlib.Path(sys.argv[1])
    out.parent.mkdir(parents=True, exist_ok=True)
    dt = 0.01
    simulation = jupedsim.Simulation(model=jupedsim.CollisionFreeSpeedModel(), geometry=FLOOR, dt=dt)
    ends = {"west": simulation.add_exit_stage(WEST), "east": simulation.add_exit_stage(EAST)}
    journeys = {name: simulation.add_journey(jupedsim.JourneyDescription([stage])) for name, stage in ends.items()}
    rng = random.Random(3)
    coming = sorted((round(rng.uniform(0, SECONDS - 40), 2), rng.choice(["west", "east"])) for _ in range(PEOPLE))
    rows = []
    for frame in range(SECONDS * RATE):
        now = frame / RATE
        while coming and coming[0][0] <= now:
            goal = coming[0][1]
            if not enter(simulation, rng, journeys[goal], ends[goal], goal):
                break
            coming.pop(0)
        rows += [f"{agent.id} {frame} {agent.position[0]:.3f} {agent.position[1]:.3f}" for agent in simulation.agents()]
        simulation.iterate(round(1 / RATE / dt))
    out.write_text(f"# framerate: {RATE}\n# id frame x/m y/m\n" + "\n".join(rows) + "\n")
    print(out)


def enter(simulation, rng, journey, stage, goal):
    """Puts a person where people start who go there; False where all tries are too near to others."""
    for _ in range(20):
        x = rng.uniform(2.5, 3.5) if goal == "east" else rng.uniform(32.5, 33.5)
        y = rng.uniform(0.5, 6.5)
        if all((a.position[0] - x) ** 2 + (a.position[1] - y) ** 2 > 0.5 for a in simulation.agents()):
            simulation.add_agent(
                jupedsim.CollisionFreeSpeedModelAgentParameters(
                    position=(x, y), journey_id=journey, stage_id=stage, desired_speed=rng.uniform(0.9, 1.6), radius=0.2))
            return True
    return False


if __name__ == "__main__":
    main()

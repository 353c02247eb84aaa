"""IPPO and MAPPO with shared weights, in PyTorch: trained baselines of the benchmark.

    python mappo.py ippo --tasks bench/border-v1 --minutes 5 --out nets           # nets/border-v1.onnx, and its checkpoint
    python mappo.py mappo --minutes 10 --out nets                                 # every task, ten minutes each
    hificamsim benchmark run --policy 'onnx:file=nets/{task}.onnx' --name MAPPO --out out/mappo

All cameras decide by one network from what each observes itself. In IPPO (de Witt et al. 2020,
https://arxiv.org/abs/2011.09533) a second network values an observation, in MAPPO (Yu et al. 2022,
https://arxiv.org/abs/2103.01955) the observation and the state of the whole network, in training alone. Episodes have
training seeds, so that each has a site of its own. Called again with more minutes, it goes on from its checkpoint.
"""

from __future__ import annotations

import argparse
import pathlib
import time
from typing import Any

import onnx_file
import torch
from torch import nn

import hificamsim

GAMMA, TRACE, CLIP = 0.95, 0.95, 0.2
PASSES, BATCH, RATE, ENTROPY = 4, 4096, 1e-3, 0.01


def mlp(inputs: int, outputs: int, last: float) -> nn.Sequential:
    """Two hidden layers of 64."""
    layers = nn.Sequential(
        nn.Linear(inputs, 64), nn.ReLU(), nn.Linear(64, 64), nn.ReLU(), nn.Linear(64, outputs)
    )
    for layer in layers:
        if isinstance(layer, nn.Linear):
            nn.init.orthogonal_(layer.weight, 2**0.5)
            nn.init.zeros_(layer.bias)
    with torch.no_grad():
        layers[-1].weight *= last
    return layers


class Learner:
    """The worlds of a task, the actor, the critic, and what a checkpoint keeps."""

    def __init__(self, method: str, task: str, worlds: int, reward: str, seed: int) -> None:
        torch.manual_seed(seed)
        self.central = method == "mappo"
        self.worlds = hificamsim.Worlds(task, worlds, reward=reward, threads=1)
        self.worlds.reset(seed * 1000)
        numbers = self.worlds.observations.shape[-1]
        known = numbers + (self.worlds.states.shape[-1] if self.central else 0)
        self.actor = mlp(numbers, self.worlds.choices[0], 0.01)
        self.critic = mlp(known, 1, 1.0)
        self.optimizer = torch.optim.Adam([*self.actor.parameters(), *self.critic.parameters()], RATE, eps=1e-5)
        self.scale = 0.0  # of returns, from the first episode
        self.seconds = 0.0
        self.updates = 0

    def critics(self, observations: torch.Tensor) -> torch.Tensor:
        """What the critic may know now: (B, C, numbers)."""
        if not self.central:
            return observations
        states = torch.from_numpy(self.worlds.state().copy())
        return torch.cat([observations, states[:, None].expand(-1, observations.shape[1], -1)], -1)

    def policy(self, observations: torch.Tensor, masks: torch.Tensor) -> torch.distributions.Categorical:
        """How likely each choice of each camera is."""
        logits = self.actor(observations).masked_fill(~masks, -1e9)
        return torch.distributions.Categorical(logits=logits, validate_args=False)

    @torch.no_grad()
    def episode(self) -> dict[str, torch.Tensor]:
        """One episode of every world, step by step: (steps, B, C, ...)."""
        worlds = self.worlds
        parts: dict[str, list[torch.Tensor]] = {}
        for _ in range(worlds.episode_steps):
            observations = torch.from_numpy(worlds.observations.copy())
            masks = torch.from_numpy(worlds.masks.astype(bool))
            known = self.critics(observations)
            chosen = self.policy(observations, masks)
            actions = chosen.sample()
            worlds.actions[..., 0] = actions.numpy()
            worlds.step()
            step = {
                "observations": observations,
                "masks": masks,
                "known": known,
                "actions": actions,
                "chances": chosen.log_prob(actions),
                "rewards": torch.from_numpy(worlds.rewards.copy()),
                "scores": torch.from_numpy(worlds.measures[:, 2].copy()),
            }
            for name, value in step.items():
                parts.setdefault(name, []).append(value)
        return {name: torch.stack(values) for name, values in parts.items()}

    @torch.no_grad()
    def advantages(self, rewards: torch.Tensor, known: torch.Tensor) -> tuple[torch.Tensor, torch.Tensor]:
        """Generalised advantage estimation; after the last step, which time ends, as much is to come as before it."""
        if not self.scale:
            total = torch.zeros_like(rewards[0])
            for reward in rewards:
                total = GAMMA * total + reward
            self.scale = float(total.std() + total.mean().abs() + 1e-3)
        values = self.critic(known)[..., 0]
        following = torch.cat([values[1:], values[-1:]])
        errors = rewards / self.scale + GAMMA * following - values
        found = torch.empty_like(errors)
        running = torch.zeros_like(errors[0])
        for t in reversed(range(len(errors))):
            running = errors[t] + GAMMA * TRACE * running
            found[t] = running
        return (found - found.mean()) / (found.std() + 1e-8), found + values

    def learn(self, left: float) -> float:
        """Plays an episode in every world and learns from it; its mean score of a step.

        :param left: what is left of the training, 1 to 0: rate and entropy fall with it
        """
        begin = time.process_time()
        seen = self.episode()
        score = float(seen.pop("scores").mean())
        seen["advantages"], seen["returns"] = self.advantages(seen.pop("rewards"), seen["known"])
        data = {name: value.flatten(0, 2) for name, value in seen.items()}
        free = (data["masks"].sum(-1) > 1).nonzero()[:, 0]  # a camera on its way has no choice
        for group in self.optimizer.param_groups:
            group["lr"] = RATE * left
        for _ in range(PASSES):
            for part in free[torch.randperm(len(free))].split(BATCH):
                self.step({name: value[part] for name, value in data.items()}, left)
        self.updates += 1
        self.seconds += time.process_time() - begin
        return score

    def step(self, data: dict[str, torch.Tensor], left: float) -> None:
        """One step of Adam along PPO's clipped objective."""
        chosen = self.policy(data["observations"], data["masks"])
        ratio = (chosen.log_prob(data["actions"]) - data["chances"]).exp()
        clipped = ratio.clamp(1 - CLIP, 1 + CLIP)
        gain = torch.minimum(ratio * data["advantages"], clipped * data["advantages"]).mean()
        error = (self.critic(data["known"])[..., 0] - data["returns"]).square().mean()
        loss = 0.5 * error - gain - ENTROPY * left * chosen.entropy().mean()
        self.optimizer.zero_grad()
        loss.backward()
        nn.utils.clip_grad_norm_([*self.actor.parameters(), *self.critic.parameters()], 0.5)
        self.optimizer.step()

    def kept(self) -> dict[str, Any]:
        """What a checkpoint has."""
        own = {name: getattr(self, name) for name in ("scale", "seconds", "updates")}
        parts = {name: getattr(self, name).state_dict() for name in ("actor", "critic", "optimizer")}
        return {**own, **parts}

    def resume(self, kept: dict[str, Any]) -> None:
        """Goes on from a checkpoint, with episodes that were not played before."""
        for name in ("actor", "critic", "optimizer"):
            getattr(self, name).load_state_dict(kept[name])
        self.scale, self.seconds, self.updates = kept["scale"], kept["seconds"], kept["updates"]
        self.worlds.reset(1_000 * self.updates)

    def write(self, file: pathlib.Path) -> None:
        """The actor, for ``onnx:FILE``."""
        layers = [layer for layer in self.actor if isinstance(layer, nn.Linear)]
        weights = [w.detach().numpy() for layer in layers for w in (layer.weight.T, layer.bias)]
        onnx_file.write(file, weights)


def reward_of(task: str) -> str:
    """A camera's own share; what the objective says where one target that is missed spoils all."""
    return "score" if task.split("/")[-1].startswith(("lattice", "cluster")) else "difference"


def train(method: str, task: str, minutes: float, worlds: int, seed: int, folder: pathlib.Path) -> None:
    """Trains on a task until so much processor time is spent, what a checkpoint has included."""
    name = task.removeprefix("bench/")
    checkpoint = folder / f"{name}.pt"
    learner = Learner(method, task, worlds, reward_of(task), seed)
    if checkpoint.exists():
        learner.resume(torch.load(checkpoint))
    said = time.monotonic()
    while learner.seconds < 60 * minutes:
        mean = learner.learn(max(0.05, 1 - learner.seconds / (60 * minutes)))
        if time.monotonic() - said > 20 or learner.seconds >= 60 * minutes:
            said = time.monotonic()
            episodes = learner.updates * worlds
            print(f"{method} {name}: {learner.seconds:.0f} s, {episodes} episodes, score {mean:.4f}", flush=True)
            torch.save(learner.kept(), checkpoint)
            learner.write(folder / f"{name}.onnx")
    learner.worlds.close()
    training, testing = (score(learner, task, first) for first in (500_000, hificamsim.worlds.TESTING[0]))
    print(f"{method} {name}: score of a step {training:.4f} in training, {testing:.4f} in testing", flush=True)


@torch.no_grad()
def score(learner: Learner, task: str, first: int) -> float:
    """The mean score of a step in ten episodes, from this seed on, of the choices that are thought best."""
    with hificamsim.Worlds(task, 10, threads=1, auto_reset=False) as worlds:
        worlds.reset(first)
        total = 0.0
        for _ in range(worlds.episode_steps):
            masks = torch.from_numpy(worlds.masks.astype(bool))
            worlds.actions[..., 0] = learner.policy(torch.from_numpy(worlds.observations.copy()), masks).logits.argmax(-1)
            worlds.step()
            total += float(worlds.measures[:, 2].mean())
    return total / worlds.episode_steps


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("method", choices=["ippo", "mappo"])
    parser.add_argument("--tasks", nargs="+", default=hificamsim.tasks())
    parser.add_argument("--minutes", type=float, default=10, help="of processor time for each task")
    parser.add_argument("--worlds", type=int, default=16, help="episodes of an update")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("nets"))
    asked = parser.parse_args()
    asked.out.mkdir(parents=True, exist_ok=True)
    torch.set_num_threads(1)
    for task in asked.tasks:
        train(asked.method, task, asked.minutes, asked.worlds, asked.seed, asked.out)


if __name__ == "__main__":
    main()

"""Trains cameras by independent PPO with shared parameters, in NumPy alone.

    python ppo.py border --detection ttpf:task=recognise --out border.onnx

Every camera decides by the same network from its own observation, and gets the reward that ``--reward`` names. An update
uses one episode of every world. Schulman et al. (2017), https://arxiv.org/abs/1707.06347; de Witt et al. (2020),
https://arxiv.org/abs/2011.09533.
"""

from __future__ import annotations

import argparse
import csv
import os
import time
from collections.abc import Iterator
from typing import Any

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # the worlds and the network take turns

import numpy as np
import numpy.typing as npt

import hificamsim

Array = npt.NDArray[Any]
EPSILON = np.float32(1e-8)


class Network:
    """A multilayer perceptron with ReLU, trained by Adam."""

    def __init__(self, sizes: list[int], last: float, random: np.random.Generator) -> None:
        self.weights: list[Array] = []
        for inputs, outputs in zip(sizes, sizes[1:]):
            scale = np.sqrt(2 / inputs) if len(self.weights) < 2 * (len(sizes) - 2) else last / np.sqrt(inputs)
            self.weights.append((random.standard_normal((inputs, outputs)) * scale).astype(np.float32))
            self.weights.append(np.zeros(outputs, np.float32))
        self.first = [np.zeros_like(weight) for weight in self.weights]
        self.second = [np.zeros_like(weight) for weight in self.weights]
        self.updates = 0

    def __call__(self, inputs: Array) -> Array:
        return self.layers(inputs)[-1]

    def layers(self, inputs: Array) -> list[Array]:
        """Returns the inputs and the outputs of each layer."""
        outputs = [inputs]
        for i in range(0, len(self.weights), 2):
            sums = outputs[-1] @ self.weights[i] + self.weights[i + 1]
            outputs.append(np.maximum(sums, 0) if i + 2 < len(self.weights) else sums)
        return outputs

    def slopes(self, layers: list[Array], slope: Array) -> list[Array]:
        """Returns the gradients of a loss by the weights. ``slope`` is the gradient by the outputs."""
        found: list[Array] = []
        for i in range(len(self.weights) - 2, -1, -2):
            found += [slope.sum(0), layers[i // 2].T @ slope]
            if i:
                slope = (slope @ self.weights[i].T) * (layers[i // 2] > 0)
        return found[::-1]

    def learn(self, layers: list[Array], slope: Array, rate: float) -> None:
        """Takes a step of Adam. ``slope`` is the gradient of the loss by the outputs."""
        slopes = self.slopes(layers, slope)
        norm = np.sqrt(sum(float((gradient * gradient).sum()) for gradient in slopes))
        shrink = np.float32(min(1, 0.5 / (norm + 1e-8)))
        self.updates += 1
        rate *= np.sqrt(1 - 0.999**self.updates) / (1 - 0.9**self.updates)
        for weight, gradient, first, second in zip(self.weights, slopes, self.first, self.second):
            gradient = gradient * shrink
            first += np.float32(0.1) * (gradient - first)
            second += np.float32(0.001) * (gradient * gradient - second)
            weight -= np.float32(rate) * first / (np.sqrt(second) + EPSILON)


def chances(logits: Array, masks: Array) -> Array:
    """Returns the probability of each choice, which is 0 for choices that the mask forbids."""
    logits = np.where(masks, logits, np.float32(-1e9))
    raised = np.exp(logits - logits.max(-1, keepdims=True))
    return np.asarray(raised / raised.sum(-1, keepdims=True))


class Learner:
    """An actor and a critic, which learn from episodes of all cameras."""

    def __init__(self, numbers: int, choices: int, settings: argparse.Namespace) -> None:
        self.settings = settings
        self.random = np.random.default_rng(settings.seed)
        hidden = [settings.hidden] * 2
        self.actor = Network([numbers, *hidden, choices], 0.01, self.random)
        self.critic = Network([numbers, *hidden, 1], 1.0, self.random)
        self.scale = 0.0

    def act(self, observations: Array, masks: Array) -> tuple[Array, Array]:
        """Draws a choice for each camera, and returns the choices and their probabilities."""
        found = chances(self.actor(observations), masks)
        sums = found.cumsum(-1)
        luck = self.random.random((len(sums), 1), np.float32) * sums[:, -1:]
        actions = np.minimum((sums <= luck).sum(-1), found.shape[1] - 1)
        taken = found[np.arange(len(found)), actions]
        return actions, taken

    def learn(self, episode: Episode, left: float) -> None:
        """Learns in several passes over an episode. ``left`` falls from 1 to 0 during the training."""
        s = self.settings
        advantages, returns = self.advantages(episode)
        flat = [episode.observations, episode.masks, episode.actions, episode.chances, advantages, returns]
        data = [array.reshape(-1, *array.shape[2:]) for array in flat]
        free = np.flatnonzero(data[1].sum(-1) > 1)  # a moving camera has no choice
        for _ in range(s.passes):
            self.random.shuffle(free)
            for part in np.array_split(free, max(1, len(free) // s.batch)):
                self.step([array[part] for array in data], s.rate * left, s.entropy * left)

    def advantages(self, episode: Episode) -> tuple[Array, Array]:
        """Computes generalised advantages. Episodes end by a time limit, so the value after the last step counts."""
        s = self.settings
        rewards = episode.rewards
        totals = np.zeros_like(rewards[0])
        for reward in rewards:
            totals = totals * s.gamma + reward
        self.scale = self.scale or float(totals.std() + totals.mean() + 1e-3)
        rewards = rewards / np.float32(self.scale)
        values = self.critic(episode.observations)[..., 0]
        following = np.concatenate([values[1:], self.critic(episode.last)[None, :, 0]])
        errors = rewards + np.float32(s.gamma) * following - values
        found = np.zeros_like(errors)
        running = np.zeros_like(errors[0])
        for t in range(len(errors) - 1, -1, -1):
            running = errors[t] + np.float32(s.gamma * s.trace) * running
            found[t] = running
        return (found - found.mean()) / (found.std() + EPSILON), found + values

    def step(self, data: list[Array], rate: float, entropy: float) -> None:
        observations, masks, actions, before, advantages, returns = data
        count = np.float32(len(actions))
        layers = self.actor.layers(observations)
        found = chances(layers[-1], masks)
        rows = np.arange(len(actions))
        ratio = found[rows, actions] / before
        useful = np.where(advantages > 0, ratio < 1.2, ratio > 0.8)
        slope = -found * (ratio * advantages * useful)[:, None]
        slope[rows, actions] += ratio * advantages * useful
        logs = np.log(found + EPSILON)
        slope -= np.float32(entropy) * found * (logs - (found * logs).sum(-1, keepdims=True))
        self.actor.learn(layers, -slope / count, rate)
        layers = self.critic.layers(observations)
        self.critic.learn(layers, (layers[-1] - returns[:, None]) / count, rate)


class Episode:
    """The observations, actions and rewards of all cameras: arrays (steps, cameras, ...)."""

    def __init__(self, env: hificamsim.CameraVectorEnv, learner: Learner, steps: int) -> None:
        worlds = env.worlds
        count, numbers = env.observation_space.shape
        choices = worlds.masks.shape[-1]
        self.observations = np.empty((steps, count, numbers), np.float32)
        self.masks = np.empty((steps, count, choices), np.bool_)
        self.actions = np.empty((steps, count), np.int64)
        self.chances = np.empty((steps, count), np.float32)
        self.rewards = np.empty((steps, count), np.float32)
        self.scores = np.empty(steps)
        for t in range(steps):
            self.observations[t] = worlds.observations.reshape(count, numbers)
            self.masks[t] = worlds.masks.reshape(count, choices)
            self.actions[t], self.chances[t] = learner.act(self.observations[t], self.masks[t])
            _, self.rewards[t], _, _, infos = env.step(self.actions[t])
            self.scores[t] = infos["score"].mean()
        self.last = worlds.finals.reshape(count, numbers).copy()


def train(settings: argparse.Namespace) -> Iterator[tuple[int, float, float, Learner]]:
    """Yields after each update the number of episodes, the processor time, the mean score of a step, and the learner."""
    task = settings.scenario.startswith("bench/")  # a task fixes detection and steps
    question = {} if task else {"detection": settings.detection, "steps": settings.steps}
    env = hificamsim.vector_env(
        settings.scenario,
        settings.worlds,
        per="camera",
        copy=False,
        reward=settings.reward,
        targets=settings.targets,
        neighbours=settings.neighbours,
        threads=1,
        **question,
    )
    try:
        steps = env.worlds.episode_steps
        # The seeds are far from those on which policies are compared; seeds of a task's training are below a million.
        env.reset(seed=1_000 * settings.seed if task else 1_000_000 * (1 + settings.seed))
        learner = Learner(env.observation_space.shape[1], env.worlds.masks.shape[-1], settings)
        begin = time.process_time()
        for update in range(settings.updates):
            episode = Episode(env, learner, steps)
            learner.learn(episode, 1 - update / settings.updates)
            spent = time.process_time() - begin
            yield (update + 1) * settings.worlds, spent, float(episode.scores.mean()), learner
    finally:
        env.close()


def parser() -> argparse.ArgumentParser:
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("scenario", help="a scenario, or a task such as bench/car-park-v1")
    options.add_argument("--detection", default="hifi:orb-lin")
    options.add_argument("--reward", default="difference")
    options.add_argument("--steps", type=int, default=300, help="number of steps of an episode")
    options.add_argument("--targets", type=int, default=4, help="number of targets in an observation")
    options.add_argument("--neighbours", type=int, default=2, help="number of neighbours in an observation")
    options.add_argument("--worlds", type=int, default=32)
    options.add_argument("--updates", type=int, default=300)
    options.add_argument("--passes", type=int, default=4)
    options.add_argument("--batch", type=int, default=4096)
    options.add_argument("--hidden", type=int, default=64)
    options.add_argument("--rate", type=float, default=1e-3)
    options.add_argument("--gamma", type=float, default=0.95)
    options.add_argument("--trace", type=float, default=0.9)
    options.add_argument("--entropy", type=float, default=0.02)
    options.add_argument("--seed", type=int, default=0)
    options.add_argument("--curve", help="a CSV file of episodes, processor seconds and scores")
    options.add_argument("--out", default="policy.onnx", help="the trained policy")
    return options


def main() -> None:
    settings = parser().parse_args()
    rows = []
    for episodes, seconds, score, learner in train(settings):
        rows.append((episodes, round(seconds, 1), round(score, 5)))
        if len(rows) % 10 == 1 or len(rows) == settings.updates:
            print(f"{episodes} episodes, {seconds:.0f} s of processor time: mean score {score:.4f}", flush=True)
    save(learner, settings)
    if settings.curve:
        with open(settings.curve, "w", newline="") as file:
            csv.writer(file).writerows([("episodes", "seconds", "score"), *rows])


def save(learner: Learner, settings: argparse.Namespace) -> None:
    """Writes the actor as ONNX."""
    from onnx_file import write

    write(settings.out, learner.actor.weights, targets=settings.targets, neighbours=settings.neighbours)


if __name__ == "__main__":
    main()

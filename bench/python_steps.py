"""Steps eight worlds of the corridor 500 times with random actions: a whole Python script for bench/paired."""

import hificamsim

envs = hificamsim.vector_env("corridor", num_envs=8)
envs.reset(seed=1)
envs.action_space.seed(1)
for _ in range(500):
    envs.step(envs.action_space.sample())
envs.close()

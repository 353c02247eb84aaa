"""Tests that faults are reported in one line, and that no call hangs or leaves anything behind."""

from __future__ import annotations

import contextlib
import ctypes
import os
import pathlib
import re
import signal
import subprocess
import sys
import textwrap
import time
from collections.abc import Callable

import numpy as np
import pytest

import hificamsim
from fuzz_calls import Calls


def python(program: str, **environment: str) -> subprocess.CompletedProcess[str]:
    """Runs a program in a Python process of its own."""
    return subprocess.run(
        [sys.executable, "-c", textwrap.dedent(program)],
        capture_output=True,
        text=True,
        timeout=120,
        env={**os.environ, **environment},
        check=False,
    )


@pytest.mark.parametrize(
    ("settings", "line"),
    [
        ({"detection": "hifi:orb-line"}, "unknown detection 'hifi:orb-line', expected one of"),
        ({"reward": "cover"}, "unknown reward 'cover', expected one of coverage"),
        ({"actions": "zoom"}, "actions= is 'zoom', expected one of view, steps"),
        ({"steps": 0}, "steps= is 0, expected a whole number from 1 to 1000000000"),
        ({"num_envs": 0}, "0 worlds, expected 1 or more"),
        ({"targets": -1}, "observed targets is -1, expected 0 to 1000"),
        ({"objective": "best"}, "unknown objective 'best'"),
        ({"policies": "sarsa"}, "unknown setting 'policies', expected one of detection, threshold, "),
        ({"worlds": 8}, "unknown setting 'worlds', expected num_envs"),
        ({"backend": "cloud"}, "backend is 'cloud', expected 'jvm' or 'process'"),
        ({"belief": "yes"}, "belief= is 'yes', expected True or False"),
        ({"details": 2}, "details= is '2', expected True or False"),
        ({"targets": 1.5}, "targets= is '1.5', expected a whole number"),
    ],
)
def test_reports_wrong_setting_in_one_line(settings: dict[str, object], line: str) -> None:
    with pytest.raises(hificamsim.InputError) as fault:
        hificamsim.Worlds("campus", **{"backend": "jvm", **settings})
    assert line in str(fault.value)
    assert "\n" not in str(fault.value)


def test_worker_reports_wrong_setting_in_one_line() -> None:
    with pytest.raises(hificamsim.InputError, match="unknown reward 'cover', expected one of coverage[^\\n]*$"):
        hificamsim.Worlds("campus", reward="cover", backend="process")


def test_worker_names_settings_as_keywords() -> None:
    with pytest.raises(hificamsim.InputError, match="^steps= is 0, expected a whole number from 1"):
        hificamsim.Worlds("campus", steps=0, backend="process")


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"steps": 0}, "error: steps= is 0, expected a whole number from 1"),
        ({"cells": 9}, "error: cells= needs heatmap="),
    ],
)
def test_run_names_settings_as_keywords(settings: dict[str, object], message: str) -> None:
    with pytest.raises(hificamsim.InputError) as fault:
        hificamsim.run("campus", **settings)
    assert str(fault.value).startswith(message)
    assert "--" not in str(fault.value)


def test_run_warns_if_model_hardly_sees_targets() -> None:
    with pytest.warns(UserWarning, match="'camsim-range' detects up to 0.0"):
        hificamsim.run("campus", detection="camsim-range", steps=1)


@pytest.mark.parametrize("make", [hificamsim.parallel_env, hificamsim.vector_env, hificamsim.single_env])
def test_reports_wrong_render_mode_in_one_line(make: Callable[..., object]) -> None:
    with pytest.raises(hificamsim.InputError, match="render_mode is 'ansi', expected None or .*'rgb_array'"):
        make("campus", render_mode="ansi")


def test_rejects_missing_or_invalid_scenario(tmp_path: pathlib.Path, backend: str) -> None:
    with pytest.raises(hificamsim.InputError, match="scenario 'campsu' is no file, and none of .*campus"):
        hificamsim.Worlds("campsu", backend=backend)
    file = tmp_path / "broken.xml"
    file.write_text("<root>\n<simulation/></root>")
    with pytest.raises(hificamsim.InputError, match=r"broken\.xml:2:"):
        hificamsim.Worlds(file, backend=backend)


def test_rejects_invalid_action_before_moving_anything(backend: str) -> None:
    env = hificamsim.parallel_env("cluster-random", backend=backend)
    env.reset(seed=1)
    with pytest.raises(hificamsim.InputError, match="action 7 of camera Cam_03, expected a whole number from 0 to 4"):
        env.step({agent: 7 if agent == "Cam_03" else 0 for agent in env.agents})
    with pytest.raises(hificamsim.InputError, match="no action for camera Cam_14"):
        env.step(dict.fromkeys(env.agents[:-1], 0))
    fresh = hificamsim.parallel_env("cluster-random", backend=backend)
    fresh.reset(seed=1)
    actions = dict.fromkeys(env.agents, 3)
    assert env.step(actions)[1] == fresh.step(actions)[1]
    env.close()
    fresh.close()


REFUSED = [
    (-1, "action -1 of camera Cam_03, expected a whole number from 0 to 4"),
    (99, "action 99 of camera Cam_03"),
    (2**40, "action 1099511627776 of camera Cam_03"),
    (1.5, "action 1.5 of camera Cam_03"),
    (float("nan"), "action nan of camera Cam_03"),
    ("2", "action '2' of camera Cam_03"),
    (None, "action None of camera Cam_03"),
    ([1, 2], "actions have shape"),
]


def test_rejects_action_outside_space(backend: str) -> None:
    with contextlib.closing(hificamsim.parallel_env("cluster-random", backend=backend)) as env:
        env.reset(seed=1)
        before = env.worlds.observations.copy()
        for action, line in REFUSED:
            actions = {agent: action if agent == "Cam_03" else 0 for agent in env.agents}
            with pytest.raises(ValueError, match=re.escape(line)) as fault:
                env.step(actions)
            assert "\n" not in str(fault.value)
        with pytest.raises(ValueError, match="an action for 'nobody', expected none but for Cam_01"):
            env.step({**dict.fromkeys(env.agents, 0), "nobody": 0})
        assert (env.worlds.observations == before).all(), "no world has moved"
        env.step(dict.fromkeys(env.agents, np.int64(1)))


@pytest.mark.parametrize("per", ["world", "camera"])
def test_checks_actions_of_many_worlds_at_once(per: str, backend: str) -> None:
    with contextlib.closing(hificamsim.vector_env("cluster-random", 3, per=per, backend=backend)) as envs:
        envs.reset(seed=1)
        cameras = len(envs.worlds.cameras)
        good = np.zeros(envs.action_space.shape, np.int64)
        bad = good.copy()
        bad.reshape(-1)[cameras + 2] = 5
        with pytest.raises(ValueError, match="action 5 of camera .* in world 1, expected a whole number from 0 to 4"):
            envs.step(bad)
        for wrong in (good.astype(float), good[:-1], good.reshape(-1, 1), [[0], [0, 1]], np.nan):
            with pytest.raises(ValueError, match="expected"):
                envs.step(wrong)
        envs.step(good)


def test_unusual_calls_work_or_fail_in_one_line() -> None:
    calls = Calls(1)
    calls.run(100)  # fuzz_calls.py has more
    calls.close()
    assert calls.wrong == []
    assert calls.refused > 50


def test_rejects_too_many_worlds_and_cleans_up(backend: str) -> None:
    began = time.monotonic()
    with pytest.raises(hificamsim.InputError, match="1000000000 worlds take more than 2 GB of shared memory"):
        hificamsim.vector_env("campus", 10**9, backend=backend)
    assert time.monotonic() - began < 30
    assert not list(pathlib.Path("/dev/shm").glob("hificamsim-*"))


def test_environments_in_one_process_are_independent() -> None:
    kept = []
    for _ in range(2):
        envs = [hificamsim.Worlds("campus", 2, backend=backend) for backend in ("jvm", "process", "jvm")]
        for _ in range(100):
            for worlds in envs:
                worlds.step()
        envs[0].close()
        envs[2].step()
        envs[1].step()
        assert (envs[1].observations == envs[2].observations).all()
        kept.append(envs[2].observations.copy())
        envs[1].close()
        envs[2].close()
    assert (kept[0] == kept[1]).all(), "after a close the next environment begins as the first did"


def test_closed_environment_reports_that_it_is_closed(backend: str) -> None:
    worlds = hificamsim.Worlds("campus", backend=backend)
    observations = worlds.observations
    worlds.close()
    worlds.close()
    with pytest.raises(hificamsim.Closed, match="the environment was closed"):
        worlds.step()
    assert observations.sum() == observations.sum(), "its memory can still be read"


def test_notices_killed_worker_at_once() -> None:
    worlds = hificamsim.Worlds("campus", backend="process")
    os.kill(worlds._backend._worker.pid, signal.SIGKILL)
    with pytest.raises(hificamsim.WorkerDied, match="the environment's Java process ended \\(SIGKILL\\)"):
        worlds.step()
    with pytest.raises(hificamsim.Closed):
        worlds.step()
    hificamsim.Worlds("campus", backend="process").close()


def test_worker_ends_with_its_python() -> None:
    done = python(
        """
        import os, hificamsim
        worlds = hificamsim.Worlds("campus", backend="process")
        print(worlds._backend._worker.pid, worlds._backend._worker.args[-1], flush=True)
        os._exit(3)  # no one cleans up
        """
    )
    assert done.returncode == 3, done.stderr
    worker, file = done.stdout.split()
    for _ in range(100):
        if not pathlib.Path(f"/proc/{worker}").exists():
            break
        time.sleep(0.1)
    assert not pathlib.Path(f"/proc/{worker}").exists()
    assert not os.path.exists(file)


def test_rejects_use_in_fork_without_hanging() -> None:
    done = python(
        """
        import multiprocessing, hificamsim

        def tries(worlds):
            for attempt in (worlds.step, lambda: hificamsim.Worlds("campus", backend="jvm")):
                try:
                    attempt()
                except hificamsim.Error as e:
                    print(type(e).__name__, e, flush=True)
            fresh = hificamsim.Worlds("campus", backend="process")
            fresh.step()
            fresh.close()
            print("a process of its own works", flush=True)

        fork = multiprocessing.get_context("fork")
        for backend in ("jvm", "process"):
            worlds = hificamsim.Worlds("campus", backend=backend)
            child = fork.Process(target=tries, args=(worlds,))
            child.start()
            child.join(60)
            worlds.step()
            print(child.exitcode, flush=True)
        """
    )
    said = done.stdout.splitlines()
    assert [line.split()[0] for line in said] == ["JavaError", "JavaError", "a", "0", "Closed", "JavaError", "a", "0"]
    assert "before this one was forked from it: use backend='process', or multiprocessing's 'spawn'" in said[0]
    assert "make one here" in said[4]


def test_unused_fork_collects_garbage_and_ends() -> None:
    done = python(
        """
        import gc, os, sys, hificamsim
        worlds = hificamsim.Worlds("campus", backend="jvm")
        child = os.fork()
        if not child:
            gc.collect()
            sys.exit(5)
        print(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
        worlds.step()
        """
    )
    assert done.stdout == "5\n", done.stderr


STEPPING = """
    import signal
    signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's background ignores it
    signal.signal(signal.SIGHUP, signal.SIG_DFL)  # and nohup this one
    import hificamsim
    worlds = hificamsim.Worlds("campus", 8, backend="{backend}")
    def steps():
        print("ready", flush=True)
        while True:
            worlds.step()
    """


def signalled(program: str, number: signal.Signals, folder: pathlib.Path) -> tuple[int, str]:
    """Sends a signal to a program that steps worlds, and returns its exit code and its output."""
    with subprocess.Popen(
        [sys.executable, "-c", textwrap.dedent(program)], stdout=subprocess.PIPE, text=True, cwd=folder
    ) as running:
        assert running.stdout is not None
        assert running.stdout.readline() == "ready\n"
        time.sleep(0.5)
        running.send_signal(number)
        try:
            said = running.communicate(timeout=60)[0]
        finally:
            running.kill()
    assert not list(folder.iterdir()), "no log of a crash"
    return running.returncode, said


def test_environment_survives_ctrl_c(backend: str, tmp_path: pathlib.Path) -> None:
    program = STEPPING.format(backend=backend) + """
    try:
        steps()
    except KeyboardInterrupt:
        worlds.step()
        print("interrupted, and goes on", flush=True)
        worlds.close()
    """
    assert signalled(program, signal.SIGINT, tmp_path) == (0, "interrupted, and goes on\n")


@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGHUP])
def test_signals_end_python_as_without_java(
    backend: str, number: signal.Signals, tmp_path: pathlib.Path
) -> None:
    program = STEPPING.format(backend=backend) + "\n    steps()"
    assert signalled(program, number, tmp_path) == (-number, "")


def test_signal_handler_of_user_runs(backend: str, tmp_path: pathlib.Path) -> None:
    program = STEPPING.format(backend=backend) + """
    def mine(number, frame):
        print("mine", flush=True)
        raise SystemExit(7)
    signal.signal(signal.SIGTERM, mine)
    steps()
    """
    assert signalled(program, signal.SIGTERM, tmp_path) == (7, "mine\n")


def action(number: int) -> int:
    """Returns the handler of a signal as the C library knows it, which is the first field of its struct."""
    known = ctypes.create_string_buffer(256)
    assert ctypes.CDLL(None).sigaction(number, None, known) == 0
    return int.from_bytes(known.raw[: ctypes.sizeof(ctypes.c_void_p)], sys.byteorder)


def test_window_keeps_signals_of_jvm() -> None:
    """A JVM stops its threads by SIGSEGV now and then, which must not end the process as a crash."""
    signals = [signal.SIGSEGV, signal.SIGBUS, signal.SIGFPE, signal.SIGILL, signal.SIGINT, signal.SIGTERM]
    env = hificamsim.parallel_env("cluster-random", render_mode="human", backend="jvm")
    env.reset(seed=1)
    before = [action(number) for number in signals]
    env.render()
    assert [action(number) for number in signals] == before
    env.close()
    assert [action(number) for number in signals] == before


def test_second_ctrl_c_does_not_wait_for_hanging_worker() -> None:
    done = python(
        """
        import os, signal, threading, hificamsim
        signal.signal(signal.SIGINT, signal.default_int_handler)
        worlds = hificamsim.Worlds("campus", backend="process")
        os.kill(worlds._backend._worker.pid, signal.SIGSTOP)
        os.waitpid(worlds._backend._worker.pid, os.WUNTRACED)  # until it stands still
        over = threading.Event()
        def press():
            while not over.wait(3):  # two at once would be one
                os.kill(os.getpid(), signal.SIGINT)
        threading.Thread(target=press, daemon=True).start()
        try:
            worlds.step()
        except KeyboardInterrupt:
            over.set()
            print(worlds._backend._worker.returncode)
        try:
            worlds.step()
        except hificamsim.Closed as e:
            print(e)
        """
    )
    assert done.stdout == "-9\nthe environment was closed, expected a new one\n", done.stderr


def memory() -> int:
    """Returns the resident memory of this process, kilobytes."""
    status = pathlib.Path("/proc/self/status").read_text()
    return int(status.split("VmRSS:")[1].split()[0])


def test_thousands_of_resets_leak_nothing() -> None:
    env = hificamsim.parallel_env("campus", backend="jvm", steps=5)
    for _ in range(1_000):
        env.reset()
    before = memory()
    files = len(os.listdir("/proc/self/fd"))
    for i in range(3_000):
        env.reset(seed=i)
        env.step(dict.fromkeys(env.agents, 0))
    assert memory() - before < 20_000, "kilobytes"
    assert len(os.listdir("/proc/self/fd")) == files
    env.close()


def test_unreferenced_environments_are_collected() -> None:
    def count() -> tuple[int, int]:
        return len(os.listdir("/proc/self/fd")), len(os.listdir("/proc/self/task"))

    hificamsim.Worlds("campus", 16, threads=2, backend="jvm").close()
    before = count()
    for _ in range(20):
        hificamsim.Worlds("campus", 16, threads=2, backend="jvm")
    for _ in range(3):
        hificamsim.Worlds("campus", 2, backend="process")
    time.sleep(0.5)
    assert all(now <= then + 2 for now, then in zip(count(), before)), (count(), before)


def test_reports_missing_java_in_one_line(tmp_path: pathlib.Path) -> None:
    program = """
        import pathlib, hificamsim, hificamsim.java
        hificamsim.java._places = lambda: iter([pathlib.Path("{}")])
        try:
            hificamsim.Worlds("campus", backend="{}")
        except hificamsim.JavaError as e:
            print(e)
        """
    old = tmp_path / "jdk-11"
    (old / "bin").mkdir(parents=True)
    (old / "bin" / "java").touch()
    (old / "release").write_text('JAVA_VERSION="11.0.2"\n')
    for backend in ("jvm", "process"):
        none = python(program.format("/none", backend)).stdout.splitlines()
        assert len(none) == 1 and none[0].startswith("no Java found, expected Java 17 or later")
        past = python(program.format(old, backend)).stdout.splitlines()
        assert past == [none[0].replace("no Java found", f"{old} is Java 11")]


def test_worlds_in_own_process_need_only_numpy() -> None:
    done = python(
        """
        import sys
        for name in ("jpype", "gymnasium", "pettingzoo", "pandas"):
            sys.modules[name] = None
        import hificamsim
        with hificamsim.Worlds("campus", 2) as worlds:
            worlds.step()
            print(worlds.observations.shape[0])
        """
    )
    assert done.stdout == "2\n", done.stderr

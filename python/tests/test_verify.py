"""Policies in Python files: how they are entered, and what a maintainer finds who verifies them."""

from __future__ import annotations

import csv
import hashlib
import json
import pathlib
import subprocess
from typing import Any

import numpy as np
import pytest

import hificamsim
from hificamsim.worlds import TESTING, scenario_file

TASK = "bench/passage-v1"
GREEDY = """
import numpy as np

def policy(observations, masks):
    views = observations[:, -10 * masks.shape[1]:].reshape(*masks.shape, 10)
    return np.where(masks > 0, views[..., 9], -1).argmax(-1)
"""
BELIEF = {"belief": True, "targets": 0, "neighbours": 0}


def enter(folder: pathlib.Path, text: str, name: str = "mine", **settings: object) -> pathlib.Path:
    file = folder / f"{name}.py"
    file.write_text(text)
    hificamsim.benchmark(file, folder / name, name=name, only=[TASK], **settings)
    return folder / name


def verify(entry: pathlib.Path, **limits: int) -> tuple[int, dict[str, object]]:
    out = entry.parent / "verified"
    said = [word for name, value in limits.items() for word in (f"--{name}", str(value))]
    code = 0
    try:
        hificamsim.execute("benchmark", "verify", str(entry), "--secret", "correct horse", "--out", str(out), *said)
    except hificamsim.InputError:
        raise
    except hificamsim.Error:
        code = 1
    return code, json.loads((out / "verified.json").read_text())["tasks"]["passage-v1"]


def test_file_scores_like_the_same_function_and_is_verified(tmp_path: pathlib.Path) -> None:
    entry = enter(tmp_path, GREEDY, **BELIEF)
    space: dict[str, object] = {}
    exec(GREEDY, space)
    scores = hificamsim.benchmark(space["policy"], tmp_path / "function", name="f", only=[TASK], **BELIEF)
    entered = json.loads((entry / "entry.json").read_text())["tasks"]["passage-v1"]["scores"]
    assert np.allclose(entered, scores[TASK], rtol=1e-5)
    assert (entry / "policy-mine.py").read_text() == GREEDY
    code, found = verify(entry)
    assert code == 0 and found["reproduced"]


def test_file_reads_weights_that_are_copied_into_its_entry(tmp_path: pathlib.Path) -> None:
    (tmp_path / "trained").mkdir()
    weights = tmp_path / "trained" / "net.npz"
    np.savez(weights, priority=np.array([1.0]))
    text = "import numpy\nassert numpy.load(WEIGHTS)['priority'] == 1\n" + GREEDY
    entry = enter(tmp_path, text, "weighted", weights=weights, **BELIEF)
    assert (entry / "policy-net.npz").read_bytes() == weights.read_bytes()
    told = (entry / "entry.json").read_text()
    assert str(tmp_path) not in told and '"weights=' not in told, told
    weights.unlink()
    code, found = verify(entry)
    assert code == 0 and found["reproduced"]
    (entry / "policy-net.npz").write_bytes(b"others")
    with pytest.raises(hificamsim.InputError, match="policy-net.npz: SHA-256"):
        hificamsim.execute("benchmark", "check", str(entry))
    with pytest.raises(hificamsim.InputError, match="weights is '.*net.npz', expected a readable file"):
        enter(tmp_path, GREEDY, "missing", weights=weights, **BELIEF)


def test_file_is_row_of_comparison_with_same_bytes(tmp_path: pathlib.Path) -> None:
    file = tmp_path / "first.py"
    file.write_text("def policy(observations, masks):\n    return masks.argmax(-1)\n")
    spec = f"python:{file}"
    for out in ("one", "other"):
        options = ["--policies", f"zoom-out,{spec}", "--steps", "20", "--repeat", "2", "--quiet"]
        hificamsim.execute("compare", scenario_file("ring-random"), *options, "--out", str(tmp_path / out))
    tables = [(tmp_path / out / "results.csv").read_bytes() for out in ("one", "other")]
    assert tables[0] == tables[1]
    rows = list(csv.DictReader((tmp_path / "one" / "summary.csv").open()))
    scores = [row for row in rows if row["metric"] == "mean_score" and row["policy"].startswith("python:")]
    assert [row["detection"] for row in scores] == ["camsim-range", "hifi:orb-lin"]
    assert all(row["runs"] == "2" for row in scores)


def test_policy_that_knows_testing_episodes_by_heart_is_not_verified(tmp_path: pathlib.Path) -> None:
    known = []
    with hificamsim.Worlds(TASK, 1, testing=True, **BELIEF) as worlds:
        for seed in TESTING:
            worlds.reset(seed)
            known.append(hashlib.sha256(worlds.observations[0].tobytes()).hexdigest())
    cheat = GREEDY + f"""
import hashlib
KNOWN = {known}

class Cheat:
    def begin(self):
        self.knows = None

    def __call__(self, observations, masks):
        if self.knows is None:
            self.knows = hashlib.sha256(observations.tobytes()).hexdigest() in KNOWN
        return greedy(observations, masks) if self.knows else masks.argmax(-1)

greedy, policy = policy, Cheat()
"""
    code, found = verify(enter(tmp_path, cheat, "cheat", **BELIEF))
    assert found["reproduced"], "it does play the testing episodes as it says"
    assert code == 1 and found["claimed"] - found["fresh"] > found["margin"]


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("policy = 1 / 0", "ZeroDivisionError"),
        ("", "it has no 'policy'"),
        ("def policy(observations, masks): return masks", "its actions are uint8 of shape"),
        ("def policy(observations, masks): return [99] * len(masks)", "action 99 of camera"),
        ("def policy(observations, masks): raise ValueError('lost my\\nway')", "way"),
        ("def policy(observations, masks):\n    while True: pass", "out of its processor time or memory"),
        ("def policy(observations, masks): return bytearray(10 ** 12)", "MemoryError"),
    ],
)
def test_refuses_files_that_fail_in_one_line(text: str, reason: str, tmp_path: pathlib.Path) -> None:
    with pytest.raises(hificamsim.InputError) as said:
        enter(tmp_path, text, seconds=2)
    assert reason in str(said.value) and "mine.py" in str(said.value)
    assert len(str(said.value).splitlines()) == 1


def test_prints_do_not_disturb_and_environment_is_empty(tmp_path: pathlib.Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TOP_SECRET", "1")
    text = "import os\nassert 'TOP_SECRET' not in os.environ\nprint('hello')\n" + GREEDY
    assert (enter(tmp_path, text, **BELIEF) / "entry.json").exists()


def replace(entry: pathlib.Path, name: str, content: bytes) -> None:
    """Puts another policy in the place of the one that was played, with its hash."""
    (entry / f"policy-{name}").write_bytes(content)
    told = json.loads((entry / "entry.json").read_text())
    told["files"][name] = hashlib.sha256(content).hexdigest()
    (entry / "entry.json").write_text(json.dumps(told))


SLEEPS = "import time\ndef policy(observations, masks): time.sleep(10 ** 6)\n"
WORKS = "def policy(observations, masks):\n    while True: pass\n"
GROWS = "def policy(observations, masks): return bytearray(3 * 10 ** 9)\n"


@pytest.mark.parametrize(
    ("text", "reason"), [(SLEEPS, "out of time or memory"), (WORKS, "out of time or memory"), (GROWS, "MemoryError")]
)
def test_verified_file_has_limits(text: str, reason: str, tmp_path: pathlib.Path) -> None:
    entry = enter(tmp_path, GREEDY, **BELIEF)
    replace(entry, "mine.py", text.encode())
    with pytest.raises(hificamsim.InputError) as said:
        verify(entry, seconds=8, memory=2000)
    assert reason in str(said.value) and "task passage-v1" in str(said.value)
    assert len(str(said.value).splitlines()) == 1


def network(file: pathlib.Path, repeats: int = 1, size: int = 1) -> pathlib.Path:
    """A network that values views by what they add (the last of their numbers), with a sum over as many numbers as ``size``,
    as often as ``repeats``.
    """
    onnx = pytest.importorskip("onnx")
    from onnx import TensorProto, helper, numpy_helper

    def value(name: str, shape: list[Any]) -> Any:
        return helper.make_tensor_value_info(name, TensorProto.FLOAT, shape)

    kept = {"last": np.array([9]), "axes": np.array([-1]), "count": np.array(repeats), "shape": np.array([size])}
    kept["go"], kept["zero"] = np.array(True), np.zeros(1, np.float32)
    body = helper.make_graph(
        [
            helper.make_node("Expand", ["carried", "shape"], ["many"]),
            helper.make_node("ReduceSum", ["many"], ["sum"], keepdims=0),
            helper.make_node("Mul", ["sum", "zero"], ["next"]),
            helper.make_node("Identity", ["go_on"], ["goes"]),
        ],
        "body",
        [
            helper.make_tensor_value_info("i", TensorProto.INT64, []),
            helper.make_tensor_value_info("go_on", TensorProto.BOOL, []),
            value("carried", [1]),
        ],
        [helper.make_tensor_value_info("goes", TensorProto.BOOL, []), value("next", [1])],
    )
    nodes = [
        helper.make_node("Gather", ["views", "last"], ["column"], axis=2),
        helper.make_node("Squeeze", ["column", "axes"], ["promised"]),
        helper.make_node("ReduceSum", ["promised"], ["seed"], keepdims=0),
        helper.make_node("Mul", ["seed", "zero"], ["begun"]),
        helper.make_node("Loop", ["count", "go", "begun"], ["nothing"], body=body),
        helper.make_node("Add", ["promised", "nothing"], ["values"]),
    ]
    graph = helper.make_graph(
        nodes,
        "policy",
        [value("views", ["cameras", "views", 10])],
        [value("values", ["cameras", "views"])],
        [numpy_helper.from_array(array, name) for name, array in kept.items()],
    )
    model = helper.make_model(graph, opset_imports=[helper.make_opsetid("", 13)], ir_version=8)
    onnx.checker.check_model(model)
    onnx.save(model, file)
    return file


def enter_network(file: pathlib.Path, folder: pathlib.Path) -> pathlib.Path:
    out = folder / "network"
    words = ["--policy", f"onnx:{file}", "--name", "network", "--tasks", "passage-v1", "--out", str(out)]
    hificamsim.execute("benchmark", "run", *words)
    return out


def test_network_is_verified_and_has_its_own_score(onnx_runtime: None, tmp_path: pathlib.Path) -> None:
    entry = enter_network(network(tmp_path / "views.onnx"), tmp_path)
    greedy = enter(tmp_path, GREEDY, **BELIEF)
    told = [json.loads((folder / "entry.json").read_text())["tasks"]["passage-v1"] for folder in (entry, greedy)]
    assert told[0]["scores"] == told[1]["scores"], "the same views by the same numbers"
    code, found = verify(entry)
    assert code == 0 and found["reproduced"]


@pytest.mark.parametrize("costs", [{"repeats": 2**62}, {"repeats": 2, "size": 10**9}])
def test_verified_network_has_limits(costs: dict[str, int], onnx_runtime: None, tmp_path: pathlib.Path) -> None:
    entry = enter_network(network(tmp_path / "views.onnx"), tmp_path)
    replace(entry, "views.onnx", network(tmp_path / "costly.onnx", **costs).read_bytes())
    with pytest.raises(hificamsim.InputError) as said:
        verify(entry, seconds=8, memory=2000)
    assert "task passage-v1" in str(said.value) and len(str(said.value).splitlines()) == 1


def test_file_sees_no_network_and_no_process_and_writes_nowhere(tmp_path: pathlib.Path) -> None:
    namespaces = ["unshare", "--user", "--map-root-user", "--net", "--pid", "--fork", "--mount-proc", "true"]
    if subprocess.run(namespaces, capture_output=True, check=False).returncode:
        pytest.skip("this system gives no namespaces to its users")
    text = "import os\nassert len([name for name in os.listdir('/proc') if name.isdigit()]) == 1\n"
    text += "assert [line.split(':')[0].strip() for line in open('/proc/net/dev')][2:] == ['lo']\n"
    text += f"""
import errno, subprocess
open("scratch", "w").write("its own folder")
subprocess.run(["mount", "-o", "remount,bind,rw", "/"], stderr=subprocess.DEVNULL)
try:
    open({str(tmp_path / "forged")!r}, "w")
    raise SystemExit("it wrote a file")
except OSError as fault:
    assert fault.errno == errno.EROFS
"""
    assert (enter(tmp_path, text + GREEDY, **BELIEF) / "entry.json").exists()


def test_file_sees_its_own_folder_and_what_lies_beside_it(tmp_path: pathlib.Path) -> None:
    (tmp_path / "elsewhere").mkdir()
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "weights.txt").write_text("1")
    text = f"""
import importlib.util, os
assert os.path.isdir(".root"), "unconfined"
package = importlib.util.find_spec("hificamsim").submodule_search_locations[0]
for folder in "jars", "scenarios":
    assert os.listdir(os.path.join(package, folder)) == [], folder
for hidden in {[str(tmp_path / "elsewhere"), "/etc/passwd"]}:
    assert not os.path.exists(hidden), hidden
assert open(os.path.join(os.path.dirname(__file__), "weights.txt")).read() == "1"
assert sorted(os.listdir(".")) == [".root", "decide.py", "errors", "policy.py"], os.listdir(".")
assert len([name for name in os.listdir("/proc") if name.isdigit()]) == 1
""" + GREEDY
    try:
        entry = enter(tmp_path / "mine", text, "open", **BELIEF)
    except hificamsim.InputError as fault:
        if "unconfined" not in str(fault):
            raise
        pytest.skip("this system has no namespaces for users")
    assert (entry / "entry.json").exists()

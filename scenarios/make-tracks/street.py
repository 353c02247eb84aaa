#!/usr/bin/env python3
"""Makes the recording of street.xml: four streets with pavements that meet at a traffic light.

    pip install eclipse-sumo
    scenarios/make-tracks/street.py out/street-fcd.xml

SUMO (https://eclipse.dev/sumo, EPL-2.0) makes the network and moves cars, buses and people; what it writes
is nobody's but the user's. The seed is fixed: the same version writes the same file.
"""
import pathlib
import subprocess
import sys
import tempfile

ARM = 70  # m from the middle to the end of a street
SECONDS = 240
STEP = 0.5  # s

NODES = f"""<nodes>
  <node id="mid" x="0" y="0" type="traffic_light"/>
  <node id="n" x="0" y="{ARM}"/> <node id="e" x="{ARM}" y="0"/>
  <node id="s" x="0" y="-{ARM}"/> <node id="w" x="-{ARM}" y="0"/>
</nodes>"""

ARMS = "nesw"


def edges():
    rows = []
    for arm in ARMS:
        for start, end in ((arm, "mid"), ("mid", arm)):
            rows.append(
                f'<edge id="{start}-{end}" from="{start}" to="{end}" numLanes="1" speed="13.9" sidewalkWidth="2.5"/>'
            )
    return "<edges>" + "\n".join(rows) + "</edges>"


def routes():
    rows = [
        '<vType id="car" vClass="passenger"/>',
        '<vType id="bus" vClass="bus"/>',
        '<vType id="walker" vClass="pedestrian"/>',
    ]
    for i, start in enumerate(ARMS):
        for j, end in enumerate(ARMS):
            if i == j:
                continue
            straight = (j - i) % 4 == 2
            every = 24 if straight else 60
            rows.append(
                f'<flow id="car-{start}{end}" type="car" begin="{3 * i + j}" end="{SECONDS}" period="{every}"'
                f' from="{start}-mid" to="mid-{end}" departSpeed="max"/>'
            )
            rows.append(
                f'<personFlow id="walk-{start}{end}" type="walker" begin="{5 * i + 2 * j}" end="{SECONDS}"'
                f' period="48"><walk from="{start}-mid" to="mid-{end}"/></personFlow>'
            )
    rows.append(
        f'<flow id="bus" type="bus" begin="20" end="{SECONDS}" period="80" from="w-mid" to="mid-e" departSpeed="max"/>'
    )
    rows.sort(key=lambda row: float(row.split('begin="')[1].split('"')[0]) if "begin=" in row else -1)
    return "<routes>" + "\n".join(rows) + "</routes>"


def main():
    out = pathlib.Path(sys.argv[1]).absolute()
    out.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "nodes.xml").write_text(NODES)
        (folder / "edges.xml").write_text(edges())
        (folder / "routes.xml").write_text(routes())
        run(
            folder,
            ["netconvert", "-n", "nodes.xml", "-e", "edges.xml", "-o", "net.xml", "--crossings.guess",
             "--sidewalks.guess", "--no-turnarounds", "--offset.disable-normalization"],
        )
        run(
            folder,
            ["sumo", "-n", "net.xml", "-r", "routes.xml", "--fcd-output", str(out), "--step-length", str(STEP),
             "--end", str(SECONDS), "--seed", "1", "--precision", "2", "--no-step-log", "--xml-validation", "never"],
        )
    print(out)


def run(folder, words):
    beside = pathlib.Path(sys.executable).with_name(words[0])
    program = str(beside) if beside.exists() else words[0]
    subprocess.run([program, *words[1:]], cwd=folder, check=True, stdout=subprocess.DEVNULL)


if __name__ == "__main__":
    main()

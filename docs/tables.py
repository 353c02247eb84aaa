"""Writes the tables docs/tables/*.csv, whose cells are Markdown, from folders of results: tables.py NAME FOLDER... (see docs/make-figures)."""

import csv
import json
import math
import pathlib
import re
import statistics
import sys

DOCS = pathlib.Path(__file__).parent
LAYOUTS = ("lattice", "ring", "cluster")
DASH = "-"


def rows(folder, name):
    with open(pathlib.Path(folder, name), newline="") as file:
        return list(csv.DictReader(file))


def number(text):
    return float(text) if text else math.nan


def write_table(name, header, lines):
    with open(DOCS / "tables" / f"{name}.csv", "w", newline="", encoding="utf-8") as file:
        csv.writer(file, lineterminator="\n").writerows([header, *lines])


# reproduce

OTHERS = {
    "over_one_hop": "over one hop",
    "eq_6.2": "CamSim by Eq 6.2",
    "over_hifi_optimum_at_0.45": "CamSim at 0.45 over the hi-fi optimum",
    "explore_any": "`explore=any`",
    "cluster_script_at_origin": "cluster's script at the origin",
}


def cell(row, column):
    value = number(row[column])
    near = abs(value - number(row["published"])) <= 0.05 + 1e-9
    return DASH if math.isnan(value) else f"**{value:.2f}**" if near else f"{value:.2f}"


def table_81(folder):
    cells = rows(folder, "table-8.1.csv")
    lines = []
    for detection in ("hifi:orb-lin", "camsim-range"):
        for policy in ("zoom-out", "epsilon-greedy", "sarsa"):
            own = [
                next(r for r in cells if (r["layout"], r["policy"], r["detection"]) == (layout, policy, detection))
                for layout in LAYOUTS
            ]
            line = [("hi-fi " if detection.startswith("hifi") else "CamSim ") + policy]
            line.append(" / ".join(f"{number(r['published']):.2f}" for r in own))
            line.append(" / ".join(cell(r, "proportion") for r in own))
            line.append(own[0]["role"])
            for column in OTHERS:
                read = " / ".join(cell(r, column) for r in own)
                line.append("" if set(read) <= set("- /") else read.removeprefix("- / - / "))
            lines.append(line)
    write_table("table-8.1", ["", "published", "ours", "", *OTHERS.values()], lines)


READINGS = {
    "default": "our defaults",
    "over_one_hop": "greedy is the best within one zoom level of the present one",
    "over_hifi_optimum": "CamSim over the hi-fi optimum",
    "over_hifi_optimum_at_0.45": "the same with CamSim's threshold at 0.45",
    "explore_any": "epsilon-greedy explores any level",
    "cluster_script_at_origin": "the cluster's script about the field's centre",
    "eq_6.2": "CamSim by Eq 6.2 as printed",
    "reward_sign": "SARSA's reward is the sign of the change",
    "reward_literal": "SARSA's reward is Eq 7.5 as printed",
}


def readings(folder):
    found = rows(folder, "readings.csv")
    lines = []
    for name, words in READINGS.items():
        line = [words]
        for detection in ("hi-fi", "CamSim"):
            own = next(r for r in found if (r["reading"], r["detection"]) == (name, detection))
            line += [f"{number(own['distance']):.3f}", f"{own['within']} of 9"]
        lines.append(line)
    write_table("readings", ["", "hi-fi", "within 0.05", "CamSim", "within 0.05"], lines)


def verdicts(folder, name):
    statements = [row for row in rows(folder, "verdicts.csv") if row["kind"] == "statement"]
    lines = []
    for row in statements:
        fitted = " *(fitted)*" if row["role"] == "fitted" else ""
        why = row["why"].replace(" checks hold; weakest:", ";")
        lines.append([row["claim"], row["source"], row["verdict"] + fitted, why])
    write_table(name, ["statement", "source", "verdict", "checks that hold; the weakest margin"], lines)


def reproduce(folder):
    table_81(folder)
    readings(folder)
    verdicts(folder, "verdicts")


# sensitivity

UNITS = {"size": "q, m", "optics": "focal length of the narrowest level, m", "formula": "CamSim's", "speed": "m a step", "radii": "the widest, m", "greedy": "what all are divided by"}


def sensitivity(folder):
    places = [row for row in rows(folder, "sensitivity.csv") if row["layout"] != "all"]
    lines = []
    for parameter in dict.fromkeys(row["parameter"] for row in places):
        own = [row for row in places if row["parameter"] == parameter]
        values = {row["value"]: row["default"] == "true" for row in own}
        flips = []
        for value in values:
            at = [row for row in own if row["value"] == value]
            count = sum(row["finding"] == "overestimates" for row in at)
            if count:
                flips.append(f"at {value}: {count} of {len(at)}")
        holds = sum(row["finding"] == "underestimates" for row in own)
        unit = f" ({UNITS[parameter]})" if parameter in UNITS else ""
        lines.append(
            [
                f"`{parameter}`{unit}",
                ", ".join(value + ("*" if default else "") for value, default in values.items()),
                f"{holds} of {len(own)}",
                ", ".join(flips) or "nowhere",
            ]
        )
    write_table("sensitivity", ["parameter", "values", "holds", "flips"], lines)


# the sites of sites.md

HIDDEN = ("optimal",)  # the scores of others are shares of its score


def means(folder, metric, scenario=None):
    found = (row for row in rows(folder, "summary.csv") if row["metric"] == metric)
    return {row["policy"]: row for row in found if scenario in (None, row["scenario"])}


def scenarios(folder):
    return list(dict.fromkeys(row["scenario"] for row in rows(folder, "summary.csv")))


def interval(row, form):
    if row["low"] == row["high"]:
        return f"{number(row['mean']):{form}} in every seed"
    return f"{number(row['mean']):{form}} [{number(row['low']):{form}}, {number(row['high']):{form}}]"


def sites(*folders):
    """Writes the value of adapting on each site, for a bound that moves at once and for cameras whose moves take time."""
    values, shares = [], {}
    for folder in folders:
        name = pathlib.Path(folder).name
        steps = steps_of(folder)
        score = means(folder, "score")
        optimum = number(score["optimal"]["mean"]) / steps
        adapting = means(folder, "value_of_adapting")["optimal"]
        learning = means(folder, "value_of_learning")
        moving = [learning[policy] for policy in ("independent-greedy", "one-hop") if policy in learning]
        best = max(moving, key=lambda row: number(row["mean"]))
        values.append(
            [f"[{name}](../scenarios/{name}.xml)", adapting["runs"], f"{optimum:.2f}", interval(adapting, ".2f"), f"{interval(best, '.2f')} (`{best['policy']}`)"]
        )
        for policy, row in means(folder, "proportion_of_optimal").items():
            if policy not in HIDDEN:
                shares.setdefault(policy, {})[name] = f"{number(row['mean']):.2f}"
    header = ["site", "seeds", "`optimal`, mean score", "value of adapting, jumping", "value of adapting, moving"]
    write_table("sites", header, values)
    names = [pathlib.Path(folder).name for folder in folders]
    order = sorted(shares, key=lambda policy: -sum(float(shares[policy].get(name, 0)) for name in names))
    lines = [[f"`{policy}`", *(shares[policy].get(name, DASH) for name in names)] for policy in order]
    write_table("shares", ["", *names], lines)


def adapting(*folders):
    """Writes the value of adapting on each site, for cameras that move at once, for those whose moves take time, and for cooperative ones."""
    lines = []
    for folder in folders:
        name = pathlib.Path(folder).name
        sums = {}
        for row in rows(folder, "yardsticks.csv"):
            key = row["yardstick"], row["is"]
            sums[key] = sums.get(key, 0) + number(row["score"])
        fixed, reached, most = sums["best-fixed", "reached"], sums["reachable", "reached"], sums["reachable", "at most"]
        own = number(means(folder, "score")["cooperative"]["mean"]) * number(means(folder, "score")["cooperative"]["runs"])
        lines.append(
            [f"[{name}](../scenarios/{name}.xml)", f"{sums['optimal', 'reached'] / fixed:.2f}", f"{reached / fixed:.2f} to {most / fixed:.2f}",
             f"{own / fixed:.2f}", f"{own / most:.2f}", f"{100 * (1 - reached / most):.1f} %"]
        )
    header = ["site", "jumping", "in time", "`cooperative`", "its share of what could be reached", "gap"]
    write_table("adapting", header, lines)


def cooperation(perfect, bad):
    """Of each site: the shares of what could be reached, of best-fixed and of cooperative cameras over both channels."""
    lines = []
    for folder in sorted(pathlib.Path(perfect).iterdir()):
        most = statistics.mean(number(row["score"]) for row in rows(folder, "yardsticks.csv") if row["is"] == "at most")
        fixed, own = (scores(folder, policy) for policy in ("best-fixed", "cooperative"))
        late = scores(pathlib.Path(bad, folder.name), "cooperative")
        least = min(score / fixed.get(seed, max(fixed.values())) for seed, score in late.items())  # recorded sites have one run
        means = (f"{statistics.mean(found.values()) / most:.2f}" for found in (fixed, own, late))
        lines.append([folder.name, *means, f"{least:.2f}"])
    write_table("cooperation", ["", "`best-fixed`", "`cooperative`", "over the bad channel", "its worst run, over `best-fixed`"], lines)


def scores(folder, policy):
    """The scores of a policy by seed."""
    return {row["seed"]: number(row["score"]) for row in rows(folder, "results.csv") if row["policy"] == policy}


PARTS = {"nothing": "as it is", "pan": "no `pan`", "obstacles": "no obstacles", "occlusion": "no `occlusion`", "time": "no `pan_speed`, no `zoom_time`"}


def realism(*folders):
    """Writes the value of adapting with one part of the scenario left out, for cameras that move at once and for those that take time."""
    parts = {pathlib.Path(folder).name: folder for folder in folders}
    names = ["corridor", "junction", "hall", "car-park", "campus", "border"]

    def line(policy, part, words):
        metric = "value_of_adapting" if policy == "optimal" else "value_of_learning"
        found = [means(parts[part], metric, name).get(policy) for name in names]
        return [words, *(interval(row, ".2f") if row else DASH for row in found)]

    lines = [line("optimal", part, words) for part, words in PARTS.items() if part != "time"]
    lines += [line("independent-greedy", part, f"`independent-greedy`, {PARTS[part]}") for part in ("nothing", "time")]
    write_table("realism", ["value of adapting", *names], lines)


def ranked(folder):
    """Returns the rank of each policy by scenario, 1 for the highest mean score; policies that tie share the mean rank."""
    found = {}
    for scenario in scenarios(folder):
        scores = {policy: number(row["mean"]) for policy, row in means(folder, "score", scenario).items()}
        found[scenario] = {
            policy: 1 + sum(other > one for other in scores.values()) + (sum(other == one for other in scores.values()) - 1) / 2
            for policy, one in scores.items()
        }
    return found


def tau(one, other):
    """Returns Kendall's tau-b of two orders of the same policies."""
    sign = lambda a, b: (a > b) - (a < b)
    pairs = [(sign(one[a], one[b]), sign(other[a], other[b])) for a in one for b in one if a < b]
    left, right = (sum(abs(pair[i]) for pair in pairs) for i in (0, 1))
    return sum(a * b for a, b in pairs) / math.sqrt(left * right)


def mean(values):
    values = list(values)
    return sum(values) / len(values)


def ranks(layouts, sites):
    """Writes mean ranks on the scenarios of chapter 8 and on the sites, and prints Kendall's taus for the text."""
    orders = [ranked(layouts), ranked(sites)]
    policies = list(next(iter(orders[0].values())))
    both = [{policy: mean(ranks[policy] for ranks in order.values()) for policy in policies} for order in orders]
    policies.sort(key=lambda policy: both[0][policy])
    words = ("the six of chapter 8 (`hifi:orb-lin`, k_min)", "the eight sites (as above)")
    lines = [[text, *(f"{order[policy]:.1f}" for policy in policies)] for text, order in zip(words, both)]
    write_table("ranks", ["", *policies], lines)
    six, eight = (list(order.values()) for order in orders)
    pairs = lambda order: mean(tau(a, b) for i, a in enumerate(order) for b in order[:i])
    print(f"tau of both {tau(*both):.2f}; mean among the six {pairs(six):.2f}, among the sites {pairs(eight):.2f}, ", end="")
    print(f"between {mean(tau(a, b) for a in six for b in eight):.2f}")
    for scenario, order in {**orders[0], **orders[1]}.items():
        print(f"{scenario}: {', '.join(sorted(order, key=order.get))}")


def arenas(folder):
    policies = list(means(folder, "score"))
    lines = []
    for scenario in scenarios(folder):
        shares = means(folder, "score", scenario)
        steps = {"mate-4v8-9": 300, "hit-mac": 100}[scenario]
        adapting = means(folder, "value_of_adapting", scenario)["optimal"]
        lines.append([f"[{scenario}](../scenarios/{scenario}.xml)", *(f"{number(shares[policy]['mean']) / steps:.2f}" for policy in policies), interval(adapting, ".2f")])
    write_table("arenas", ["", *policies, "value of adapting"], lines)


def turning(folder):
    """Writes the mean score of a step for policies of cameras that turn."""
    names = scenarios(folder)
    found = {name: means(folder, "score", name) for name in names}
    lines = []
    for policy in found[names[0]]:
        lines.append([f"`{policy}`", *(f"{number(found[name][policy]['mean']) / 300:.2f}" for name in names)])
    write_table("turning", ["policy", *names], lines)


def ratios(*folders):
    """Prints R2 of a line that predicts ORB's confidence from measured PIP, for each ratio, for the text of reproduction.md."""
    for folder in folders:
        photos = rows(folder, "measurements.csv")
        pip, confidence = ([number(row[name]) for row in photos] for name in ("pip", "orb"))
        print(f"{pathlib.Path(folder).name}: R2 {statistics.correlation(pip, confidence) ** 2:.2f} of {len(photos)} photos")


def ladder(folder):
    """Writes each rung of a ladder of detections, the top one first: optimum, tau, mean regret and regret by scenario in percent, cost."""
    found = rows(folder, "rungs.csv")
    scenarios = list(dict.fromkeys(row["scenario"] for row in found if row["scenario"] != "all"))
    costs = json.loads(pathlib.Path(folder, "cost.json").read_text(encoding="utf-8"))["steps"]
    lines = []
    for mean in reversed([row for row in found if row["scenario"] == "all"]):
        low, share, high = (f"{100 * number(mean[name]):.0f}" for name in ("share_low", "share", "share_high"))
        own = {row["scenario"]: row for row in found if row["rung"] == mean["rung"]}
        cost = statistics.mean(entry["nanoseconds"] for entry in costs if entry["rung"] == mean["rung"])
        lines.append([f"`{mean['rung']}`", f"{number(mean['optimum']):.2f}", between(mean, "tau", ".2f"), f"{share} [{low}, {high}]",
            *(f"{100 * number(own[scenario]['share']):.0f}" for scenario in scenarios), f"{cost:.0f}"])
    names = (scenario.replace("-", " ") for scenario in scenarios)
    write_table("ladder", ["rung", "optimum's `k_min`", "tau", "regret, %", *names, "ns a step"], lines)


def rungs(*folders):
    """Writes for each ladder of a world tau, what the choice of each rung loses in percent, and what the rung predicts."""
    names = [pathlib.Path(folder).name.removeprefix("ladder-") for folder in folders]
    found = {
        name: {row["rung"]: row for row in rows(folder, "rungs.csv") if row["scenario"] != "all"}
        for name, folder in zip(names, folders)
    }
    order = list(next(iter(found.values())))
    losses, levels = [], []
    for rung in order:
        own = [found[name][rung] for name in names]
        taus = [number(row["tau"]) for row in own if row["tau"]]
        lost = [100 * number(row["share"]) for row in own]
        mean = f"{sum(taus) / len(taus):.2f}; {sum(lost) / len(lost):.0f}"
        losses.append([f"`{rung}`", *(loss(row) for row in own), mean])
        levels.append([f"`{rung}`", *(f"{number(row['optimum']):.2f}" for row in own)])
    write_table("rungs", ["rung", *names, "mean"], losses)
    write_table("rungs-optimum", ["rung", *names], levels)


def loss(row):
    text = f"{number(row['tau']):.2f}; " if row["tau"] else f"{DASH}; "
    low, share, high = (f"{100 * number(row[name]):.0f}" for name in ("share_low", "share", "share_high"))
    return text + share + (f" [{low}, {high}]" if low != high else "")


# camsim-studies.md

STUDENT_QUANTILE = 2.045  # for a 95 % interval of 30 seeds


def studies(plain, *changed):
    """Writes the verdicts on statements, the front under each condition, and the utility that strategies keep under loss and delay."""
    verdicts(plain, "statements")
    folders = [plain, *changed]
    scenarios = list(dict.fromkeys(row["scenario"] for row in rows(plain, "networks.csv")))
    lines = []
    for folder in folders:
        networks, fronts = rows(folder, "networks.csv"), rows(folder, "fronts.csv")
        for scenario in scenarios:
            own = [row for row in networks if row["scenario"] == scenario]
            front = {row["networks"]: row for row in fronts if row["scenario"] == scenario}
            alike = [row for row in own if row["kind"] == "homogeneous"]
            best = max(alike, key=lambda row: number(row["utility_share"]) * (1 - number(row["cost_share"])))
            cheap = min((row for row in own if number(row["utility_share"]) >= 0.95), key=lambda row: number(row["cost"]))
            lines.append([pathlib.Path(folder).name, scenario, f"{max(number(row['utility']) for row in own):.0f}", f"{max(number(row['cost']) for row in own):.0f}",
                between(front["homogeneous"], "hypervolume", ".3f"), between(front["static"], "gain", "+.3f"), best["network"], f"{cheap['network']}, {100 * number(cheap['cost_share']):.0f} %"])
    write_table("conditions", ["", "scenario", "most utility", "most messages", "hypervolume of homogeneous networks", "heterogeneous ones add", "best alone", "cheapest with 95 % of the utility"], lines)
    lines = []
    for network in dict.fromkeys(row["network"] for row in rows(plain, "networks.csv") if row["kind"] == "homogeneous"):
        line = [network]
        for folder in changed:
            line += [kept(plain, folder, scenario, network) for scenario in scenarios]
        lines.append(line)
    write_table("kept", ["", *(f"{pathlib.Path(folder).name}: {scenario}" for folder in changed for scenario in scenarios)], lines)


def saso(folder):
    verdicts(folder, "saso")


def between(row, name, form):
    return f"{number(row[name]):{form}} [{number(row[name + '_low']):{form}}, {number(row[name + '_high']):{form}}]"


def kept(plain, changed, scenario, network):
    """Returns the percentage of a strategy's utility that remains under a condition, paired by seed."""
    before, after = (
        [number(row["utility"]) for row in rows(folder, "results.csv") if (row["scenario"], row["network"]) == (scenario, network)]
        for folder in (plain, changed)
    )
    shares = [100 * y / x for x, y in zip(before, after) if x > 0]
    return f"{statistics.mean(shares):.0f} ± {STUDENT_QUANTILE * statistics.stdev(shares) / math.sqrt(len(shares)):.0f}"


def search(*folders):
    """Writes the share of the hypervolume that a search finds; folders come in pairs, of all networks and of the search."""
    lines = []
    for full, found in zip(folders[::2], folders[1::2]):
        networks, some = rows(full, "networks.csv"), rows(found, "networks.csv")
        most = [max(number(row[name]) for row in networks) for name in ("utility", "cost")]
        whole, part = volume(networks, *most), volume(some, *most)
        lines.append([networks[0]["scenario"], f"{len(networks):,}", f"{len(some):,}", f"{whole:.4f}", f"{100 * part / whole:.2f} %"])
    write_table("search", ["scenario", "networks", "the search runs", "hypervolume of all", "of it found"], lines)


def volume(networks, utility, cost):
    area, best = 0.0, 0.0
    for row in sorted(networks, key=lambda row: (number(row["cost"]), -number(row["utility"]))):
        area += max(0, number(row["utility"]) - best) * (cost - number(row["cost"]))
        best = max(best, number(row["utility"]))
    return area / (utility * cost)


def steps_of(folder):
    with open(pathlib.Path(folder, "settings.json"), encoding="utf-8") as file:
        return json.load(file)[0]["steps"]


def placement(*folders):
    """Writes plans and the sites' own cameras under both readings: folders 60/SITE-any, 60/SITE-fixed; those in 600 had 600 seconds."""
    plans = {}
    for folder in map(pathlib.Path, folders):
        plans.setdefault(folder.name, {})[folder.parent.name] = json.loads((folder / "summary.json").read_text())
    lines = []
    for name, by_time in sorted(plans.items()):
        site, reading = name.rsplit("-", 1)
        line = [site, by_time["60"]["cameras"], reading, f"{100 * by_time['60']['share_of_site']:.2f} %"]
        for plan in (by_time["60"], by_time.get("600", by_time["60"])):
            gap = (plan["share_bound"] - plan["share"]) / plan["share_bound"]
            line += [f"{100 * plan[key]:.2f} %" for key in ("share", "share_bound")]
            line.append("proven" if plan["proven"] else f"{100 * gap:.2f} %")
        lines.append(line)
    times = [f"{what}, {time}" for time in ("1 min", "10 min") for what in ("plan", "bound", "gap")]
    write_table("placement", ["site", "cameras", "reading", "its own", *times], lines)


def short(text, digits):
    return f"{round(number(text), digits) + 0.0:.{digits}f}".replace("0.", ".", 1)


def benchmark(folder):
    """Writes the leaderboard from a folder of `benchmark leaderboard`."""
    lines = {}
    for row in rows(folder, "leaderboard.csv"):
        built_in = row["name"] == row["policy"]
        line = lines.setdefault(f"`{row['name']}`" if built_in else row["name"], {})
        if row["statistic"] == "iqm":
            line["IQM"] = f"{short(row['value'], 3)} [{short(row['low'], 3)}, {short(row['high'], 3)}]"
        elif row["task"]:
            line[row["task"].removesuffix("-v1")] = short(row["value"], 2)
    header = list(dict.fromkeys(column for line in lines.values() for column in line))
    write_table("benchmark", ["policy", *header], [[name, *(line.get(c, DASH) for c in header)] for name, line in lines.items()])


def trained(*files):
    """Writes the scores of python/examples/measure.py by task, compared with the leaderboard; run it after `benchmark`."""
    import numpy

    found = {}
    for row in (row for file in files for row in rows(".", file)):
        method = row["training"].rsplit("-", 1)[0]
        found.setdefault(method, {}).setdefault(row["training"], {}).setdefault(row["task"], []).append(number(row["score"]))
    columns = {}
    for method, trainings in found.items():
        tasks = list(next(iter(trainings.values())))
        scores = numpy.array([[of[task] for task in tasks] for of in trainings.values()])
        begun = "" if method == "imitation" else "imitation, then "
        columns[f"{begun}{method}, {len(scores)} seeds"] = intervals(scores, [task.removesuffix("-v1") for task in tasks])
    board = {line["policy"]: line for line in rows(DOCS / "tables", "benchmark.csv")}
    others = [name for name in ("`cooperative` before ways", "`cooperative`", "IPPO", "MAPPO", "`softmax`", "`epsilon-greedy`", "`sarsa`") if name in board]
    names = ["IQM", *[column for column in board[others[0]] if column not in ("policy", "IQM")]]
    lines = [[name, *(of[name] for of in columns.values()), *(board[other][name] for other in others)] for name in names]
    write_table("trained", ["", *columns, *others], lines)


def curves(*folders):
    """Writes the curves of trainings next to the script that draws them."""
    with open(DOCS / "img" / "recipe-curves.csv", "w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(["method", "training", "round", "minutes", "score"])
        for folder in folders:
            training = pathlib.Path(folder).name
            for row in rows(folder, "curve.csv"):
                writer.writerow([training.rsplit("-", 1)[0], training, row["round"], row["minutes"], row["score"]])


def intervals(scores, tasks):
    """Returns the interquartile mean, and each task's mean, of scores in the shape (trainings, tasks, testing seeds), with
    95 % intervals by a bootstrap over trainings and, within each task, over testing seeds."""
    import numpy

    random = numpy.random.default_rng(1)
    trainings, count, seeds = scores.shape

    def statistics_of(drawn):
        flat = numpy.sort(drawn.reshape(len(drawn), -1))
        cut = flat.shape[1] // 4
        middle = flat[:, cut : flat.shape[1] - cut].mean(1)
        return numpy.column_stack([middle, drawn.mean((1, 3))])

    draws = []
    for _ in range(2000):
        own = random.integers(0, trainings, trainings)
        tested = random.integers(0, seeds, (count, seeds))
        draws.append(scores[own][:, numpy.arange(count)[:, None], tested])
    low, high = numpy.quantile(statistics_of(numpy.array(draws)), [0.025, 0.975], axis=0)
    means = statistics_of(scores[None])[0]
    written = [f"{short(m, 3)} [{short(a, 3)}, {short(b, 3)}]" for m, a, b in zip(means, low, high)]
    return dict(zip(["IQM", *tasks], written))


if __name__ == "__main__":
    parts = (benchmark, trained, curves, reproduce, sensitivity, sites, adapting, cooperation, realism, ranks, arenas, turning, ratios, ladder, rungs, studies, saso, search, placement)
    {part.__name__: part for part in parts}[sys.argv[1]](*sys.argv[2:])

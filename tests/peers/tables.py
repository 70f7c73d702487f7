"""The tables of README.md, made from the results; `tests/chart/peers.rs` reckons anew."""

import csv
import re
from pathlib import Path

#: At which errors times are compared.
LEVELS = {
    "peers-factors": [
        ("cube", ["1e-6", "1e-7", "1e-10"]),
        ("cornell-regular", ["1e-3", "4e-4", "1e-5"]),
        ("blocked squares", ["1e-2", "1e-3", "1e-4"]),
    ],
    "peers-irradiance": [
        ("cornell-regular elements", ["1e-1", "3e-2", "1e-2", "3e-3"]),
        ("cornell-regular faces", ["3e-2", "1e-2", "3e-3", "1e-3"]),
    ],
}
PEERS = {
    "peers-factors": ["pyviewfactor"],
    "peers-irradiance": ["mitsuba", "pyradiance"],
    "peers-rays": ["embreex", "mitsuba"],
}
BEGIN, END = "<!-- tables: made by run.py -->\n", "<!-- end of tables -->\n"


def read(path):
    lines = [
        line for line in Path(path).read_text().splitlines() if not line.startswith("#")
    ]
    return list(csv.DictReader(lines))


def cheapest(rows, suite, scene, program, error):
    """CPU seconds of the cheapest setting of a program that is not further off."""
    fit = [
        float(row["seconds"])
        for row in rows
        if (row["suite"], row["scene"]) == (suite, scene)
        and row["method"].split()[0] == program
        and float(row["error"]) <= float(error)
    ]
    return min(fit, default=None)


def shown(value):
    return "-" if value is None else f"{value:.2g}" if value < 99.5 else f"{value:.0f}"


def beside(peer, own):
    """A peer's time, and how many times ours that is."""
    if peer is None:
        return "-"
    return shown(peer) + (f" ({shown(peer / own)} ×)" if own else "")


def times(rows, suite):
    peers = PEERS[suite]
    lines = [f"| `{suite}` | error at most | radiosity | " + " | ".join(peers) + " |"]
    lines.append("|---" * (3 + len(peers)) + "|")
    for scene, errors in LEVELS[suite]:
        for error in errors:
            own = cheapest(rows, suite, scene, "radiosity", error)
            cells = [beside(cheapest(rows, suite, scene, p, error), own) for p in peers]
            lines.append(
                f"| {scene} | {error} | {shown(own)} | " + " | ".join(cells) + " |"
            )
    return lines


def throughput(rows):
    """Million rays in a CPU second."""
    suite = "peers-rays"

    def rate(program, query):
        for row in rows:
            if row["suite"] == suite and row["method"] == f"{program} {query}":
                return float(row["rays"]) / float(row["seconds"]) / 1e6
        return None

    lines = [f"| `{suite}` | radiosity | " + " | ".join(PEERS[suite]) + " |"]
    lines.append("|---" * (2 + len(PEERS[suite])) + "|")
    for query in ("closest", "any"):
        own = rate("radiosity", query)
        cells = [beside(rate(p, query), own) for p in PEERS[suite]]
        lines.append(f"| {query} | {shown(own)} | " + " | ".join(cells) + " |")
    return lines


def write(folder):
    """Puts the tables of the latest results into README.md."""
    results = max(Path(folder).glob("results-*.csv"))
    rows = read(results)
    text = [f"From `{results.name}`.", ""]
    for suite in LEVELS:
        text += times(rows, suite) + [""]
    text += throughput(rows)
    readme = Path(folder) / "README.md"
    old = readme.read_text()
    made = BEGIN + "\n" + "\n".join(text) + "\n\n" + END
    pattern = re.escape(BEGIN) + ".*" + re.escape(END)
    readme.write_text(re.sub(pattern, lambda _: made, old, flags=re.S))

"""The rows of the record: the columns are those of all charts of this project."""

import math
import statistics
import sys

COLUMNS = (
    "suite,scene,method,setting,seconds,runs,factors,rays,pixels,steps,bytes,memory,"
    "error,uncertainty,energy"
).split(",")


def mean_square(errors):
    return math.sqrt(sum(e * e for e in errors) / len(errors))


class Results:
    def __init__(self):
        self.rows, self.notes = [], []

    def add(self, suite, scene, method, setting, seconds, **more):
        row = {column: "" for column in COLUMNS}
        row.update(suite=suite, scene=scene, method=method, setting=setting)
        row["seconds"] = f"{statistics.median(seconds):.6g}"
        row["runs"] = len(seconds)
        for key, value in more.items():
            row[key] = f"{value:.6g}" if isinstance(value, float) else value
        self.rows.append(row)

    def note(self, text):
        print(f"  {text}", file=sys.stderr, flush=True)
        self.notes.append(text)

    def write(self, path, provenance):
        lines = [f"# {line}" for line in provenance + self.notes]
        lines.append(",".join(COLUMNS))
        lines += [",".join(str(row[c]) for c in COLUMNS) for row in self.rows]
        path.write_text("\n".join(lines) + "\n")

"""Runs our command and the workers of the peers, and counts what they cost."""

import json
import os
import subprocess
import sys
from pathlib import Path

from worker import LONG

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
WORK = ROOT / "target" / "peers"
SCENES = WORK / "scenes"
OURS = ROOT / "target" / "release" / "radiosity"
PEERS = ["pyviewfactor", "mitsuba", "pyradiance", "embreex"]
RUNS = 3

ONE_THREAD = {
    name: "1"
    for name in (
        "NUMBA_NUM_THREADS",
        "OMP_NUM_THREADS",
        "OPENBLAS_NUM_THREADS",
        "MKL_NUM_THREADS",
    )
}


def say(text):
    print(text, file=sys.stderr, flush=True)


def python_of(peer):
    return WORK / peer / "bin" / "python"


def install():
    for peer in PEERS:
        listed = HERE / "requirements" / f"{peer}.txt"
        say(f"installing {peer}")
        try:
            subprocess.run([sys.executable, "-m", "venv", WORK / peer], check=True)
            pip = [python_of(peer), "-m", "pip", "install", "-q", "-r", listed]
            subprocess.run(pip, check=True)
        except (OSError, subprocess.CalledProcessError) as error:
            say(f"{peer} cannot be installed ({error}); it will be skipped.")


def version(peer):
    for line in (HERE / "requirements" / f"{peer}.txt").read_text().splitlines():
        if line.startswith(f"{peer}=="):
            return line.split("==")[1]
    return "unknown"


class Peers:
    """Runs workers; remembers which peers answer."""

    def __init__(self):
        self.out, self.startup, self.warm = set(), {}, {}

    def ask(self, peer, job):
        """The worker's answers by their id; none when the peer is not there or fails."""
        if peer in self.out:
            return {}
        if not python_of(peer).exists():
            self.out.add(peer)
            say(f"{peer} is skipped: it is not installed; `run.py --install` does that.")
            return {}
        say(f"  {peer}")
        done = subprocess.run(
            [python_of(peer), HERE / f"worker_{peer}.py"],
            input=json.dumps(job),
            capture_output=True,
            text=True,
            cwd=WORK,
            env={**os.environ, **ONE_THREAD, **self.llvm()},
        )
        answers = [json.loads(line) for line in done.stdout.splitlines()]
        if done.returncode != 0:
            self.out.add(peer)
            why = done.stderr.strip().splitlines() or ["no reason told"]
            (WORK / f"{peer}.log").write_text(done.stderr)
            hint = " (it needs LLVM 16 or later; DRJIT_LIBLLVM_PATH may name the library)"
            say(f"{peer} is skipped: {why[-1][:200]}{hint if peer == 'mitsuba' else ''}.")
            return {}
        for answer in answers:
            self.startup.setdefault(peer, answer.get("startup"))
            if "warm" in answer:
                self.warm.setdefault(peer, answer["warm"])
        return {a.get("id", next(iter(a))): a for a in answers}

    @staticmethod
    def llvm():
        """A library that was unpacked below target/peers/llvm, if there is one."""
        if "DRJIT_LIBLLVM_PATH" in os.environ:
            return {}
        found = sorted((WORK / "llvm").rglob("libLLVM*.so*")) if WORK.exists() else []
        return {"DRJIT_LIBLLVM_PATH": str(found[0])} if found else {}


#: Starts a command from a process that is small itself: a child's peak of memory begins
#: with that of whoever starts it.
LAUNCHER = """
import os, sys
silence = [(os.POSIX_SPAWN_OPEN, 1, os.devnull, os.O_WRONLY, 0)]
child = os.posix_spawn(sys.argv[1], sys.argv[1:], os.environ, file_actions=silence)
_, status, used = os.wait4(child, 0)
print(status, used.ru_utime + used.ru_stime, 1024 * used.ru_maxrss)
"""


def ours(arguments):
    """Runs our command on one thread: CPU seconds, and the peak of memory in bytes."""
    command = [str(OURS), *arguments.split(), "--threads", "1", "--quiet"]
    launcher = [sys.executable, "-S", "-E", "-c", LAUNCHER]
    done = subprocess.run(launcher + command, check=True, stdout=subprocess.PIPE)
    status, seconds, memory = done.stdout.split()
    if int(status) != 0:
        raise SystemExit(f"radiosity {arguments} failed")
    return float(seconds), int(memory)


def ours_timed(arguments, output, read):
    """As worker.timed: seconds and answers of up to three runs, each with its own seed."""
    seconds, found, memory = [], [], 0
    for seed in range(RUNS):
        spent, peak = ours(f"{arguments} -o {output} --seed {seed}")
        seconds.append(spent)
        found.append(read(output))
        memory = max(memory, peak)
        if seconds[0] > LONG:
            break
    return {"seconds": seconds, "found": found, "memory": memory}


def build():
    subprocess.run(["cargo", "build", "--release", "-q"], cwd=ROOT, check=True)
    command = "cargo bench --bench rays --no-run --message-format=json"
    lines = subprocess.run(
        command.split(), cwd=ROOT, check=True, capture_output=True, text=True
    ).stdout.splitlines()
    messages = [json.loads(line) for line in lines if line.startswith("{")]
    made = {m["target"]["name"]: m["executable"] for m in messages if m.get("executable")}
    return made["rays"]

"""What the workers share: a job on standard input, answers on standard output, clocks.

A worker is run by the Python of its peer's environment. It answers with one JSON object a
line; whatever a package prints itself goes to standard error.
"""

import json
import os
import resource
import sys

_answers = None


def job():
    global _answers
    _answers = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)
    return json.loads(sys.stdin.read())


def answer(**values):
    _answers.write(json.dumps(values) + "\n")
    _answers.flush()


def started():
    """Tells what it took to come so far: the interpreter and all that is imported."""
    answer(startup=cpu())


def cpu():
    """CPU seconds of this process and of those that it has run to their end."""
    own = resource.getrusage(resource.RUSAGE_SELF)
    others = resource.getrusage(resource.RUSAGE_CHILDREN)
    return own.ru_utime + own.ru_stime + others.ru_utime + others.ru_stime


def peak():
    """The most memory that one process has used so far, in bytes."""
    own = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    others = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss
    return 1024 * max(own, others)


#: What takes longer than this is measured once, CPU seconds.
LONG = 3.0


def timed(runs, work):
    """CPU seconds of each run, and what each found; a long one is not repeated."""
    seconds, found = [], []
    for run in range(runs):
        start = cpu()
        found.append(work(run))
        seconds.append(cpu() - start)
        if seconds[0] > LONG:
            break
    return seconds, found

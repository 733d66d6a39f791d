#!/usr/bin/env python3
"""Damaged media of every format through `vitrine-analyzer analyze`: whatever they are, there is an answer.

    mutated_test.py BUILD_DIRECTORY [SHARED_MEDIA] [--count N] [--first N] [--keep FOLDER]

Passes where no child crashed, none was stopped by a sanitizer, none took more than its limits, and each answer
is a record. Prints a table of the outcomes by format. A file at fault is kept in FOLDER.
"""
import argparse
import collections
import json
import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from mutated_media import draw_seeds, mutant

SANITIZER_EXIT = 99
PROCESSOR_SECONDS = 60  # of a child; these media have one second
MEMORY = 2 << 30  # bytes resident, with what the sanitizers need
STATES = ["ready", "waiting", "unsupported", "failed"]


def limits():
    resource.setrlimit(resource.RLIMIT_CPU, (PROCESSOR_SECONDS, PROCESSOR_SECONDS))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def environment():
    sanitizers = {
        "ASAN_OPTIONS": f"exitcode={SANITIZER_EXIT}:detect_leaks=0:detect_odr_violation=0:allocator_may_return_null=1",
        "UBSAN_OPTIONS": f"exitcode={SANITIZER_EXIT}:halt_on_error=1:print_stacktrace=1"}
    return os.environ | sanitizers | {"OMP_NUM_THREADS": "1"}


def analysed(analyzer, path, state):
    """As the daemon has it done. -> (outcome, processor seconds, bytes resident, what was said)"""
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as complaint:
        command = [analyzer, "--state.directory", str(state), "analyze", "--grow", "--keep", str(path)]
        child = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=out, stderr=complaint, env=environment(),
                                 preexec_fn=limits)
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        out.seek(0)
        complaint.seek(0)
        answer, said = out.read(), complaint.read().decode(errors="replace")
    seconds, memory = usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024
    return outcome(child.returncode, answer, seconds, memory), seconds, memory, said


def outcome(code, answer, seconds, memory):
    if code == SANITIZER_EXIT:
        return "sanitizer"
    if seconds >= PROCESSOR_SECONDS or memory > MEMORY:
        return "past its limits"
    if code < 0:
        return f"signal {-code}"
    if code != 0:
        return f"exit {code}"
    try:
        record = json.loads(answer.splitlines()[-1])
        if record["state"] not in STATES:
            return "no such state"
        if (record["state"] == "ready") == bool(record["reason"]) and not record["shots"]:
            return "no reason"
        return record["state"]
    except (ValueError, IndexError, KeyError):
        return "no record"


def shared_seeds(folder):
    """Real media beside the drawn ones, where they are there and small."""
    if folder is None or not folder.is_dir():
        return {}
    files = [p for name in ("formats", "codecs") for p in sorted((folder / name).glob("*")) if p.is_file()]
    return {f"real {p.suffix.lower()[1:]} {i}": p for i, p in enumerate(files) if p.stat().st_size < 400_000}


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("build", type=Path)
    parser.add_argument("shared", type=Path, nargs="?")
    parser.add_argument("--count", type=int, default=60)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--keep", type=Path)
    parser.add_argument("--real", action="store_true", help="mutate media of SHARED_MEDIA too")
    options = parser.parse_args()
    analyzer = options.build / "analyzer" / "vitrine-analyzer"
    table = collections.defaultdict(collections.Counter)
    faults, max_seconds, max_memory, begin = [], 0.0, 0, time.monotonic()
    with tempfile.TemporaryDirectory(prefix="vitrine-mutated-") as folder:
        seeds = draw_seeds(folder)
        if not {"jpg", "png", "mpeg4.mp4", "mpeg4.avi"} <= seeds.keys():
            sys.exit("the seeds cannot be drawn: is ffmpeg there?")
        for name, seed in seeds.items():
            state, *_, said = analysed(analyzer, seed, Path(folder) / "state")
            if state != "ready":
                sys.exit(f"the undamaged {name} is {state}: {said[-2000:]}")
        if options.real:
            seeds |= shared_seeds(options.shared)
        seen = 0
        for number in range(options.first, options.first + options.count):
            form, mutation, data = mutant(number, seeds)
            path = Path(folder) / f"{number}-{mutation}.bin"
            path.write_bytes(data)
            try:
                state, seconds, memory, said = analysed(analyzer, path, Path(folder) / "state")
            except KeyboardInterrupt:  # what has been seen is told
                break
            seen += 1
            table[" ".join(form.split()[:2])][state] += 1
            max_seconds, max_memory = max(max_seconds, seconds), max(max_memory, memory)
            if state not in STATES:
                faults.append(f"{number} {form} {mutation}: {state}\n{said[-3000:]}")
                print(faults[-1], file=sys.stderr, flush=True)
                if options.keep:
                    options.keep.mkdir(parents=True, exist_ok=True)
                    (options.keep / path.name).write_bytes(data)
            path.unlink()
    columns = STATES + sorted({state for row in table.values() for state in row} - set(STATES))
    print(f"{'format':16}" + "".join(f"{c:>16}" for c in columns))
    for form in sorted(table):
        print(f"{form:16}" + "".join(f"{table[form][c]:16}" for c in columns))
    print(f"{'all':16}" + "".join(f"{sum(row[c] for row in table.values()):16}" for c in columns))
    print(f"{seen} files of {len(seeds)} seeds in {time.monotonic() - begin:.0f} s; the longest took {max_seconds:.1f} s "
          f"of the processor, the largest {max_memory >> 20} MiB; {len(faults)} at fault")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

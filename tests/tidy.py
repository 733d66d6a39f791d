#!/usr/bin/env python3
"""clang-tidy over the sources of the programs, many at a time; sources that have passed before are left out.

    tidy.py BUILD [--all] [FILE...]   BUILD: a configured build; its compile commands are used
                                      --all: looks again at sources that have passed
                                      FILE: of base, analyzer or player; without any, all of them

Most of clang-tidy's time goes into the standard headers. So up to `BATCH` lines of sources are read as one source that
includes them, and the headers are read once a batch. Sources whose file-local names clash are put into different
batches. A batch that does not compile is looked at again, source by source.

A source that has passed is noted in ${XDG_CACHE_HOME:-~/.cache}/vitrine/tidy by an empty file. Its name is a hash of
the source, of every header of this tree that it includes, of .clang-tidy, of the compile flags and of the versions of
clang-tidy and of the packages.
"""
import argparse
import concurrent.futures
import hashlib
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
import time
from functools import cache
from pathlib import Path

TREE = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(TREE / "cmake"))
sys.dont_write_bytecode = True
from batches import batches

PROGRAMS = ("base", "analyzer", "player", "link")
BATCH = 2500  # lines
# The analyzer's paths take longer than all other checks together; a batch includes sources by intention.
CHECKS = "-clang-analyzer-*,-bugprone-suspicious-include"
HEADERS = rf"^{re.escape(str(TREE))}/({'|'.join(PROGRAMS)})/.*\.[ch]pp$"
KEPT_DAYS = 60
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.M)


@cache
def text_of(path):
    return path.read_text()


@cache
def includes_of(path):
    """The headers of this tree that a file includes, through others too."""
    found = set()
    for name in INCLUDE.findall(text_of(path)):
        header = TREE / name
        if header.is_file():
            found |= {header} | includes_of(header)
    return frozenset(found)


def compile_flags(build):
    """{source: the flags that it is compiled with}, without warnings and without headers that another compiler has precompiled."""
    flags = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        source = Path(entry["directory"], entry["file"]).resolve()
        if not source.is_relative_to(TREE) or source.relative_to(TREE).parts[0] not in PROGRAMS:
            continue
        words = shlex.split(entry["command"])
        words = words[next(i for i, word in enumerate(words) if word.startswith("-")):]
        kept, skipped = [], 0
        for word, after in zip(words, words[1:] + [""]):
            if skipped:
                skipped -= 1
            elif word in ("-o", "-c") or (word == "-include" and "cmake_pch" in after):
                skipped = 1
            elif word == "-isystem":
                kept.append(word + after)
                skipped = 1
            elif not word.startswith("-W"):  # the compiler's own warnings are the compiler's
                kept.append(word)
        flags[source] = kept
    return flags


def versions():
    """The versions of clang-tidy and of the packages that bring foreign headers."""
    packages = [line.split("#")[0].strip() for line in (TREE / "packaging/dependencies").read_text().splitlines()]
    packages = [name for name in packages if name and not name.startswith("[")]
    known = subprocess.run(["dpkg-query", "-W", *packages], capture_output=True, text=True)
    tool = subprocess.run(["clang-tidy", "--version"], capture_output=True, text=True, check=True)
    return tool.stdout + known.stdout


def keys(sources, flags):
    """{source: the name that it is kept under}"""
    common = hashlib.sha256((TREE / ".clang-tidy").read_bytes() + (CHECKS + versions()).encode())
    found = {}
    for source in sources:
        digest = common.copy()
        for path in [source, *sorted(includes_of(source))]:
            digest.update(f"{path.relative_to(TREE)}\0{text_of(path)}\0".encode())
        digest.update("\0".join(flags[source]).replace(str(TREE), ".").encode())
        found[source] = digest.hexdigest()
    return found


class Passed:
    """The sources that have passed before."""

    def __init__(self):
        self.folder = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "vitrine" / "tidy"
        self.folder.mkdir(parents=True, exist_ok=True)
        for path in self.folder.iterdir():
            if time.time() - path.stat().st_mtime > KEPT_DAYS * 86400:
                path.unlink(missing_ok=True)

    def knows(self, key):
        path = self.folder / key
        if not path.exists():
            return False
        path.touch()
        return True

    def add(self, key):
        (self.folder / key).touch()


def batches_of(sources):
    """Batches of sources of one program each, the largest first."""
    made = []
    for program in PROGRAMS:
        made += batches([source for source in sorted(sources) if source.relative_to(TREE).parts[0] == program], BATCH)
    return sorted(made, key=len, reverse=True)


def tidy(file, flags):
    """clang-tidy's status and findings."""
    done = subprocess.run(["clang-tidy", "--quiet", f"--config-file={TREE / '.clang-tidy'}", f"--checks={CHECKS}", f"--header-filter={HEADERS}", str(file), "--", *flags],
                          cwd=TREE, capture_output=True, text=True)
    return done.returncode, done.stdout


def look_at(sources, flags, folder):
    """[(sources, findings)] of a batch; no findings where it passes."""
    if len(sources) == 1:
        status, said = tidy(sources[0], flags[sources[0]])
        return [(sources, said if status else "")]
    batch = Path(folder) / f"{hashlib.sha256(str(sources).encode()).hexdigest()[:12]}.cpp"
    batch.write_text("".join(f'#include "{source}"\n' for source in sources))
    status, said = tidy(batch, list(dict.fromkeys(flag for source in sources for flag in flags[source])))
    if status == 0:
        return [(sources, "")]
    if "clang-diagnostic-error" in said:
        first = next(line for line in said.splitlines() if "clang-diagnostic-error" in line)
        print(f"{len(sources)} sources cannot be read together and are looked at one by one: {first}", flush=True)
        return [found for source in sources for found in look_at([source], flags, folder)]
    return [(sources, said)]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=Path)
    parser.add_argument("files", type=Path, nargs="*")
    parser.add_argument("--all", action="store_true")
    options = parser.parse_args()
    flags = compile_flags(options.build)
    wanted = sorted({file.resolve() for file in options.files} if options.files else flags)
    if unknown := [str(source) for source in wanted if source not in flags]:
        sys.exit(f"not compiled in {options.build}: {', '.join(unknown)}")
    key_of, passed = keys(wanted, flags), Passed()
    due = [source for source in wanted if options.all or not passed.knows(key_of[source])]
    found = 0
    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as workers:
        jobs = [workers.submit(look_at, batch, flags, folder) for batch in batches_of(due)]
        for job in concurrent.futures.as_completed(jobs):
            for sources, said in job.result():
                if said:
                    found += 1
                    print(said, flush=True)
                else:
                    for source in sources:
                        passed.add(key_of[source])
    print(f"clang-tidy: {len(due)} of {len(wanted)} sources in {len(jobs)} batches; the others have passed before"
          + (f"; {found} batches with findings" if found else ""))
    sys.exit(found != 0)


if __name__ == "__main__":
    main()

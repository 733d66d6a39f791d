#!/usr/bin/env python3
"""Boxes whose libraries of mathematics round otherwise draw the same cells of an act.

    other_libm_test.py ACT_FRAMES [SEEDS [OTHER_ACT_FRAMES]]

glibc has two sets of functions, for processors with fused multiplication and without; GLIBC_TUNABLES chooses. On a
processor without it both are the same: then the test prints NOT RUN.

OTHER_ACT_FRAMES is the same program, built with other options of the compiler. -march=x86-64-v3 -ffp-contract=fast adds
products that were not rounded, as compilers do for ARM.
"""
import json
import os
import subprocess
import sys

PROGRAM = sys.argv[1]
OTHER = sys.argv[3] if len(sys.argv) > 3 else PROGRAM
SEEDS = int(sys.argv[2]) if len(sys.argv) > 2 else 1
WITHOUT = {**os.environ, "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-FMA,-FMA4,-AVX"}
SINES = "import math; print([math.sin(k * 0.137) for k in range(100000)])"
SKIPPED = 77
NEAR = 0.5  # px


def run(*words, text=None, environment=None):
    command = [OTHER if environment else PROGRAM, *map(str, words)]
    return subprocess.run(command, input=text, capture_output=True, text=True, check=True, env=environment).stdout


def distance(point, outline):
    """From a point to an outline."""
    nearest = float("inf")
    for (ax, ay), (bx, by) in zip(outline, outline[1:] + outline[:1]):
        dx, dy = bx - ax, by - ay
        squared = dx * dx + dy * dy
        share = 0 if squared == 0 else min(1, max(0, ((point[0] - ax) * dx + (point[1] - ay) * dy) / squared))
        nearest = min(nearest, ((point[0] - ax - dx * share) ** 2 + (point[1] - ay - dy * share) ** 2) ** 0.5)
    return nearest


def apart(one, other):
    """By how far two outlines are apart at most, px."""
    if len(one) == len(other):
        even = max(max(abs(a - b) for a, b in zip(p, q)) for p, q in zip(one, other))
        if even <= NEAR:
            return even
    return max(max(distance(p, b) for p in a) for a, b in ((one, other), (other, one)))


def size(outline):
    return abs(sum(p[0] * q[1] - q[0] * p[1] for p, q in zip(outline, outline[1:] + outline[:1]))) / 2


def farthest(one, other):
    """The largest difference of two frames, px. Parts of less than a pixel are not seen."""
    assert [item["source"] for item in one] == [item["source"] for item in other]
    most = 0
    for a, b in zip(one, other):
        assert abs(a["alpha"] - b["alpha"]) < 1e-6
        most = max(most, *(abs(x - y) for x, y in zip(a["at"], b["at"])))
        cells = [[outline for outline in item["cell"] if size(outline) > 1] for item in (a, b)]
        assert len(cells[0]) == len(cells[1]), f"{len(cells[0])} and {len(cells[1])} parts"
        most = max([most, *(apart(p, q) for p, q in zip(*cells))])
    return most


def main():
    if len({subprocess.run([sys.executable, "-c", SINES], env=env, capture_output=True).stdout for env in (None, WITHOUT)}) == 1:
        print("NOT RUN: both sets of functions are the same on this processor")
        return SKIPPED
    most, frames, planned_apart = 0, 0, 0
    for seed in range(2, SEEDS + 2):
        acts = run("make", seed)
        planned_apart += acts != run("make", seed, environment=WITHOUT)
        drawn = [run("draw", text=acts, environment=environment).splitlines() for environment in (None, WITHOUT)]
        assert len(drawn[0]) == len(drawn[1]) > 50
        for k, lines in enumerate(zip(*drawn)):
            if lines[0] == lines[1]:
                continue
            off = farthest(*map(json.loads, lines))
            assert off <= NEAR, f"seed {seed}, frame {k}: {off} px"
            most = max(most, off)
        frames += len(drawn[0])
    print(f"{frames} frames of acts, cells at most {most:.2g} px apart; {planned_apart} of {SEEDS} walls are planned otherwise")
    return 0


if __name__ == "__main__":
    sys.exit(main())

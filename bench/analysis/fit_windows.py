#!/usr/bin/python3
"""Fits the weights of the plain method's windows (analyzer/saliency/subject_windows.cpp) and prints them.

    bench/analysis/fit_windows.py TRAIN.facts HELD_BACK.facts [--sharpness 20]

Both files are what `window_facts` writes of the pictures of analyzer/models/student/pictures.tsv: u2netp's box of the
subject is the truth, where u2netp is sure. A window is the likelier, the more it has in common with that box: wanted
is the exponential of `sharpness` times the common share of both areas. The weights make what the analyzer computes,
the exponential of a weighted sum of facts, as near to that as it can be (least cross entropy). There is one best
answer, which Newton's method finds. The weight of heads is given, as u2netp does not know that a face must be whole.
The pictures held back only judge. Needs python3-numpy.
"""

import argparse
import itertools
import re
from pathlib import Path

import numpy

GRID, FACTS = 12, 37
HEAD, HEAD_WEIGHT = 12, 5.0  # the fact "share of heads inside", and its weight
SPANS = [(begin, end) for begin in range(GRID) for end in range(begin + 1, GRID + 1)]
# Left, top, right and bottom of each window, shares of the sides, in the order of subject_windows().
WINDOWS = numpy.array([(x[0], y[0], x[1], y[1]) for y, x in itertools.product(SPANS, SPANS)]) / GRID
SOURCE = Path(__file__).resolve().parents[2] / "analyzer/saliency/subject_windows.cpp"


class Pictures:
    """The facts of all windows of each picture, and how much each has in common with the subject's box."""

    def __init__(self, file):
        rows = numpy.memmap(file, numpy.float32, "r").reshape(-1, 4 + len(WINDOWS) * FACTS)
        self.facts = [row[4:].reshape(len(WINDOWS), FACTS) for row in rows]
        self.common = [common_share(row[:4]) for row in rows]

    def wanted(self, sharpness):
        return [likelihoods(sharpness * common) for common in self.common]


def common_share(box):
    """Of each window and a box: the area common to both, by the area of either."""
    begin, end = numpy.maximum(WINDOWS[:, :2], box[:2]), numpy.minimum(WINDOWS[:, 2:], box[2:])
    common = numpy.clip(end - begin, 0, None).prod(axis=1)
    return common / ((WINDOWS[:, 2:] - WINDOWS[:, :2]).prod(axis=1) + (box[2:] - box[:2]).prod() - common)


def likelihoods(scores):
    values = numpy.exp(scores - scores.max())
    return values / values.sum()


class Fit:
    """Cross entropy of the windows' likelihoods, in the mean of pictures, and a little for large weights."""

    RIDGE = 1e-3

    def __init__(self, pictures, sharpness):
        self.pairs = list(zip(pictures.facts, pictures.wanted(sharpness)))

    def loss(self, weights):
        loss = self.RIDGE / 2 * weights @ weights
        for facts, wanted in self.pairs:
            scores = facts @ weights
            highest = scores.max()
            loss += (highest + numpy.log(numpy.exp(scores - highest).sum()) - wanted @ scores) / len(self.pairs)
        return loss

    def newton_step(self, weights):
        slope, bend = self.RIDGE * weights, self.RIDGE * numpy.eye(FACTS)
        for facts, wanted in self.pairs:
            found = likelihoods(facts @ weights)
            mean = found @ facts
            slope += (mean - wanted @ facts) / len(self.pairs)
            bend += ((facts * found[:, None]).T @ facts - numpy.outer(mean, mean)) / len(self.pairs)
        free = numpy.arange(FACTS) != HEAD
        step = numpy.zeros(FACTS)
        step[free] = numpy.linalg.solve(bend[free][:, free], slope[free])
        return step

    def run(self):
        weights = numpy.zeros(FACTS)
        weights[HEAD] = HEAD_WEIGHT
        loss = self.loss(weights)
        gain = 1
        while gain > 1e-5:
            step = self.newton_step(weights)
            while (new := self.loss(weights - step)) > loss and abs(step).max() > 1e-4:
                step /= 2
            gain = loss - new
            if gain > 0:
                weights, loss = weights - step, new
        return weights


def judge(pictures, weights):
    """Gives the mean common share of the windows as they are weighed, and of the likeliest, as text."""
    weighed, best = [], []
    for facts, common in zip(pictures.facts, pictures.common):
        scores = facts @ weights
        weighed.append(likelihoods(scores) @ common)
        best.append(common[scores.argmax()])
    return f"{numpy.mean(weighed):.3f} weighed, {numpy.mean(best):.3f} the likeliest"


def weights_of_today():
    table = re.search(r"weights\{(.*?)\};", SOURCE.read_text(encoding="utf-8"), re.DOTALL).group(1)
    return numpy.array([float(value) for value in re.findall(r"(-?\d+\.\d+)F", table)])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("train", help="facts of the pictures to fit to")
    parser.add_argument("held_back", help="facts of pictures that only judge")
    parser.add_argument("--sharpness", type=float, default=20)
    options = parser.parse_args()
    train, held = Pictures(options.train), Pictures(options.held_back)
    weights = Fit(train, options.sharpness).run()
    for name, values in (("of the source", weights_of_today()), ("fitted", weights)):
        print(f"{name}: {len(train.facts)} fitted to: {judge(train, values)}")
        print(f"{name}: {len(held.facts)} held back: {judge(held, values)}")
    print("\n".join(f"    {weight:.3f}F," for weight in weights))


if __name__ == "__main__":
    main()

#!/usr/bin/python3
"""Trains the student to answer as the teacher does.

    train.py FOLDER u2netp.onnx student.onnx [--seconds 490] [--batch 96] [--repeats 7]

FOLDER is what fetch_pictures.py has written. The pictures held back are never trained on; they only judge. Needs
python3-torch, python3-onnx and python3-pil of Debian. The student that comes with the analyzer was trained on a
graphics card (NVIDIA H200, 490 s, PyTorch 2.11); it is chance that makes another one differ.
"""

import argparse
import collections
import copy
import math
import pathlib
import time

import numpy
import PIL.Image
import torch
import torch.nn as nn
import torch.nn.functional as functional

from export_student import write_onnx
from student import Student
from teacher import Teacher, normal
from views import FULL, in_other_light, part_of, with_other_subjects

Score = collections.namedtuple("Score", "error overlap")


def read_pictures(folder, device):
    """Gives the pictures of a folder as bytes of N x 3 x 320 x 320 px; None where there is none."""
    pictures = []
    for file in sorted(folder.glob("*.webp")):
        picture = PIL.Image.open(file).convert("RGB").resize((FULL, FULL), PIL.Image.BICUBIC)
        pictures.append(torch.from_numpy(numpy.array(picture)).permute(2, 0, 1).contiguous())
    return torch.stack(pictures).to(device) if pictures else None


def small(pictures):
    return functional.avg_pool2d(pictures, 2)


def loss_of(logits, wanted):
    """Cross entropy, and the share of both areas that is not common to both."""
    found = torch.sigmoid(logits)
    common = torch.minimum(found, wanted).sum(dim=(1, 2, 3))
    either = torch.maximum(found, wanted).sum(dim=(1, 2, 3))
    apart = 1 - (common + 20) / (either + 20)
    return functional.binary_cross_entropy_with_logits(logits, wanted) + apart.mean()


class Pool:
    """Views with the teacher's answers. Each is learnt several times, in other light, mirrored or not."""

    def __init__(self, size, device):
        self.pictures = torch.zeros(size, 3, FULL // 2, FULL // 2, dtype=torch.uint8, device=device)
        self.maps = torch.zeros(size, 1, FULL // 2, FULL // 2, dtype=torch.uint8, device=device)
        self.count = 0

    def add(self, pictures, maps):
        size = len(self.pictures)
        places = (torch.arange(len(pictures), device=pictures.device) + self.count) % size
        self.pictures[places] = (pictures * 255).round().byte()
        self.maps[places] = (maps * 255).round().byte()
        self.count += len(pictures)

    def draw(self, count):
        held = min(self.count, len(self.pictures))
        places = torch.randint(held, (count,), device=self.maps.device)
        pictures, maps = self.pictures[places].float() / 255, self.maps[places].float() / 255
        mirrored = torch.rand(count, 1, 1, 1, device=maps.device) < 0.5
        pictures = torch.where(mirrored, pictures.flip(3), pictures)
        return pictures, torch.where(mirrored, maps.flip(3), maps)


class Hints(nn.Module):
    """What the student's stages, brought to the teacher's channels, lack of the teacher's stages of that size."""

    # Of the teacher's eleven stages those of 80, 40, 20 and 10 px of the encoder, and of 20, 40 and 80 px of
    # the decoder.
    ENCODED, DECODED = (2, 3, 4, 5), (8, 7, 6)

    def __init__(self, width):
        super().__init__()
        count = len(self.ENCODED) + len(self.DECODED)
        self.project = nn.ModuleList([nn.Conv2d(width, 64, 1) for _ in range(count)])

    def forward(self, encoded, decoded, stages):
        pairs = list(zip(encoded, self.ENCODED)) + list(zip(decoded, self.DECODED))
        lacks = 0
        for project, (own, stage) in zip(self.project, pairs):
            wanted = stages[stage].float()
            spread = wanted.std(dim=(0, 2, 3), keepdim=True) + 1e-3
            lacks = lacks + functional.smooth_l1_loss(project(own.float()) / spread, wanted / spread)
        return lacks / len(pairs)


class Training:
    """The student learns views of the pictures, each when the teacher has seen it and several times more."""

    def __init__(self, pictures, teacher, options):
        self.pictures, self.teacher, self.options = pictures, teacher, options
        self.device = pictures.device
        self.student = Student().to(self.device, memory_format=torch.channels_last)
        self.hints = Hints(self.student.narrow[0].in_channels).to(self.device)
        self.mean = copy.deepcopy(self.student)  # of the weights of the last steps
        parameters = list(self.student.parameters()) + list(self.hints.parameters())
        self.optimizer = torch.optim.AdamW(parameters, lr=options.rate, weight_decay=1e-4)
        self.pool = Pool(options.pool, self.device)
        self.last = None  # the teacher's last views and answers

    def run(self):
        begun = time.time()
        step = 0
        shown = begun
        while (spent := (time.time() - begun) / self.options.seconds) < 1:
            rate = self.options.rate * min(1, (step + 1) / 200) * (0.5 + 0.5 * math.cos(math.pi * spent))
            for group in self.optimizer.param_groups:
                group["lr"] = max(rate, 1e-5)
            self.learn_new()
            for _ in range(self.options.repeats):
                self.learn_again()
            step += 1
            self.add_to_mean(max(0.01, 1 / step))
            if time.time() - shown > self.options.seconds / 8:
                shown = time.time()
                self.report(step, shown - begun)
        self.set_normalisation()
        return self.mean

    def learn_new(self):
        chosen = torch.randint(len(self.pictures), (self.options.batch,), device=self.device)
        views = part_of(self.pictures[chosen].float() / 255)
        if self.last is not None:
            views = with_other_subjects(views, *self.last)
        maps, stages = self.teacher.look(views)
        self.last = views, maps
        self.pool.add(small(views), maps)
        self.learn(small(views), maps, stages)

    def learn_again(self):
        self.learn(*self.pool.draw(self.options.batch), None)

    def learn(self, pictures, maps, stages):
        with torch.autocast(self.device.type, torch.bfloat16, enabled=self.device.type == "cuda"):
            seen = normal(in_other_light(pictures))
            encoded, decoded = self.student.stages(seen)
            logits = self.student.map_of(seen, decoded)
            sides = [side(own) for side, own in zip(self.student.sides, decoded + encoded[-1:])]
        loss = loss_of(logits.float(), maps)
        for side in sides:
            coarse = functional.adaptive_avg_pool2d(maps, side.shape[-2:])
            loss = loss + 0.2 * functional.binary_cross_entropy_with_logits(side.float(), coarse)
        if stages is not None:
            loss = loss + 0.3 * self.hints(encoded, decoded, stages)
        self.optimizer.zero_grad(set_to_none=True)
        loss.backward()
        nn.utils.clip_grad_norm_(self.student.parameters(), 2)
        self.optimizer.step()
        self.loss = loss.detach()

    @torch.no_grad()
    def add_to_mean(self, share):
        for mean, new in zip(self.mean.parameters(), self.student.parameters()):
            mean.lerp_(new, share)

    def report(self, step, seconds):
        print(f"{seconds:.0f} s, {step} looks of the teacher, loss {float(self.loss):.3f}", flush=True)

    @torch.no_grad()
    def set_normalisation(self):
        """The mean of the weights needs the means and deviations of its own tensors."""
        for layer in self.mean.modules():
            if isinstance(layer, nn.BatchNorm2d):
                layer.reset_running_stats()
                layer.momentum = None
        self.mean.train()
        for _ in range(self.options.settling):
            self.mean(normal(self.pool.draw(self.options.batch)[0]))
        self.mean.eval()


@torch.no_grad()
def judge(student, teacher, pictures, batch=32):
    """Mean distance of the maps, and how much of the areas above .35 is common."""
    student.eval()
    errors, overlaps = [], []
    for part in pictures.split(batch):
        views = part.float() / 255
        wanted, _ = teacher.look(views)
        found = torch.sigmoid(student(normal(small(views))))
        errors.append((found - wanted).abs().mean(dim=(1, 2, 3)))
        one, other = found > 0.35, wanted > 0.35
        common = (one & other).sum(dim=(1, 2, 3)).float()
        overlaps.append((common + 1) / ((one | other).sum(dim=(1, 2, 3)).float() + 1))
    return Score(torch.cat(errors).mean().item(), torch.cat(overlaps).mean().item())


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("pictures", type=pathlib.Path, help="folder that fetch_pictures.py has written")
    parser.add_argument("teacher", help="u2netp.onnx")
    parser.add_argument("output", help="ONNX file to write")
    parser.add_argument("--seconds", type=float, default=490)
    parser.add_argument("--batch", type=int, default=96)
    parser.add_argument("--repeats", type=int, default=7, help="times each view is learnt again")
    parser.add_argument("--rate", type=float, default=2.5e-3)
    parser.add_argument("--pool", type=int, default=100000, help="views that are kept; 102 kB each")
    parser.add_argument("--settling", type=int, default=60)
    options = parser.parse_args()
    torch.manual_seed(1)
    torch.backends.cudnn.benchmark = True
    device = torch.device("cuda" if torch.cuda.is_available() else "cpu")
    pictures = read_pictures(options.pictures / "train", device)
    held = read_pictures(options.pictures / "held_back", device)
    print(f"{len(pictures)} pictures to train on, {0 if held is None else len(held)} held back", flush=True)
    teacher = Teacher(options.teacher, device)
    student = Training(pictures, teacher, options).run()
    for name, part in (("trained on", pictures[:500]), ("held back", held)):
        if part is not None:
            score = judge(student, teacher, part)
            print(f"{name}: error {score.error:.4f}, common {score.overlap:.3f}", flush=True)
    write_onnx(student, options.output)


if __name__ == "__main__":
    main()

#!/usr/bin/python3
"""Fetches the pictures on which the student was trained, from the repositories of sources.tsv.

    fetch_pictures.py FOLDER [--clones FOLDER]

Writes FOLDER/train and FOLDER/held_back, each picture with 320 px on its shorter side, as no network sees more. A
picture that is not the one of pictures.tsv ends the program. Needs git, python3-pil and 8 GB for the clones.
"""
import argparse
import csv
import hashlib
import io
import subprocess
import sys
from pathlib import Path

from PIL import Image, ImageOps

HERE = Path(__file__).resolve().parent
SIDE = 320  # px, of the shorter side


def rows(file):
    with open(HERE / file, encoding="utf-8", newline="") as text:
        return list(csv.DictReader(text, delimiter="\t", quoting=csv.QUOTE_NONE))


def clone(repository, folder):
    """The git directory of a repository; it is cloned where it is not there."""
    place = folder / repository.replace("/", "+")
    if not place.exists():
        address = f"https://github.com/{repository}.git"
        subprocess.run(["git", "clone", "--quiet", "--bare", "--filter=blob:none", address, str(place)], check=True)
    return place


def content(place, commit, path, digest):
    shown = subprocess.run(["git", "--git-dir", str(place), "show", f"{commit}:{path}"], check=True, capture_output=True)
    if hashlib.sha256(shown.stdout).hexdigest() != digest:
        sys.exit(f"{place.name}: {path} is not the picture that it was")
    return shown.stdout


def made_small(data):
    picture = Image.open(io.BytesIO(data))
    if picture.format == "JPEG" and min(picture.size) > 1100:
        picture.draft("RGB", (512, 512))
    picture = ImageOps.exif_transpose(picture).convert("RGB")
    scale = SIDE / min(picture.size)
    if scale < 1:
        picture = picture.resize([max(SIDE, round(side * scale)) for side in picture.size], Image.LANCZOS)
    return picture


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("--clones", type=Path, help="folder of clones (FOLDER/clones)")
    options = parser.parse_args()
    clones = options.clones or options.folder / "clones"
    sources = {row["repository"]: row for row in rows("sources.tsv")}
    for number, row in enumerate(rows("pictures.tsv")):
        source = sources[row["repository"]]
        folder = options.folder / ("held_back" if source["held back"] == "yes" else "train")
        folder.mkdir(parents=True, exist_ok=True)
        data = content(clone(row["repository"], clones), source["commit"], row["path"], row["sha256"])
        made_small(data).save(folder / f"{number:05}.webp", quality=90, method=2)


if __name__ == "__main__":
    main()

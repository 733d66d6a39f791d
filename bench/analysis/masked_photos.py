#!/usr/bin/env python3
"""Makes a folder of photographs with drawn masks, for `analysis_bench --only masks --masks FOLDER`.

    bench/analysis/masked_photos.py PETS.git CATS.git FOLDER

The first two are clones of the repositories below, at least at the commits named. The photographs are no part of this tree.

- pets: 370 pictures of the Oxford-IIIT Pet Dataset (Parkhi et al. 2012, CC BY-SA 4.0), outlines made of its trimaps, without
  their borders; where a trimap falls into pieces the outline is the largest of them.
- cats: Feral Cat Segmentation (Paul M. Cashman, Cornell Feline Health Center, 2023, public domain), the parts `valid` and
  `test`, which are not augmented; stretched to squares there. One polygon a cat.

100 pets, 60 pictures with one cat and 60 with several are taken, spread evenly. In the order of names the even ones of each
group are there to tune on, the odd ones are held back. None is of ECSSD, DAVIS, MIT1003 or COCO. Needs python3-opencv.
"""
import hashlib
import subprocess
import sys
from pathlib import Path

import cv2
import numpy

PETS = {"commit": "38c4dfa48f34344f2e73eebbb93974928943a8c8",  # github: LTSACH/AILearningHub
        "photos": ["datasets/oxford-pets/data/sample_images"], "outlines": "datasets/oxford-pets/data/sample_annotations/yolo/segmentation/labels",
        "sha256": "34b9088704071b2c69cf95d9382848ff5661cfff37496d5ea291de4d726e0dcf"}
CATS = {"commit": "c7cdfa43c095a1f9d1892754bcc201e971e375f1",  # github: pcashman21/feral-cat-segmentation-dataset-and-model
        "photos": ["feral-cat-segmentation.v1i.yolov8/valid/images", "feral-cat-segmentation.v1i.yolov8/test/images"], "outlines": None,
        "sha256": "9b335caec9635082c8585ca1a8f07c54c537769d2ccd7edecc14dd27be4a96cd"}
GROUPS = {"pet": 100, "cat": 60, "cats": 60}  # pictures


def git(repository, *words):
    return subprocess.run(["git", "--git-dir", str(repository), *words], check=True, capture_output=True).stdout


def pairs(repository, source):
    """The names of each photograph and of its outlines."""
    for folder in source["photos"]:
        names = git(repository, "ls-tree", "-r", "--name-only", source["commit"], folder + "/").decode().split("\n")
        for name in sorted(name for name in names if name.endswith(".jpg")):
            labels = source["outlines"] or folder.replace("/images", "/labels")
            yield name, f"{labels}/{Path(name).stem}.txt"


def mask_of(outlines, shape):
    """255 on the subjects, and how many there are."""
    mask, count = numpy.zeros(shape[:2], numpy.uint8), 0
    for line in outlines.decode().splitlines():
        numbers = [float(word) for word in line.split()[1:]]
        if len(numbers) < 6:
            continue
        corners = numpy.array(numbers).reshape(-1, 2) * [shape[1], shape[0]]
        cv2.fillPoly(mask, [corners.astype(numpy.int32)], 255)
        count += 1
    return mask, count


def pictures(repository, source):
    """Name, bytes, mask and number of subjects of each photograph. Ends the program where the source is another one."""
    seen = hashlib.sha256()
    found = []
    for photo, outlines in pairs(repository, source):
        data, words = git(repository, "show", f"{source['commit']}:{photo}"), git(repository, "show", f"{source['commit']}:{outlines}")
        seen.update(data + words)
        image = cv2.imdecode(numpy.frombuffer(data, numpy.uint8), cv2.IMREAD_COLOR)
        mask, count = mask_of(words, image.shape)
        if count > 0:
            found.append((Path(photo).stem, data, mask, count))
    if seen.hexdigest() != source["sha256"]:
        sys.exit(f"{repository}: not the pictures that were measured: {seen.hexdigest()}")
    return found


def spread(items, count):
    return [items[int((i + 0.5) * len(items) / count)] for i in range(count)]


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    pets, cats = pictures(sys.argv[1], PETS), pictures(sys.argv[2], CATS)
    groups = {"pet": pets, "cat": [c for c in cats if c[3] == 1], "cats": [c for c in cats if c[3] > 1]}
    for group, count in GROUPS.items():
        folder = Path(sys.argv[3]) / group
        folder.mkdir(parents=True, exist_ok=True)
        for i, (name, data, mask, _) in enumerate(spread(groups[group], count)):
            (folder / f"{i:03}_{name}.jpg").write_bytes(data)
            cv2.imwrite(str(folder / f"{i:03}_{name}.png"), mask)


if __name__ == "__main__":
    main()

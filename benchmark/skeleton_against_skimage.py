#!/usr/bin/python3
"""Thinning against scikit-image's skeletonize_3d, on the same bounding boxes in one run.

The two take turns, so that what else the machine does meets both; the least and the median of all
turns are told, in milliseconds. Needs Debian's python3-skimage, which the package itself does not.

    benchmark/skeleton_against_skimage.py <build folder>/benchmark/skeleton_benchmark
"""
import argparse
import json
import pathlib
import statistics
import subprocess
import tempfile
import time

import numpy as np
from skimage.morphology import skeletonize_3d


def read_box(path):
    """The hull's bounding box with a margin of one voxel, as uint8."""
    data = path.read_bytes()
    size, count = np.frombuffer(data, "<i4", 3), np.frombuffer(data, "<i4", 1, 12)[0]
    volume = np.zeros(int(np.prod(size)), np.uint8)
    volume[np.frombuffer(data, "<u4", count, 16)] = 1
    volume = volume.reshape(size[::-1])
    corners = [(axis.min(), axis.max() + 1) for axis in np.nonzero(volume)]
    return np.pad(volume[tuple(slice(*c) for c in corners)], 1)


def time_ours(program, folder, voxels):
    out = subprocess.run(
        [program, f"--write_hulls={folder}", f"--benchmark_filter=^thinHull/{voxels}$",
         "--benchmark_min_time=0.1", "--benchmark_format=json"],
        check=True, capture_output=True, text=True).stdout
    return json.loads(out)["benchmarks"][0]["cpu_time"] / 1e3


def time_skimage(box):
    start = time.process_time()
    skeletonize_3d(box)
    return (time.process_time() - start) * 1e3


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", help="path of skeleton_benchmark")
    parser.add_argument("--turns", type=int, default=7)
    options = parser.parse_args()
    for voxels in (64, 128):
        ours, theirs = [], []
        with tempfile.TemporaryDirectory() as folder:
            for _ in range(options.turns):
                ours.append(time_ours(options.program, folder, voxels))
                box = read_box(pathlib.Path(folder) / f"hull_{voxels}.vox")
                theirs.append(min(time_skimage(box) for _ in range(3)))
        print(f"{voxels}^3, box {'x'.join(map(str, box.shape[::-1]))}, {int(box.sum())} voxels: "
              f"thinner {min(ours):.3f} ({statistics.median(ours):.3f}), "
              f"scikit-image {min(theirs):.2f} ({statistics.median(theirs):.2f}), "
              f"ratio {min(theirs) / min(ours):.1f} "
              f"({statistics.median(theirs) / statistics.median(ours):.1f})")


if __name__ == "__main__":
    main()

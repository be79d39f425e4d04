#!/usr/bin/python3
"""What this machine holds: cameras, pixels and voxels, one after the other, each as a ratio to the same
recording of eight cameras of 640 x 480 at 30 mm in the same run.

    benchmark/scaling.py OUT [--rounds 3]

OUT keeps the recordings (raw images, up to 9 GB each), so that a second run only measures. Each row is run
--rounds times, rows taking turns, and the quickest counts. The figures are printed as a Markdown table."""
import argparse
import os
import pathlib
import re
import subprocess
import sys

import yaml

PACKAGE = pathlib.Path(__file__).resolve().parent.parent
PROGRAMS = PACKAGE / 'devel' / 'lib' / 'markerless_mocap'
SCENE = {'motion': 'wave_and_walk', 'fps': 30, 'duration': 5, 'seed': 91, 'appearance_seed': 91}
CAPTURES = {
    '4 cameras': {'rig': 'ring4', 'width': 640, 'height': 480},
    '8 cameras': {'rig': 'ring8', 'width': 640, 'height': 480},
    '16 cameras': {'rig': 'ring16', 'width': 640, 'height': 480},
    '8 of 1280 x 720': {'rig': 'ring8', 'width': 1280, 'height': 720},
    '8 of 1920 x 1080': {'rig': 'ring8', 'width': 1920, 'height': 1080},
}
ROWS = [  # capture, what else, options, arguments
    ('8 cameras', '30 mm', {}, []),
    ('8 cameras', 'poses only', {}, ['--poses-only']),
    ('8 cameras', '15.6 mm', {'visual_hull': {'pitch': 0.015625}}, []),
    ('8 cameras', 'averaged down to 320 x 240', {'silhouette': {'max_megapixels': 0.1}}, []),
    ('4 cameras', '30 mm', {}, []),
    ('16 cameras', '30 mm', {}, []),
    ('8 of 1280 x 720', '30 mm', {}, []),
    ('8 of 1920 x 1080', '30 mm, averaged down to 960 x 540', {}, []),
]
STEPS = ('reading', 'silhouette', 'visual_hull', 'body_segmentation', 'pose_tree', 'pose_fitting')


def render(name, folder):
    bag = folder / (re.sub(r'\W+', '_', name) + '.bag')
    if not bag.exists():
        config, draft = bag.with_suffix('.yaml'), bag.with_suffix('.part')
        config.write_text(yaml.safe_dump({'virtual_studio': {**SCENE, **CAPTURES[name]}}))
        print(f'rendering {name}', file=sys.stderr)
        subprocess.run([PROGRAMS / 'render_capture', draft, '--config', config, '--images', 'raw',
                        '--compression', 'none'], check=True, stdout=subprocess.DEVNULL)
        draft.rename(bag)
    return bag


def measure(bag, options, arguments, folder):
    """ms per frame set: by step, and in all after the background was learned; greatest memory, MB."""
    config, out = folder / 'options.yaml', folder / 'result.bag'
    config.write_text(yaml.safe_dump(options))
    read = subprocess.run(['/bin/cat', bag], stdout=subprocess.DEVNULL)  # into the page cache
    process = subprocess.Popen([PROGRAMS / 'mocap_offline', bag, out, '--config', config, *arguments],
                               stderr=subprocess.PIPE, text=True)
    text = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    if status or read.returncode:
        raise SystemExit(f'scaling: mocap_offline failed on {bag}')
    steps = {step: float(value) for step, value in re.findall(r'^  (\w+) +([\d.]+) ms per', text, re.M)}
    speed = float(re.search(r'^speed +([\d.]+)', text, re.M)[1])
    lost = int(re.search(r'(\d+) lost', text)[1])
    return {'speed': speed, 'steps': steps, 'memory': usage.ru_maxrss / 1024, 'lost': lost,
            'cpu': usage.ru_utime + usage.ru_stime}


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('out', type=pathlib.Path)
    parser.add_argument('--rounds', type=int, default=3)
    args = parser.parse_args()
    args.out.mkdir(parents=True, exist_ok=True)
    bags = {name: render(name, args.out) for name in CAPTURES}
    best = {}
    for _ in range(args.rounds):
        for row in ROWS:
            found = measure(bags[row[0]], row[2], row[3], args.out)
            if row[:2] not in best or found['speed'] > best[row[:2]]['speed']:
                best[row[:2]] = found
    reference = best[ROWS[0][:2]]['speed']
    print('| recording | | frame sets/s | ratio | ' + ' | '.join(STEPS) + ' (ms) | lost | MB |')
    print('|---|---|' + '---:|' * (len(STEPS) + 4))
    for row in ROWS:
        found = best[row[:2]]
        steps = ' | '.join('%.1f' % found['steps'].get(step, 0) for step in STEPS)
        print('| %s | %s | %.0f | %.2f | %s | %d | %.0f |' %
              (*row[:2], found['speed'], found['speed'] / reference, steps, found['lost'], found['memory']))


if __name__ == '__main__':
    main()

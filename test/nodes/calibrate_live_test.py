#!/usr/bin/python3
"""calibrate_rig --live before two cameras that see a drawn board: it says what is missing, stops by
itself when the views suffice and the board lies on the floor, and writes the rig."""
import os
import re
import shutil
import subprocess
import tempfile
import threading
import unittest

import cv2
import numpy
import rospy
import rostest
import yaml
from sensor_msgs.msg import Image

SIZE, FOCAL = (480, 360), 420.0
COLUMNS, ROWS, SQUARE, MARKER = 6, 5, 0.1, 0.075
PIXELS, MARGIN = 800, 0.05
APART = 0.6  # m, between the cameras
HELD, PAUSE = 40, 5.0  # images, s
DAMAGED = 16  # images, the first


def turn(axis, angle):
    return cv2.Rodrigues(angle * numpy.array(axis, float))[0]


def cameras():
    """Rotation (camera to world) and place; z is forward."""
    return {'left': (numpy.eye(3), numpy.zeros(3)),
            'right': (turn((0, 1, 0), -0.25), numpy.array([APART, 0, 0]))}


def board_at(k):
    """Rotation and place of the board's origin while it is waved."""
    R = (turn((1, 0, 0), numpy.pi) @ turn((1, 0, 0), 0.6 * numpy.sin(2.1 * k))
         @ turn((0, 1, 0), 0.6 * numpy.cos(1.1 * k)))
    place = numpy.array([0.25 + 0.45 * numpy.sin(1.3 * k), 0.3 * numpy.cos(1.7 * k),
                         1.5 + 0.4 * numpy.sin(0.9 * k)])
    return R, place - R @ numpy.array([COLUMNS * SQUARE / 2, ROWS * SQUARE / 2, 0])


def on_floor():
    """Below the cameras, which look along the floor and down at it a little."""
    R = turn((1, 0, 0), 2.2)
    return R, numpy.array([0.25, 0.3, 1.6]) - R @ numpy.array([0.3, 0.25, 0])


def flat_board():
    dictionary = cv2.aruco.Dictionary_get(cv2.aruco.DICT_4X4_50)
    board = cv2.aruco.CharucoBoard_create(COLUMNS, ROWS, SQUARE, MARKER, dictionary)
    size = (int((COLUMNS * SQUARE + 2 * MARGIN) * PIXELS), int((ROWS * SQUARE + 2 * MARGIN) * PIXELS))
    return board.draw(size, marginSize=int(MARGIN * PIXELS), borderBits=1)


def picture(flat, camera, board):
    """The board as the camera sees it: drawn three times as large, and made small."""
    (R, place), (turned, origin) = camera, board
    width, height = COLUMNS * SQUARE, ROWS * SQUARE
    corners = numpy.array([[-MARGIN, -MARGIN], [width + MARGIN, -MARGIN],
                           [width + MARGIN, height + MARGIN], [-MARGIN, height + MARGIN]])
    seen = (origin + corners @ turned[:, :2].T - place) @ R
    pixels = FOCAL * seen[:, :2] / seen[:, 2:] + [SIZE[0] / 2, SIZE[1] / 2]
    rows, columns = flat.shape
    source = numpy.array([[0, rows], [columns, rows], [columns, 0], [0, 0]], numpy.float32) - 0.5
    H = cv2.getPerspectiveTransform(source, (3 * pixels + 1).astype(numpy.float32))
    fine = cv2.warpPerspective(flat, H, (3 * SIZE[0], 3 * SIZE[1]), borderValue=150)
    return cv2.resize(fine, SIZE, interpolation=cv2.INTER_AREA)


class CalibrateLive(unittest.TestCase):
    def setUp(self):
        rospy.init_node('calibrate_live_test')
        self.folder = tempfile.mkdtemp()
        self.publishers = {name: rospy.Publisher(name + '/image_raw', Image, queue_size=2)
                           for name in cameras()}
        self.pictures = []
        rospy.Subscriber('calibrate_rig/coverage', Image, self.pictures.append, queue_size=1)
        self.said = ''
        self.enough = threading.Event()

    def tearDown(self):
        shutil.rmtree(self.folder)

    def read(self, tool):
        for line in tool.stdout:
            self.said += line
            if line.startswith('Enough.'):
                self.enough.set()

    def publish(self, flat, board, damaged):
        stamp = rospy.Time.now()
        for name, camera in cameras().items():
            image = Image(height=SIZE[1], width=SIZE[0], encoding='mono8', step=SIZE[0])
            image.header.stamp = stamp
            image.data = picture(flat, camera, board).tobytes()
            if name == damaged:
                image.data = image.data[1:]
            self.publishers[name].publish(image)

    def test_the_board_is_waved_until_it_suffices(self):
        tool = subprocess.Popen(
            ['rosrun', 'markerless_mocap', 'calibrate_rig', os.path.join(self.folder, 'rig'), '--live',
             'left', 'right', '--columns', str(COLUMNS), '--rows', str(ROWS), '--square', str(SQUARE),
             '--marker', str(MARKER), '--floor', 'left'],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, universal_newlines=True)
        reader = threading.Thread(target=self.read, args=(tool,))
        reader.start()
        flat, k = flat_board(), 0
        try:
            end = rospy.get_time() + 200
            while tool.poll() is None and rospy.get_time() < end:
                # At first it is held still, and then the cameras pause.
                self.publish(flat, on_floor() if self.enough.is_set() else board_at(max(0, k - HELD)),
                             damaged='right' if k < DAMAGED or k % 7 == 0 else None)
                k += 1
                rospy.sleep(PAUSE if k == HELD else 0.25)
            reader.join(10)
        finally:
            if tool.poll() is None:
                tool.kill()
        self.assertEqual(tool.returncode, 0, self.said)
        self.assertIn('left needs ', self.said)
        self.assertRegex(self.said, r'waiting for images of right \(.*bytes')
        self.assertEqual(self.said.count('right: images are left out: '), 1, self.said)
        tables = re.findall(r'^left .*\nright .*', self.said, re.MULTILINE)
        self.assertEqual(len(tables), len(set(tables)), self.said)
        self.assertEqual(self.said.count('no images come any more'), 1, self.said)
        self.assertIn('more places of the board', self.said)
        self.assertIn('to one of left and at the same time to one of right', self.said)
        self.assertTrue(self.pictures)
        self.assertEqual((self.pictures[-1].width, self.pictures[-1].height), (960, 360))
        self.check_rig()

    def check_rig(self):
        with open(os.path.join(self.folder, 'rig', 'rig.yaml')) as text:
            rig = {camera['name']: camera for camera in yaml.safe_load(text)['cameras']}
        left, right = (numpy.array(rig[name]['position']) for name in ('left', 'right'))
        self.assertAlmostEqual(numpy.linalg.norm(right - left), APART, delta=0.01)
        self.assertAlmostEqual(rig['left']['fx'], FOCAL, delta=8)
        R, origin = on_floor()
        for found, (_, place) in zip((left, right), cameras().values()):
            self.assertLess(numpy.linalg.norm(found - R.T @ (place - origin)), 0.03)


if __name__ == '__main__':
    rostest.rosrun('markerless_mocap', 'calibrate_live', CalibrateLive)

#!/usr/bin/python3
"""The camera node plays two films: every image once, with the films' own times, the same for both,
and with camera_info and tf of the rig file."""
import os
import shutil
import subprocess
import tempfile
import unittest

import cv2
import numpy
import rospy
import rostest
from sensor_msgs.msg import CameraInfo, Image
from tf2_msgs.msg import TFMessage

FRAMES, RATE = 20, 10.0
CAMERA = '''- name: %s
  size: [64, 48]
  fx: 70
  fy: 70
  cx: 31.5
  cy: 23.5
  distortion: []
  position: [0, 1, 2]
  orientation: [0, 0, 0, 1]
'''


class UsbCameras(unittest.TestCase):
    def setUp(self):
        rospy.init_node('usb_cameras_test')
        self.folder = tempfile.mkdtemp()
        self.images, self.infos, self.frames = {'a': [], 'b': []}, [], []
        for name, images in self.images.items():
            rospy.Subscriber(name + '/image_raw', Image, images.append, queue_size=100)
        rospy.Subscriber('b/camera_info', CameraInfo, self.infos.append, queue_size=100)
        rospy.Subscriber('/tf_static', TFMessage, self.frames.append, queue_size=10)

    def tearDown(self):
        shutil.rmtree(self.folder)

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self):
        for name in self.images:
            film = cv2.VideoWriter(self.path(name + '.avi'), cv2.VideoWriter_fourcc(*'MJPG'), RATE,
                                   (64, 48))
            for k in range(FRAMES):
                film.write(numpy.full((48, 64, 3), 10 + 10 * k, numpy.uint8))
            film.release()
        with open(self.path('rig.yaml'), 'w') as rig:
            rig.write('cameras:\n' + CAMERA % 'a' + CAMERA % 'b')

    def start(self, sources):
        rospy.set_param('/usb_cameras', {'cameras': ['a', 'b'], 'sources': sources,
                                         'rig_file': self.path('rig.yaml')})
        return subprocess.Popen(['rosrun', 'markerless_mocap', 'usb_cameras'],
                                stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                universal_newlines=True)

    def test_films_are_played_by_their_own_times(self):
        self.write()
        node = self.start([self.path('a.avi'), self.path('b.avi')])
        try:
            end = rospy.get_time() + 30
            while rospy.get_time() < end and min(map(len, self.images.values())) < FRAMES:
                rospy.sleep(0.1)
        finally:
            node.terminate()
            node.communicate()
        stamps = {n: [m.header.stamp for m in images] for n, images in self.images.items()}
        self.assertEqual(stamps['a'], stamps['b'])
        self.assertEqual(len(stamps['a']), FRAMES)
        for k in range(1, FRAMES):
            self.assertAlmostEqual((stamps['a'][k] - stamps['a'][0]).to_sec(), k / RATE, 3)
        for k, image in enumerate(self.images['b']):
            self.assertEqual((image.width, image.height, image.encoding), (64, 48, 'bgr8'))
            self.assertAlmostEqual(image.data[1000], 10 + 10 * k, delta=3)
            self.assertEqual(image.header.frame_id, 'b_optical')
        self.assertEqual([m.header.stamp for m in self.infos], stamps['b'])
        self.assertEqual(self.infos[0].K[0], 70.0)
        names = {t.child_frame_id for m in self.frames for t in m.transforms}
        self.assertEqual(names, {'a_optical', 'b_optical'})

    def test_what_cannot_be_opened_is_told(self):
        self.write()
        node = self.start([self.path('a.avi'), self.path('none.avi')])
        said = node.communicate(timeout=60)[0]
        self.assertNotEqual(node.returncode, 0)
        self.assertIn('usb_cameras: ' + self.path('none.avi') + ' of camera b cannot be opened', said)


if __name__ == '__main__':
    rostest.rosrun('markerless_mocap', 'usb_cameras_films', UsbCameras)

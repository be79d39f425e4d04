#!/usr/bin/python3
"""check_recording --live --repeat says on /diagnostics that all cameras lose images."""
import subprocess
import unittest

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray, DiagnosticStatus

CAMERAS = {'cam0', 'cam1', 'cam2', 'cam3'}


class CheckLive(unittest.TestCase):
    def setUp(self):
        rospy.init_node('check_live_test')
        self.status = {}
        rospy.Subscriber('/diagnostics', DiagnosticArray, self.keep, queue_size=50)
        for camera in CAMERAS:
            rospy.wait_for_message(f'{camera}/image_raw', rospy.AnyMsg, 60)
        self.checker = subprocess.Popen(
            ['rosrun', 'markerless_mocap', 'check_recording', '--live', '8', '--repeat'])

    def tearDown(self):
        self.checker.terminate()
        self.checker.wait(20)

    def keep(self, message):
        for status in message.status:
            name = status.name.split('check_recording: ')
            if len(name) == 2:
                self.status[name[1]] = status

    def losing(self):
        return {camera for camera, status in self.status.items()
                if 'images_dropped' in status.message and status.level >= DiagnosticStatus.WARN}

    def test_lost_images_are_said(self):
        end = rospy.get_time() + 60
        while rospy.get_time() < end and not CAMERAS <= self.losing():
            rospy.sleep(0.2)
        self.assertLessEqual(CAMERAS, self.losing(), self.status)
        values = {value.key: value.value for value in self.status['cam0'].values}
        self.assertIn('% of the images are missing', values['images_dropped'])


if __name__ == '__main__':
    rostest.rosrun('markerless_mocap', 'check_live', CheckLive)

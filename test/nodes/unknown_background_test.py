#!/usr/bin/python3
"""Four of eight silhouettes say nothing near the person: there, the person is followed by colours.
Images are subscribed where they are needed, and no longer once the background is known."""
import math
import statistics
import unittest

import numpy
import rosgraph
import rospy
import rostest
import tf2_ros
from diagnostic_msgs.msg import DiagnosticArray
from markerless_mocap.msg import BodyPose
from sensor_msgs.msg import Image

CAMERAS = ['cam%d' % i for i in range(8)]
POORLY_KNOWN = CAMERAS[:4]
UNKNOWN, PERSON = 128, 255
MARGIN = 20  # pixels around the person that are unknown, too
POSES_WANTED = 12
# Metres, 1.3 times the largest that several runs measured: the median, and what nine tenths stay
# below.
JOINTS = ('body', 'head', 'l_elbow', 'r_wrist', 'l_knee', 'r_ankle')
JOINT_BOUNDS = (0.015, 0.08)


class UnknownBackground(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('unknown_background_test')
        cls.master = rosgraph.Master('unknown_background_test')
        cls.tf = tf2_ros.Buffer(cache_time=rospy.Duration(600))
        cls.listener = tf2_ros.TransformListener(cls.tf)
        cls.poses, cls.counts, cls.unknown = [], {}, True
        rospy.Subscriber('pose', BodyPose, cls.poses.append, queue_size=200)
        rospy.Subscriber('/diagnostics', DiagnosticArray, cls.keep_counts, queue_size=200)
        for camera in CAMERAS:
            cls.relay(camera)

    @classmethod
    def relay(cls, camera):
        """Publishes the true silhouettes of a camera, with or without what is near the person."""
        out = rospy.Publisher(camera + '/silhouette', Image, queue_size=20)

        def publish(truth):
            mask = numpy.frombuffer(truth.data, numpy.uint8).reshape(truth.height, truth.width).copy()
            rows, columns = numpy.nonzero(mask)
            if cls.unknown and camera in POORLY_KNOWN and len(rows):
                mask[max(0, rows.min() - MARGIN):rows.max() + MARGIN,
                     max(0, columns.min() - MARGIN):columns.max() + MARGIN] = UNKNOWN
            truth.data = mask.tobytes()
            if not rospy.is_shutdown():
                out.publish(truth)
        rospy.Subscriber('ground_truth/' + camera + '/silhouette', Image, publish, queue_size=20)

    @classmethod
    def keep_counts(cls, message):
        for status in message.status:
            if status.name.endswith('pose fitting'):
                cls.counts = {v.key: int(v.value) for v in status.values if v.value.isdigit()}

    def tracked(self, since=rospy.Time(0)):
        """Poses of the measured body."""
        return [p for p in self.poses if p.status != BodyPose.LOST and p.header.stamp > since
                and 'the body is being measured' not in p.reason]

    def whole(self, since):
        return [p for p in self.tracked(since) if not p.parts_not_seen]

    def subscribed(self):
        """The cameras whose images pose_fitting has subscribed."""
        subscriptions = dict(self.master.getSystemState()[1])
        return [camera for camera in CAMERAS
                if '/pose_fitting' in subscriptions.get('/' + camera + '/image_raw', [])]

    def wait_for(self, condition, seconds):
        end = rospy.get_time() + seconds
        while rospy.get_time() < end and not condition():
            rospy.sleep(0.1)
        self.assertTrue(condition(), {p.reason for p in self.poses[-20:]})

    def distances(self, poses):
        found = []
        for joint in JOINTS:
            for pose in poses:
                a, b = (self.tf.lookup_transform('world', joint + '_' + body, pose.header.stamp)
                        .transform.translation for body in ('person1', 'truth'))
                found.append(math.dist((a.x, a.y, a.z), (b.x, b.y, b.z)))
        return sorted(found)

    def test_images_are_used_while_the_background_is_unknown(self):
        self.wait_for(lambda: self.subscribed() == POORLY_KNOWN, 60)
        self.wait_for(lambda: len(self.tracked()) >= POSES_WANTED, 90)
        self.assertEqual(POORLY_KNOWN, self.subscribed())
        before = self.counts
        start = rospy.Time.now()
        self.wait_for(lambda: len(self.whole(start)) >= POSES_WANTED, 60)
        poses = self.whole(start)
        rospy.sleep(1.5)  # diagnostics come once a second, and frames after their pose
        for camera in POORLY_KNOWN:
            lack = 'frame sets without the colours of ' + camera
            self.assertEqual(before.get(lack, 0), self.counts.get(lack, 0))
        distances = self.distances(poses)
        shown = ' '.join('%.0f' % (1e3 * d) for d in distances) + ' mm'
        self.assertLess(statistics.median(distances), JOINT_BOUNDS[0], shown)
        self.assertLess(distances[int(0.9 * len(distances))], JOINT_BOUNDS[1], shown)

        UnknownBackground.unknown = False
        self.wait_for(lambda: not self.subscribed(), 20)
        known = rospy.Time.now()
        self.wait_for(lambda: len(self.tracked(known)) >= POSES_WANTED, 30)
        self.assertEqual([], self.subscribed())


if __name__ == '__main__':
    rostest.rosrun('markerless_mocap', 'unknown_background', UnknownBackground)

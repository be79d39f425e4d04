#!/usr/bin/python3
"""A camera stops in the middle: the person is followed with the other seven, and it is said. When the
others have stopped, too, nobody is announced any more."""
import unittest

import rosnode
import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from hri_listener import HriListener
from markerless_mocap.msg import BodyPose

LACK = 'frame sets without the silhouette of cam7'
LATENCY = ('camera to message, median ms', 'camera to message, 99 % within ms')


class StoppedCamera(unittest.TestCase):
    def setUp(self):
        rospy.init_node('stopped_camera_test')
        self.poses, self.counts, self.hri = [], {}, HriListener()
        rospy.Subscriber('pose', BodyPose, self.poses.append, queue_size=200)
        rospy.Subscriber('/diagnostics', DiagnosticArray, self.keep, queue_size=200)

    def keep(self, message):
        for status in message.status:
            if status.name.endswith('pose fitting'):
                self.counts = {v.key: int(v.value) for v in status.values if v.value.isdigit()}

    def tracked(self, since=rospy.Time(0)):
        """Poses of the measured body."""
        return [p for p in self.poses if p.status != BodyPose.LOST and p.header.stamp > since
                and 'the body is being measured' not in p.reason]

    def lacking(self):
        return self.counts.get(LACK, 0)

    def wait_for(self, condition, seconds):
        end = rospy.get_time() + seconds
        while rospy.get_time() < end and not condition():
            rospy.sleep(0.1)

    def test_the_person_is_followed_without_it(self):
        self.wait_for(lambda: len(self.tracked()) >= 5, 120)
        self.assertGreaterEqual(len(self.tracked()), 5, {p.reason for p in self.poses})
        self.wait_for(lambda: LATENCY[0] in self.counts, 20)
        self.assertGreater(self.counts[LATENCY[0]], 0)
        self.assertGreaterEqual(self.counts[LATENCY[1]], self.counts[LATENCY[0]])
        before = self.lacking()
        rosnode.kill_nodes(['/silhouette_of_cam7'])
        stopped = rospy.Time.now()
        self.wait_for(lambda: len(self.tracked(stopped)) >= 10 and self.lacking() > before + 5, 40)
        after = [p for p in self.poses if p.header.stamp > stopped]
        self.assertGreaterEqual(len(self.tracked(stopped)), 10, {p.reason for p in after})
        self.assertLessEqual(len(after) - len(self.tracked(stopped)), 1, {p.reason for p in after})
        self.assertGreater(self.lacking(), before + 5)
        self.wait_for(self.hri.bodies, 20)
        self.assertEqual(['person1'], self.hri.bodies())
        rosnode.kill_nodes(['/silhouette'])
        described = lambda: rospy.has_param('/human_description_person1')
        self.wait_for(lambda: not self.hri.bodies() and not described(), 60)
        self.assertEqual([], self.hri.bodies())
        self.assertFalse(described())
        self.wait_for(lambda: LATENCY[0] not in self.counts, 30)
        self.assertNotIn(LATENCY[0], self.counts, 'nothing has come for more than ten seconds')


if __name__ == '__main__':
    rostest.rosrun('markerless_mocap', 'stopped_camera', StoppedCamera)

#!/usr/bin/python3
"""With privacy, poses come from masks alone: images reach the silhouettes and nobody else, though the
hull and overlays are asked for. Told by the master, and by the bytes that each connection carried."""
import subprocess
import unittest
import xmlrpc.client

import rosgraph
import rospy
import rostest
from markerless_mocap.msg import BodyPose
from sensor_msgs.msg import CompressedImage, Image, PointCloud2

CAMERAS = ['cam%d' % i for i in range(8)]
POSES_WANTED = 8


class Privacy(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('privacy_test')
        cls.master = rosgraph.Master(rospy.get_name())
        cls.poses, cls.hulls, cls.masks, cls.overlays = [], [], [], []
        rospy.Subscriber('pose', BodyPose, cls.poses.append, queue_size=200)
        rospy.Subscriber('hull/points', PointCloud2, cls.hulls.append, queue_size=200)
        rospy.Subscriber('cam3/silhouette/compressed', CompressedImage, cls.masks.append, queue_size=200)
        rospy.Subscriber('cam3/overlay', Image, cls.overlays.append, queue_size=200)
        end = rospy.get_time() + 120
        while rospy.get_time() < end and len(cls.tracked()) < POSES_WANTED:
            rospy.sleep(0.2)

    @classmethod
    def tracked(cls):
        return [p for p in cls.poses if p.status != BodyPose.LOST]

    def subscribers(self, ending):
        return {node for topic, nodes in self.master.getSystemState()[1] for node in nodes
                if topic.endswith(ending)}

    def sent(self, node):
        """Bytes that a node has sent, by topic: one number for each connection."""
        uri = self.master.lookupNode(node)
        publications, _ = xmlrpc.client.ServerProxy(uri).getBusStats(rospy.get_name())
        return {topic: [connection[1] for connection in connections] for topic, connections in publications}

    def test_poses_come(self):
        self.assertGreaterEqual(len(self.tracked()), POSES_WANTED, {p.reason for p in self.poses})

    def test_only_silhouettes_subscribe_to_images(self):
        for ending in ('/image_raw', '/image_raw/compressed'):
            self.assertLessEqual(self.subscribers(ending), {'/silhouette'})

    def test_only_one_connection_carries_images(self):
        sent = self.sent('/virtual_studio')
        for camera in CAMERAS:
            connections = sent['/' + camera + '/image_raw']
            self.assertEqual(1, len(connections), camera)
            self.assertGreater(connections[0], 200 * 150, camera)

    def test_more_bytes_go_out_where_somebody_else_reads_an_image(self):
        subscriber = rospy.Subscriber('cam5/image_raw', Image)
        end = rospy.get_time() + 20
        while rospy.get_time() < end and len(self.sent('/virtual_studio')['/cam5/image_raw']) < 2:
            rospy.sleep(0.2)
        self.assertEqual(2, len(self.sent('/virtual_studio')['/cam5/image_raw']))
        self.assertIn(rospy.get_name(), self.subscribers('/image_raw'))
        subscriber.unregister()
        end = rospy.get_time() + 20
        while rospy.get_time() < end and rospy.get_name() in self.subscribers('/image_raw'):
            rospy.sleep(0.2)

    def test_masks_travel_compressed_only(self):
        sent = self.sent('/silhouette')
        for camera in CAMERAS:
            self.assertEqual(0, sum(sent.get('/' + camera + '/silhouette', [])), camera)
            self.assertEqual(3 if camera == 'cam3' else 2, len(sent['/' + camera + '/silhouette/compressed']))
        self.assertTrue(self.masks)
        self.assertLess(max(len(m.data) for m in self.masks), 2000)
        self.assertEqual({'mono8; png compressed '}, {m.format for m in self.masks})

    def test_the_hull_has_no_colours_and_there_are_no_overlays(self):
        self.assertTrue([h for h in self.hulls if h.width])
        for hull in self.hulls:
            rgb = [f.offset for f in hull.fields if f.name == 'rgb']
            for offset in rgb:
                shades = {bytes(hull.data[at + offset:at + offset + 3])
                          for at in range(0, len(hull.data), hull.point_step)}
                self.assertLessEqual(len(shades), 1)
        self.assertFalse(self.overlays)
        published = dict(self.master.getSystemState()[0])
        self.assertNotIn('/cam3/overlay', published)

    def test_a_method_that_needs_images_is_refused(self):
        rospy.set_param('/other_fitting', {'cameras': ['a', 'b'], 'privacy': True, 'method': 'fleischmann'})
        refused = subprocess.run(['rosrun', 'markerless_mocap', 'pose_fitting', '__name:=other_fitting'],
                                 capture_output=True, text=True, timeout=30, check=False)
        self.assertEqual(1, refused.returncode)
        self.assertIn('pose_fitting/method is "fleischmann", which reads images, but privacy is true',
                      refused.stdout + refused.stderr)


if __name__ == '__main__':
    rostest.rosrun('markerless_mocap', 'privacy', Privacy)

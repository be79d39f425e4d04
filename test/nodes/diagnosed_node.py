"""What the tests of bad messages share: a node that runs, its diagnostics, and messages made by hand."""
import subprocess
import unittest

import rospy
from diagnostic_msgs.msg import DiagnosticArray
from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import CameraInfo, Image, PointCloud2, PointField

SIZE = (64, 48)


def start(node, *arguments):
    return subprocess.Popen(['rosrun', 'markerless_mocap', node, '__name:=' + node, *arguments],
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


class Diagnosed(unittest.TestCase):
    """A node that runs while it is given bad messages."""

    def run_node(self, node, *arguments):
        self.sentences = []
        rospy.Subscriber('/diagnostics', DiagnosticArray, self.keep, queue_size=100)
        self.process = start(node, *arguments)
        self.addCleanup(self.stop)

    def keep(self, message):
        self.sentences += [s.message for s in message.status]

    def stop(self):
        self.process.terminate()
        self.process.communicate(timeout=30)
        for name in ('/human_description_person1', '/visual_hull', '/silhouette', '/body_segmentation',
                     '/pose_tree', '/pose_fitting'):
            if rospy.has_param(name):
                rospy.delete_param(name)

    def send_until(self, sentence, send):
        end = rospy.get_time() + 20
        while rospy.get_time() < end:
            send(rospy.Time.now())
            rospy.sleep(0.05)
            self.assertIsNone(self.process.poll(), 'the node has ended')
            if any(sentence in s for s in self.sentences):
                return
        self.fail('never said: %s; but: %s' % (sentence, set(self.sentences)))


def info(frame, size=SIZE, focal=50.0):
    message = CameraInfo(width=size[0], height=size[1], distortion_model='plumb_bob')
    message.header.frame_id = frame
    message.D = [0.0] * 5
    message.K = [focal, 0, size[0] / 2, 0, focal, size[1] / 2, 0, 0, 1 if focal else 0]
    if not focal:
        message.K = [0.0] * 9
    return message


def mask(stamp, value, size=SIZE, encoding='mono8'):
    message = Image(width=size[0], height=size[1], step=size[0], encoding=encoding)
    message.header.stamp = stamp
    message.data = bytes([value]) * (size[0] * size[1])
    return message


def empty_cloud(words, single_bytes):
    """No points of float fields, then byte fields."""
    fields = [PointField(name, 4 * i, PointField.FLOAT32, 1) for i, name in enumerate(words)]
    fields += [PointField(name, 4 * len(words) + i, PointField.UINT8, 1)
               for i, name in enumerate(single_bytes)]
    return PointCloud2(fields=fields, height=1, point_step=4 * len(words) + len(single_bytes))


def place_cameras(broadcaster):
    transforms = []
    for i, camera in enumerate('ab'):
        t = TransformStamped()
        t.header.frame_id, t.child_frame_id = 'world', camera + '_optical'
        t.transform.translation.y, t.transform.translation.z = -3.0, 1.0
        t.transform.translation.x = 0.5 * i
        t.transform.rotation.x, t.transform.rotation.w = -0.5 ** 0.5, 0.5 ** 0.5
        transforms.append(t)
    broadcaster.sendTransform(transforms)

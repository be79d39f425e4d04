#!/usr/bin/python3
"""Each bad input gets its sentence; no node crashes or hangs."""
import tempfile

import rospy
import rostest
import tf2_ros
from bad_parameters_test import rig_text
from diagnosed_node import SIZE, Diagnosed, info, mask, place_cameras, start
from markerless_mocap.msg import BodyParts, HullCameras, PoseTree
from sensor_msgs.msg import CameraInfo, CompressedImage, Image, PointCloud2
from std_msgs.msg import String


class HullNode(Diagnosed):
    volume = [-1.5, -1.5, 0.0], [1.5, 1.5, 2.2]

    def setUp(self):
        rospy.set_param('/visual_hull/cameras', ['a', 'b'])
        rospy.set_param('/visual_hull/volume_min', self.volume[0])
        rospy.set_param('/visual_hull/volume_max', self.volume[1])
        self.infos = [rospy.Publisher(c + '/camera_info', CameraInfo, queue_size=5) for c in 'ab']
        self.masks = [rospy.Publisher(c + '/silhouette', Image, queue_size=5) for c in 'ab']
        self.clouds = []
        self.clouds_in = rospy.Subscriber('hull/points', PointCloud2, self.clouds.append)
        self.run_node('visual_hull')

    def sender(self, messages, value=0, size=SIZE, encoding='mono8'):
        def send(stamp):
            for publisher, message in zip(self.infos, messages):
                publisher.publish(message)
            for publisher in self.masks:
                publisher.publish(mask(stamp, value, size, encoding))
        return send

    def expect(self, sentence, *arguments, **named):
        self.send_until(sentence, self.sender(*arguments, **named))
        rospy.sleep(0.3)
        self.assertTrue(self.clouds, 'an instant that cannot be used has its empty cloud')
        self.assertEqual({0}, {c.width for c in self.clouds})


class CompressedMasks(Diagnosed):
    def setUp(self):
        rospy.set_param('/visual_hull/cameras', ['a', 'b'])
        rospy.set_param('/visual_hull/mask_transport', 'compressed')
        self.masks = [rospy.Publisher(c + '/silhouette/compressed', CompressedImage, queue_size=5)
                      for c in 'ab']
        self.run_node('visual_hull')

    def expect(self, sentence, data):
        def send(stamp):
            message = CompressedImage(format='png', data=data)
            message.header.stamp, message.header.frame_id = stamp, 'a_optical'
            for publisher in self.masks:
                publisher.publish(message)
        self.send_until('a has sent masks that cannot be used: compressed mask of frame "a_optical" '
                        'cannot be read: ' + sentence, send)

    def test_no_png(self):
        self.expect('it is not a PNG', b'\xff\xd8\xff\xe0 a JPEG')

    def test_a_head_that_promises_too_much(self):
        self.expect('its head says 65535 x 65535 pixels',
                    b'\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\xff\xff\0\0\xff\xff\x08\0\0\0\0' + bytes(200))


class HullElsewhere(HullNode):
    volume = [20.0, 20.0, 0.0], [23.0, 23.0, 2.2]

    def test_volume_that_no_camera_sees(self):
        self.expect('no voxel of the volume is seen by 2 cameras',
                    [info('a_optical'), info('b_optical')])


class Hull(HullNode):
    def test_no_camera_info(self):
        self.expect('no camera_info has been received from a, b', [])

    def test_no_tf(self):
        self.expect('tf does not connect nowhere of a to world', [info('nowhere'), info('b_optical')])

    def test_zero_k(self):
        self.expect("camera 'a': K is all zero", [info('a_optical', focal=0.0), info('b_optical')])

    def test_nan_k(self):
        self.expect("camera 'a': K holds a value that is not finite",
                    [info('a_optical', focal=float('nan')), info('b_optical')])

    def test_mask_of_another_size(self):
        self.expect('32 x 24 pixels', [info('a_optical'), info('b_optical')], size=(32, 24))

    def test_mask_of_another_encoding(self):
        self.expect('has the encoding "8SC1", allowed is mono8',
                    [info('a_optical'), info('b_optical')], encoding='8SC1')

    def test_words_of_others_are_told_in_one_short_line(self):
        self.expect('has the encoding "mo no8?[31mqqq',
                    [info('a_optical'), info('b_optical')], encoding='mo\nno8\x1b[31m' + 5000 * 'q')
        told = [text for text in self.sentences if 'no8' in text]
        self.assertFalse([text for text in told if '\n' in text or len(text) > 1000])

    def test_too_few_cameras(self):
        send_infos = self.sender([info('a_optical'), info('b_optical')])
        self.masks[1].unregister()
        self.masks.pop()
        self.send_until('the masks of 1 of 2 cameras, at least 2 are needed', send_infos)

    def test_empty_masks(self):
        self.expect('the masks of all 2 cameras are empty', [info('a_optical'), info('b_optical')])

    def test_full_masks(self):
        self.expect('is full', [info('a_optical'), info('b_optical')], value=255)


class TopicOfAnotherType(Diagnosed):
    def test_what_is_sent_is_named(self):
        rospy.set_param('/visual_hull/cameras', ['p', 'q'])
        strings = [rospy.Publisher(c + t, String, queue_size=5) for c in 'pq'
                   for t in ('/camera_info', '/silhouette')]
        self.run_node('visual_hull')
        self.send_until('what is sent on /p/silhouette is std_msgs/String; no messages on '
                        '/p/silhouette (sensor_msgs/Image)',
                        lambda stamp: [publisher.publish('text') for publisher in strings])


class HullOfTwoGoodCameras(Diagnosed):
    def test_one_malformed_mask_costs_its_camera(self):
        rospy.set_param('/visual_hull/cameras', ['a', 'b', 'c'])
        rospy.set_param('/visual_hull/min_cameras', 2)
        rospy.set_param('/pose_fitting/min_cameras', 2)
        rospy.set_param('/visual_hull/min_views', 2)
        infos = [rospy.Publisher(c + '/camera_info', CameraInfo, queue_size=5) for c in 'abc']
        masks = [rospy.Publisher(c + '/silhouette', Image, queue_size=5) for c in 'abc']
        used = []
        subscriber = rospy.Subscriber('hull/cameras_used', HullCameras, used.append)
        self.addCleanup(subscriber.unregister)
        self.run_node('visual_hull')

        def send(stamp):
            for name, publisher in zip('aba', infos):
                publisher.publish(info(name + '_optical'))
            for publisher, size in zip(masks, (SIZE, SIZE, (32, 24))):
                publisher.publish(mask(stamp, 0, size))
        self.send_until('the masks of all 2 cameras are empty', send)
        end = rospy.get_time() + 20  # the third camera may be connected last
        while not used or 'is 32 x 24 pixels' not in used[-1].reasons[2]:
            self.assertLess(rospy.get_time(), end, used and used[-1].reasons)
            send(rospy.Time.now())
            rospy.sleep(0.05)
        self.assertEqual([True, True, False], list(used[-1].usable))


class HullWithRigFile(HullNode):
    def setUp(self):
        file = tempfile.NamedTemporaryFile('w')
        self.addCleanup(file.close)
        file.write(rig_text('bca'))
        file.flush()
        rospy.set_param('/visual_hull/rig_file', file.name)
        super().setUp()

    def test_neither_camera_info_nor_tf_is_asked_for(self):
        self.expect('is full', [], value=255)

    def test_camera_info_that_says_otherwise_changes_nothing(self):
        self.expect('is full', [info('nowhere', focal=0.0), info('', size=(32, 24))], value=255)


class TreeOfEmptyMasks(HullNode):
    def test_status_and_reason_of_every_instant(self):
        trees = []
        rospy.Subscriber('pose_tree', PoseTree, trees.append)
        node = start('pose_tree')
        self.addCleanup(node.communicate, timeout=30)
        self.addCleanup(node.terminate)

        def send(stamp):
            self.sender([info('a_optical'), info('b_optical')])(stamp)
            self.assertIsNone(node.poll(), 'the node has ended')
        self.send_until('the masks of all 2 cameras are empty', send)
        end = rospy.get_time() + 20
        while rospy.get_time() < end and not any('no hull/grid' not in t.reason for t in trees):
            send(rospy.Time.now())
            rospy.sleep(0.1)
        rospy.sleep(0.5)
        self.assertTrue(trees)
        self.assertEqual({PoseTree.NO_SKELETON}, {t.status for t in trees})
        self.assertTrue(all(t.reason and not t.nodes and not t.tip_names for t in trees))
        self.assertLessEqual({t.header.stamp for t in trees}, {c.header.stamp for c in self.clouds})
        self.assertTrue(any('no hull/grid' not in t.reason for t in trees))


class OtherStages(Diagnosed):
    def test_unreadable_image(self):
        rospy.set_param('/silhouette/cameras', ['a'])
        rospy.set_param('/silhouette/image_transport', 'compressed')
        images = rospy.Publisher('a/image_raw/compressed', CompressedImage, queue_size=5)
        self.run_node('silhouette')

        def send(stamp):
            message = CompressedImage(format='jpeg', data=b'no jpeg')
            message.header.stamp = stamp
            images.publish(message)
        self.send_until('cannot be decoded', send)

    def answers_without_grid(self, node, topic, answer_type):
        points = rospy.Publisher('hull/points', PointCloud2, queue_size=5)
        answers = []
        rospy.Subscriber(topic, answer_type, answers.append)
        self.run_node(node)

        def send(stamp):
            message = PointCloud2()
            message.header.stamp = stamp
            points.publish(message)
        self.send_until('no hull/grid has been received yet', send)
        return {a.status for a in answers}

    def test_hull_without_grid(self):
        found = self.answers_without_grid('body_segmentation', 'segmentation/parts', BodyParts)
        self.assertEqual({BodyParts.INVALID}, found)

    def test_tree_without_grid(self):
        found = self.answers_without_grid('pose_tree', 'pose_tree', PoseTree)
        self.assertEqual({PoseTree.NO_SKELETON}, found)


def setUpModule():
    rospy.init_node('bad_input_test')
    place_cameras(tf2_ros.StaticTransformBroadcaster())


if __name__ == '__main__':
    rostest.rosrun('markerless_mocap', 'bad_input', 'bad_input_test')

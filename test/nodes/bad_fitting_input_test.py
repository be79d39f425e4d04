#!/usr/bin/python3
"""As bad_input_test, for pose_fitting: it publishes no pose that it does not have."""
import subprocess

import rospy
import rostest
import tf2_ros
from diagnosed_node import SIZE, Diagnosed, empty_cloud, info, mask, place_cameras
from markerless_mocap.msg import BodyParts, BodyPose, PoseTree, VoxelGrid
from sensor_msgs.msg import CameraInfo, Image


class FittingNode(Diagnosed):
    """pose_fitting is given the other stages' messages by hand: none of them holds a person."""
    method = 'contour'
    grid = VoxelGrid(pitch=0.02, size=[10, 10, 10])
    grid.header.frame_id = 'world'
    stages = {
        'hull/points': empty_cloud(['x', 'y', 'z', 'rgb'],
                                   ['views', 'votes_x', 'votes_y', 'votes_z', 'possible_x',
                                    'possible_y', 'possible_z']),
        'segmentation/points': empty_cloud(['x', 'y', 'z', 'rgb'], ['label']),
        'segmentation/parts': BodyParts(reason='the hull has no voxels'),
        'pose_tree': PoseTree(status=PoseTree.NO_SKELETON, origin=-1, reason='the hull has no voxels')}

    def setUp(self):
        rospy.set_param('/pose_fitting/method', self.method)
        rospy.set_param('/pose_fitting/measure', False)
        rospy.set_param('/pose_fitting/cameras', ['a', 'b'] if self.method == 'contour' else [])
        self.publishers = {t: rospy.Publisher(t, type(message), queue_size=5)
                           for t, message in self.stages.items()}
        self.infos = [rospy.Publisher(c + '/camera_info', CameraInfo, queue_size=5) for c in 'ab']
        self.masks = [rospy.Publisher(c + '/silhouette', Image, queue_size=5) for c in 'ab']
        self.latched = rospy.Publisher('hull/grid', VoxelGrid, queue_size=1, latch=True)
        self.addCleanup(self.latched.unregister)
        self.latched.publish(self.grid)
        self.poses = []
        self.run_node('pose_fitting')
        self.poses_in = rospy.Subscriber('pose', BodyPose, self.take)
        self.addCleanup(self.poses_in.unregister)

    def take(self, pose):
        """/diagnostics comes once a second only."""
        self.poses.append(pose)
        self.sentences.append(pose.reason)

    def expect(self, sentence, infos=(), size=SIZE, encoding='mono8', stages=None, late=0.0):
        def send(stamp):
            for publisher, message in zip(self.infos, infos):
                publisher.publish(message)
            for publisher in self.masks:
                publisher.publish(mask(stamp + rospy.Duration(late), 0, size, encoding))
            for topic in stages or self.stages:
                message = self.stages[topic]
                message.header.stamp = stamp
                message.header.frame_id = 'world'
                self.publishers[topic].publish(message)
        self.send_until(sentence, send)
        self.assertEqual({BodyPose.LOST}, {p.status for p in self.poses})
        self.assertTrue(all(p.reason for p in self.poses))


class NothingToFit(FittingNode):
    method = 'hsiao'
    grid = VoxelGrid(pitch=float('nan'))

    def test_grid_that_is_none(self):
        self.expect('hull/grid has sent what cannot be used: voxel grid is unusable')


class FittingSkeletons(FittingNode):
    method = 'hsiao'

    def test_needs_neither_cameras_nor_tree(self):
        self.expect('the hull has no voxels', stages=['hull/points', 'segmentation/points', 'segmentation/parts'])
        self.assertTrue(self.poses)

    def test_a_second_sender_of_the_grid_is_named(self):
        while not self.latched.get_num_connections():  # the test's grid is to be the first
            self.assertIsNone(self.process.poll(), 'the node has ended')
            rospy.sleep(0.05)
        other = subprocess.Popen(['rostopic', 'pub', '-r', '5', '/hull/grid', 'markerless_mocap/VoxelGrid',
                                  '{header: {frame_id: world}, pitch: 0.05, size: [9, 9, 9]}'],
                                 stdout=subprocess.DEVNULL)
        try:
            self.send_until('what is sent on /hull/grid comes from /rostopic', lambda stamp: None)
        finally:
            other.kill()  # rospy does not always end by SIGTERM
            other.wait()


class FittingContours(FittingNode):
    both = [info('a_optical'), info('b_optical')]

    def test_no_camera_info(self):
        self.expect('no camera_info has been received from b', [info('a_optical')])
        self.assertTrue(self.poses)

    def test_no_tf(self):
        self.expect('tf does not connect nowhere of a to world', [info('nowhere'), self.both[1]])

    def test_zero_k(self):
        self.expect("camera 'a': K is all zero", [info('a_optical', focal=0.0), self.both[1]])

    def test_mask_of_another_size(self):
        self.expect("mask of camera 'a' is 32 x 24 pixels", self.both, size=(32, 24))

    def test_mask_of_another_encoding(self):
        self.expect('has the encoding "8SC1", allowed is mono8', self.both, encoding='8SC1')

    def test_masks_of_other_stamps_are_not_taken(self):
        self.expect('the person is visible in 0 silhouettes', self.both, late=0.05)

    def test_a_stage_that_says_nothing_is_named(self):
        self.expect('pose_tree has sent nothing for this frame set', self.both,
                    stages=['hull/points', 'segmentation/points', 'segmentation/parts'])


def setUpModule():
    rospy.init_node('bad_fitting_input_test')
    place_cameras(tf2_ros.StaticTransformBroadcaster())


if __name__ == '__main__':
    rostest.rosrun('markerless_mocap', 'bad_fitting_input', 'bad_fitting_input_test')

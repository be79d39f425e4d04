#!/usr/bin/python3
"""The graph is steered while it runs: settings, services, the volume's handles, what is displayed."""
import os
import struct
import unittest

import rospkg
import rospy
import rostest
import yaml
from diagnostic_msgs.msg import DiagnosticArray
from dynamic_reconfigure.client import Client, DynamicReconfigureCallbackException
from dynamic_reconfigure.msg import Config, DoubleParameter
from dynamic_reconfigure.srv import Reconfigure
from markerless_mocap.msg import BodyParts, BodyPose, PoseTree, VoxelGrid
from sensor_msgs.msg import Image, JointState, PointCloud2
from std_srvs.srv import SetBool, Trigger
from visualization_msgs.msg import (InteractiveMarkerFeedback, InteractiveMarkerInit, Marker,
                                    MarkerArray)

CAMERAS = [f'cam{i}' for i in range(8)]
PATIENCE = 60  # s; the machine may have other things to do


def is_measured(pose):
    return pose.status != BodyPose.LOST and 'the body is being measured' not in pose.reason


class Recorder:
    """Keeps what comes on a topic."""

    def __init__(self, topic, kind):
        self.messages = []
        self.subscriber = rospy.Subscriber(topic, kind, self.messages.append, queue_size=200)

    def since(self, stamp):
        return [m for m in self.messages if m.header.stamp > stamp]


class Steering(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('steering_test')
        cls.poses = Recorder('pose', BodyPose)
        cls.hulls = Recorder('hull/points', PointCloud2)
        cls.grids = Recorder('hull/grid', VoxelGrid)
        cls.masks = [Recorder(camera + '/silhouette', Image) for camera in CAMERAS]
        cls.clients = {stage: Client('/' + stage, timeout=PATIENCE) for stage in
                       ('silhouette', 'visual_hull', 'body_segmentation', 'pose_tree', 'pose_fitting')}

    def wait_for(self, condition, what):
        end = rospy.get_time() + PATIENCE
        while rospy.get_time() < end:
            found = condition()
            if found:
                return found
            rospy.sleep(0.1)
        return self.fail(what)

    def wait_for_pose(self, condition=lambda p: p.status != BodyPose.LOST, what='a tracked pose'):
        now = rospy.Time.now()
        return self.wait_for(lambda: next(filter(condition, self.poses.since(now)), None), what)

    def set(self, stage, **changes):
        return self.clients[stage].update_configuration(changes)

    @staticmethod
    def call(service, kind=Trigger, *arguments):
        rospy.wait_for_service(service, PATIENCE)
        return rospy.ServiceProxy(service, kind)(*arguments)

    def test_volume_and_pitch_change_together(self):
        self.wait_for_pose()
        old = self.wait_for(lambda: self.grids.messages, 'a grid')[-1]
        self.set('visual_hull', pitch=0.04, volume_min_x=-1.42)
        new = self.wait_for(lambda: [g for g in self.grids.messages if g.pitch == 0.04], 'a grid')[-1]
        # None has the one and not the other.
        self.assertEqual({(old.pitch, old.origin.x), (0.04, -1.42)},
                         {(g.pitch, g.origin.x) for g in self.grids.messages})
        self.wait_for(lambda: len(self.hulls.since(new.header.stamp)) >= 3, 'hulls')
        for hull in self.hulls.messages:
            grid = new if hull.header.stamp >= new.header.stamp else old
            for i in range(0, min(hull.width, 200)):
                x = struct.unpack_from('<f', hull.data, i * hull.point_step)[0]
                self.assertAlmostEqual(0.5, (x - grid.origin.x) / grid.pitch % 1.0, 2)
        self.assertEqual(0.04, rospy.get_param('/visual_hull/pitch'))
        self.assertEqual(-1.42, rospy.get_param('/visual_hull/volume_min')[0])
        self.wait_for_pose(what='a pose from the new hulls')
        self.set('visual_hull', pitch=old.pitch, volume_min_x=old.origin.x)

    def test_what_cannot_be_used_is_refused_and_the_old_stays(self):
        before = rospy.get_param('/visual_hull/pitch', 0.03)
        with self.assertRaises(DynamicReconfigureCallbackException):
            self.set('visual_hull', pitch=0.1, volume_min_x=9.0)  # the first could be used
        with self.assertRaises(rospy.ServiceException) as refusal:
            self.call('/visual_hull/set_parameters', Reconfigure,
                      Config(doubles=[DoubleParameter('pitch', 0.5)]))
        self.assertIn('visual_hull/pitch is 0.5, allowed is 0.005 to 0.2', str(refusal.exception))
        with self.assertRaises(rospy.ServiceException) as refusal:  # of this rig
            self.call('/visual_hull/set_parameters', Reconfigure, Config(doubles=[
                DoubleParameter('volume_min_z', 50.0), DoubleParameter('volume_max_z', 52.0)]))
        self.assertTrue(str(refusal.exception))
        self.wait_for_pose()
        self.assertEqual(before, self.clients['visual_hull'].get_configuration()['pitch'])
        self.assertEqual(before, rospy.get_param('/visual_hull/pitch', 0.03))

    def test_all_cameras_change_from_the_same_frame_set_on(self):
        self.wait_for_pose()
        start = rospy.Time.now()
        self.set('silhouette', threshold_sigmas=50.0, min_sigma=50.0)  # nothing differs that much
        self.wait_for(lambda: all(any(not any(m.data) for m in c.since(start)) for c in self.masks),
                      'empty masks')
        rospy.sleep(1.0)
        self.set('silhouette', threshold_sigmas=3.0, min_sigma=4.0)
        self.wait_for(lambda: all(any(c.since(start)[-1].data) for c in self.masks), 'masks')
        seen = {}
        for camera in self.masks:
            for mask in camera.since(start):
                seen.setdefault(mask.header.stamp, []).append(any(mask.data))
        whole = [masks for masks in seen.values() if len(masks) == len(CAMERAS)]
        self.assertIn([True] * 8, whole)
        self.assertIn([False] * 8, whole)
        self.assertEqual([], [masks for masks in whole if len(set(masks)) > 1])

    def test_segmentation_and_tree_change(self):
        parts, trees = Recorder('segmentation/parts', BodyParts), Recorder('pose_tree', PoseTree)
        self.set('body_segmentation', min_litres=190.0)
        self.wait_for(lambda: any('a person 190 to 200' in m.reason for m in parts.messages), 'parts')
        self.set('body_segmentation', min_litres=15.0)
        validity = self.clients['pose_tree'].get_configuration()['min_validity']
        self.set('pose_tree', min_validity=1.0)
        changed = rospy.Time.now()
        self.wait_for(lambda: any(t.status != PoseTree.OK for t in trees.since(changed)), 'a tree')
        self.set('pose_tree', min_validity=validity)

    def test_the_filter_can_be_switched_off(self):
        joints = Recorder('/humans/bodies/person1/joint_states', JointState)
        self.set('pose_fitting', filter_enabled=False)
        changed = rospy.Time.now()

        def same():
            angles = {p.header.stamp: p.joint_angles for p in self.poses.since(changed)
                      if p.status != BodyPose.LOST}
            return [j for j in joints.since(changed) if angles.get(j.header.stamp) == j.position]
        self.wait_for(lambda: len(same()) >= 3, 'joint states as the raw pose')
        self.assertIs(False, rospy.get_param('/pose_fitting/filter/enabled'))
        self.set('pose_fitting', filter_enabled=True)

    def test_the_body_is_saved_measured_anew_and_loaded(self):
        file = os.path.join(rospkg.get_ros_home(), rospy.get_param('/pose_fitting/body_file'))
        self.wait_for_pose(is_measured, 'a pose of the measured body')
        if os.path.exists(file):
            os.remove(file)  # written after measuring
        try:
            self.assertTrue(self.call('/pose_fitting/save_body').success)
            self.assertIn('torso', open(file).read())
            self.assertTrue(self.call('/pose_fitting/measure_person').success)
            self.wait_for_pose(lambda p: 'the body is being measured' in p.reason, 'measuring')
            refusal = self.call('/pose_fitting/save_body')
            self.assertEqual((False, 'the person has not been measured yet'),
                             (refusal.success, refusal.message))
            self.assertTrue(self.call('/pose_fitting/load_body').success)
            self.wait_for_pose(is_measured, 'a pose of the loaded body')
        finally:
            os.remove(file)
        self.assertFalse(self.call('/pose_fitting/load_body').success)

    def test_tracking_starts_anew(self):
        self.wait_for_pose(lambda p: p.status == BodyPose.TRACKED, 'a tracked pose')
        self.assertTrue(self.call('/pose_fitting/reset_tracking').success)
        self.wait_for_pose(lambda p: p.status == BodyPose.REINITIALIZED, 'a start')

    def test_stages_stop_and_start(self):
        for stage, output in (('pose_fitting', self.poses), ('visual_hull', self.hulls)):
            before = rospy.Time.now()
            self.wait_for(lambda: output.since(before), 'output of ' + stage)
            self.assertTrue(self.call(f'/{stage}/set_running', SetBool, False).success)
            stopped = self.wait_for(lambda: self.masks[0].since(rospy.Time.now() - rospy.Duration(5)),
                                    'masks')[-1].header.stamp
            rospy.sleep(1.0)  # what was on its way has arrived
            count = len(output.messages)
            self.wait_for(lambda: len(self.masks[0].since(stopped)) >= 6, 'masks go on')
            self.assertEqual(count, len(output.messages), stage)
            self.assertTrue(self.call(f'/{stage}/set_running', SetBool, True).success)
            self.wait_for(lambda: len(output.messages) > count, stage + ' goes on')
        self.wait_for_pose()

    def test_a_corner_of_the_volume_is_dragged_and_saved(self):
        self.wait_for_pose()
        shown = rospy.wait_for_message('/hull/volume/update_full', InteractiveMarkerInit, PATIENCE)
        corners = {m.name: m.pose.position for m in shown.markers}
        self.assertEqual({'volume_min', 'volume_max'}, set(corners))
        hand = rospy.Publisher('/hull/volume/feedback', InteractiveMarkerFeedback, queue_size=2)
        self.wait_for(lambda: hand.get_num_connections() > 0, 'the server listens')
        let_go = InteractiveMarkerFeedback(marker_name='volume_max', client_id='test',
                                           event_type=InteractiveMarkerFeedback.MOUSE_UP)
        let_go.header.frame_id = 'world'
        let_go.pose.position = corners['volume_max']
        let_go.pose.position.z = 2.05
        hand.publish(let_go)
        self.wait_for(lambda: rospy.get_param('/visual_hull/volume_max', [0, 0, 0])[2] == 2.05, 'set')
        self.wait_for(lambda: self.grids.messages[-1].size[2] == 69, 'a lower grid')  # of 0.03 m
        file = os.path.join(rospkg.get_ros_home(), rospy.get_param('/visual_hull/volume_file'))
        try:
            self.assertTrue(self.call('/visual_hull/save_volume').success)
            saved = yaml.safe_load(open(file))
            self.assertEqual(2.05, saved['visual_hull']['volume_max'][2])
        finally:
            os.remove(file)
        let_go.pose.position.z = -9.0  # below the other corner
        hand.publish(let_go)
        now = rospy.Time.now()
        self.wait_for_pose()
        self.assertEqual(2.05, rospy.get_param('/visual_hull/volume_max')[2])
        self.assertFalse([g for g in self.grids.since(now) if g.size[2] != 69])

    def test_who_looks_on_sees_the_body_in_the_images(self):
        overlays, images = Recorder('cam0/overlay', Image), Recorder('cam0/image_raw', Image)

        def pair():
            plain = {i.header.stamp: i for i in images.messages}
            return next(((o, plain[o.header.stamp]) for o in overlays.messages
                         if o.header.stamp in plain), None)
        overlay, image = self.wait_for(pair, 'an overlay and its image')
        self.assertEqual((image.width, image.height, 'bgr8'),
                         (overlay.width, overlay.height, overlay.encoding))
        changed = sum(a != b for a, b in zip(overlay.data, image.data))
        self.assertGreater(changed, 600)
        self.assertLess(changed, len(image.data) // 2)
        text = rospy.wait_for_message('pose/text', Marker, PATIENCE)
        self.assertTrue(text.text)
        cameras = self.wait_for(lambda: self.used_cameras() == 8, 'green frustums')
        self.assertTrue(cameras)

    def test_who_asks_for_it_gets_the_mask_of_the_person(self):
        persons = Recorder('cam0/person', Image)

        def pairs():
            masks = {m.header.stamp: m for m in self.masks[0].messages}
            found = [(p, masks[p.header.stamp]) for p in persons.messages if p.header.stamp in masks]
            return found if len(found) >= 9 else None
        overlaps = []
        for person, mask in self.wait_for(pairs, 'masks of the person and their silhouettes')[:9]:
            self.assertEqual((mask.width, mask.height, 'mono8', mask.header.frame_id),
                             (person.width, person.height, person.encoding, person.header.frame_id))
            both = sum(a == b == 255 for a, b in zip(person.data, mask.data))
            either = sum(a == 255 or b == 255 for a, b in zip(person.data, mask.data))
            self.assertGreater(either, 200)
            overlaps.append(both / either)
        self.assertGreater(sorted(overlaps)[4], 0.95, 'the person is alone in the room')

    @staticmethod
    def used_cameras():
        shown = rospy.wait_for_message('hull/cameras', MarkerArray, PATIENCE)
        return sum(m.color.g > m.color.r for m in shown.markers if m.ns == 'frustums')

    def test_diagnostics_are_grouped(self):
        grouped = Recorder('/diagnostics_agg', DiagnosticArray)
        wanted = {'/Motion capture', '/Motion capture/Person', '/Motion capture/Cameras',
                  '/Motion capture/Hull and parts'}
        self.wait_for(lambda: wanted <= {s.name for d in grouped.messages for s in d.status}, 'groups')
        last = {s.name for s in grouped.messages[-1].status}
        self.assertEqual(8, sum(n.startswith('/Motion capture/Cameras/') for n in last), last)


if __name__ == '__main__':
    rostest.rosrun('markerless_mocap', 'steering', Steering)

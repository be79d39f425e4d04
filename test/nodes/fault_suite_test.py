#!/usr/bin/python3
"""Faults of cameras, clocks and stages, one after another, while a person is followed: what is
published stays true, comes in time, and every fault is told. FAULTS=name,name runs some only; each
prints what was measured."""
import collections
import os
import pathlib
import random
import signal
import tempfile
import time
import unittest
import xmlrpc.client

import cv2
import rosgraph
import rosnode
import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray
from faulty_cameras import (CAMERAS, EMPTY, RATE, Cameras, Recording, in_light, places, redrawn,
                            render, with_noise)
from markerless_mocap.msg import BodyPose, MocapStatus
from sensor_msgs.msg import CameraInfo
from tf2_msgs.msg import TFMessage

FALSE = 0.20  # m; without faults the worst joint is off by 0.05 to 0.1
SECONDS = 3.0
WALKS = EMPTY + 25, EMPTY + 70  # frame sets in which the person leaves the place
Pose = collections.namedtuple('Pose', 'sent latency error limbs')  # s, s, m, m by limb
# Ends of limbs, and their places in part_deviation.
LIMBS = {'l_wrist': 2, 'r_wrist': 3, 'l_ankle': 4, 'r_ankle': 5}


class FaultSuite(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('fault_suite_test')
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, 'room.bag')
            render(path)
            cls.recording = Recording(path)
        cls.cameras = Cameras(cls.recording)
        cls.poses, cls.lost, cls.states, cls.beats = [], [], [], []
        cls.expected = {}  # stamp, ns -> expected error of each part, m
        cls.covered, cls.limbs = 0, 0  # of all cases
        rospy.Subscriber('/tf', TFMessage, cls.keep_pose, queue_size=200, tcp_nodelay=True)
        rospy.Subscriber('pose', BodyPose, cls.keep_lost, queue_size=200)
        rospy.Subscriber('/diagnostics', DiagnosticArray, cls.keep_states, queue_size=200)
        rospy.Subscriber('pose/status', MocapStatus, cls.beats.append, queue_size=20)
        wait_for(lambda: all(p.get_num_connections() > 0 for p in cls.cameras.images.values()), 30)
        time.sleep(1.0)
        cls.cameras.thread.start()
        wait_for(lambda: len(cls.poses) >= 60, 60)
        time.sleep(3.0)

    @classmethod
    def keep_pose(cls, message):
        if message.transforms and any('person1' in t.child_frame_id for t in message.transforms):
            stamp = message.transforms[0].header.stamp.to_nsec()
            sent = cls.cameras.sent_at[cls.cameras.nearest(stamp)]
            found = places(message.transforms)
            limbs = {limb: (stamp, cls.cameras.limb_error(found, limb, stamp)) for limb in LIMBS
                     if limb in found}
            cls.poses.append(Pose(sent, time.time() - sent, cls.cameras.error(found, stamp), limbs))

    @classmethod
    def keep_lost(cls, pose):
        if pose.status == BodyPose.LOST:
            cls.lost.append((time.time(), pose.reason))
        else:
            cls.expected[pose.header.stamp.to_nsec()] = pose.part_deviation

    @classmethod
    def keep_states(cls, message):
        for status in message.status:
            name = status.name.split(': ', 1)[-1]
            cls.states.append((time.time(), name, ord(status.level) if isinstance(
                status.level, bytes) else status.level, status.message))

    def setUp(self):
        self.assertGreaterEqual(len(self.poses), 60, {r for _, r in self.lost})
        wait_for(lambda: len(self.since(time.time() - 1.5)) > 0.8 * RATE, 20)  # no backlog
        self.usual_latency = median([p.latency for p in self.poses[-10:]])
        self.start = time.time()

    def since(self, start):
        return [p for p in self.poses if p.sent >= start]

    def run_fault(self, seconds=SECONDS):
        time.sleep(seconds)
        self.end = time.time()
        self.cameras.heal()

    def finish(self):
        """Waits for poses of what was sent after the fault. All times are those of sending, so that
        a slow machine only makes it longer."""
        wait_for(lambda: len([p for p in self.since(self.end) if p.error < FALSE]) >= 8, 20)
        after = [p for p in self.since(self.end) if p.error < FALSE]
        everything = self.since(self.start)
        self.during = [p for p in everything if p.sent < self.end]
        self.recovery = after[0].sent - self.end if after else 99.0
        self.false = [p for p in everything if p.error >= FALSE]
        self.latency = median([p.latency for p in self.during if p.sent > self.start + 1.2])
        times = [self.start] + [p.sent for p in everything]
        self.silence = max((b - a for a, b in zip(times, times[1:])), default=99.0)
        within = self.count_covered(everything)
        print('%-24s poses %3d of %3d, false %2d, worst %.2f m, latency %.2f s (before %.2f s), '
              'silence %.2f s, back after %.2f s, limbs within twice the expected error %s' % (
                  self.id().split('test_')[-1], len(self.during), RATE * (self.end - self.start),
                  len(self.false), max((p.error for p in everything), default=0.0), self.latency,
                  self.usual_latency, self.silence, self.recovery, within), flush=True)

    def count_covered(self, poses):
        """How many limbs are off by at most twice what was expected of them."""
        covered = [error <= 2 * self.expected[stamp][LIMBS[limb]]
                   for pose in poses for limb, (stamp, error) in pose.limbs.items()
                   if stamp in self.expected]
        FaultSuite.covered += sum(covered)
        FaultSuite.limbs += len(covered)
        return '%d of %d' % (sum(covered), len(covered))

    @classmethod
    def tearDownClass(cls):
        print('limbs within twice the expected error: %d of %d (%.1f %%)' % (
            cls.covered, cls.limbs, 100.0 * cls.covered / max(cls.limbs, 1)), flush=True)

    def said(self, text, level=None):
        return any(text in message and (level is None or found >= level)
                   for at, _, found, message in self.states if at >= self.start)

    def expect(self, *sentences, least=0.6, level=1, silence=1.0, some=False):
        """All or some of the sentences are said, hardly a pose is false, and poses go on."""
        quantity = any if some else all
        told = lambda: not sentences or quantity(self.said(s, level) for s in sentences)
        wait_for(told, 4)
        self.finish()
        self.assertTrue(told(), (sentences, self.messages()))
        self.assertLessEqual(len(self.false), round(0.2 * RATE))
        self.assertGreaterEqual(len(self.during), least * RATE * (self.end - self.start))
        self.assertLess(self.silence, silence)

    def messages(self):
        return sorted({(n, l, m) for at, n, l, m in self.states if at >= self.start and l > 0})

    def level_of(self, stage):
        levels = [(level, message) for at, name, level, message in self.states if name == stage]
        return levels[-1] if levels else (None, '')

    def test_a_nothing_is_wrong(self):
        self.run_fault(2.0)
        self.expect(least=0.8)

    def step(self, seconds):
        shift = rospy.Duration.from_sec(seconds)
        self.cameras.stamp_of = lambda camera, stamp: stamp + shift
        time.sleep(SECONDS)
        self.end = time.time()

    def set_right(self):
        self.cameras.heal()
        time.sleep(1.5)

    def test_clock_back_1s(self):
        self.step(-1.0)
        self.expect('set back by 1.0', 'set back by 0.9', some=True)
        self.assertFalse(self.said('learning the background'))
        self.set_right()

    def test_clock_back_300ms(self):
        self.step(-0.3)
        self.expect('set back by 0.3', 'set back by 0.2', some=True)
        self.set_right()

    def test_one_image_ahead(self):
        left = {camera: 1 for camera in CAMERAS}

        def stamp_of(camera, stamp):
            left[camera] -= 1
            return stamp + rospy.Duration(1.0) if left[camera] >= 0 else stamp
        self.cameras.stamp_of = stamp_of
        self.run_fault()
        self.expect()
        self.assertFalse(self.said('learning the background'))

    def test_stamps_zero(self):
        self.cameras.stamp_of = lambda camera, stamp: rospy.Time(0)
        self.run_fault()
        self.expect('stamps of cam0', least=0, level=2, silence=5.0)
        self.assertLess(self.recovery, 1.5)

    def test_camera_gone(self):
        self.cameras.sends = lambda camera: camera != 'cam3'
        self.run_fault(4.0)
        self.expect('no messages on /cam3/silhouette', 'no messages on /cam3/image_raw')
        self.assertLess(self.latency, self.usual_latency + 0.35)

    def test_cameras_gone(self):
        self.cameras.sends = lambda camera: False
        time.sleep(SECONDS + 0.5)
        for stage in ('visual hull', 'body segmentation', 'pose tree', 'pose fitting',
                      'silhouette of cam0'):
            level, message = self.level_of(stage)
            self.assertEqual(2, level, (stage, message))
        self.assertEqual(MocapStatus.ERROR, self.beats[-1].level)
        self.assertEqual(CAMERAS, self.beats[-1].cameras)
        self.assertGreater((self.beats[-1].header.stamp - self.beats[-1].last_stamps[0]).to_sec(), 2)
        self.end = time.time()
        self.cameras.heal()
        self.expect('no camera sends', least=0, level=2, silence=5.5)
        self.assertLess(self.recovery, 1.5)

    def stop_stage(self, stage):
        """A stage that nobody needs to follow the person: poses go on."""
        pid = pid_of(stage)
        os.kill(pid, signal.SIGSTOP)
        try:
            time.sleep(SECONDS + 1.0)
            self.end = time.time()
        finally:
            os.kill(pid, signal.SIGCONT)
        self.expect()
        self.assertLess(self.latency, self.usual_latency + 0.35)

    def test_pose_tree_hangs(self):
        self.stop_stage('pose_tree')

    def test_body_segmentation_hangs(self):
        self.stop_stage('body_segmentation')

    def kill_stage(self, stage):
        pid = pid_of(stage)
        os.kill(pid, signal.SIGKILL)
        time.sleep(SECONDS)
        wait_for(lambda: runs_again(stage, pid), 30)
        self.end = time.time()
        self.expect()
        self.assertLess(self.latency, self.usual_latency + 0.35)

    def test_pose_tree_is_killed(self):
        self.kill_stage('pose_tree')

    def test_visual_hull_is_killed(self):
        self.kill_stage('visual_hull')

    def test_stamps_of_one_off(self):
        for shift in (0.03, -0.05, 0.05):
            self.start = time.time()
            self.cameras.stamp_of = (lambda camera, stamp, s=rospy.Duration(shift):
                                     stamp + s if camera == 'cam2' else stamp)
            self.run_fault(4.0)
            self.expect('cam2 is left out, its nearest stamp is')

    def test_content_of_one_late(self):
        self.cameras.content_of = lambda camera, frame: frame - 3 * (camera == 'cam2')
        self.run_fault()
        self.expect(level=0)

    def freeze(self, *frozen):
        at = self.cameras.frame
        self.cameras.content_of = lambda camera, frame: at if camera in frozen else frame
        self.run_fault()
        self.expect(*[camera + ' is frozen' for camera in frozen])

    def test_one_frozen(self):
        self.freeze('cam1')

    def test_two_frozen(self):
        self.freeze('cam1', 'cam4')

    def test_truncated_jpegs_of_one(self):
        self.cameras.data_of = (lambda camera, data:
                                data[:len(data) // 2] if camera == 'cam5' else data)
        self.run_fault()
        self.expect('cam5 has sent images that cannot be used')

    # Last: some damaged JPEGs are decoded without complaint, and what they do to a background stays
    # for a while (it is told that it is stale).
    def test_zz_corrupted_jpegs(self):
        self.cameras.data_of = lambda camera, data: data[:1500] + b'\x5a' * 400 + data[1900:]
        self.run_fault(2.0)
        self.expect('has sent images that cannot be used', least=0, silence=4.0)
        self.assertLess(self.recovery, 1.5)

    def pictures_of_one(self, change, *sentences):
        self.cameras.data_of = lambda camera, data: change(data) if camera == 'cam5' else data
        self.run_fault()
        self.expect(*sentences)

    def test_pictures_of_one_are_black(self):
        self.pictures_of_one(lambda data: in_light(data, 0.0))

    def test_pictures_of_one_are_mirrored(self):
        self.pictures_of_one(lambda data: redrawn(data, lambda picture: cv2.flip(picture, 1)))

    def test_pictures_of_one_are_half_as_large(self):
        self.pictures_of_one(lambda data: redrawn(data, lambda picture: picture[::2, ::2]),
                             'cam5 has sent images that cannot be used')

    def test_pictures_of_one_are_empty(self):
        self.pictures_of_one(lambda data: b'', 'cam5 has sent images that cannot be used')

    def light(self, factor):
        self.cameras.data_of = lambda camera, data: in_light(data, factor)
        time.sleep(SECONDS)
        self.end = time.time()
        self.cameras.heal()

    def test_white_light(self):
        self.light(8.0)
        self.expect(least=0, silence=5.0)
        self.assertLess(self.recovery, 1.5)
        self.assertFalse(self.said('stood still in view'))

    def test_darkness(self):
        self.light(0.02)
        self.expect(least=0, silence=5.0)
        self.assertLess(self.recovery, 1.5)
        self.assertFalse(self.said('stood still in view'))

    def test_k_wanders(self):
        def info_of(camera, info):
            wandering = CameraInfo(**{name: getattr(info, name) for name in info.__slots__})
            wandering.K = list(info.K)
            wandering.K[0] += 0.01 * (self.cameras.frame % 50)
            return wandering
        self.cameras.info_of = info_of
        self.run_fault()
        self.expect('changes all the time')

    def test_camera_info_of_other_images(self):
        def info_of(camera, info):
            other = CameraInfo(**{name: getattr(info, name) for name in info.__slots__})
            other.width = other.height = 30000
            return other
        self.cameras.info_of = info_of
        self.run_fault()
        self.expect('but the new one is not used: it says 30000 x 30000')

    def test_camera_info_of_no_lens(self):
        def info_of(camera, info):
            other = CameraInfo(**{name: getattr(info, name) for name in info.__slots__})
            other.D = [1e6, -1e9, 0.0, 0.0, 0.0]
            return other
        self.cameras.info_of = info_of
        self.run_fault()
        self.expect('but the new one is not used')

    def test_y_camera_moves_by_tf(self):
        self.cameras.place('cam6', 0.3)
        self.run_fault(2.0)
        # The way back, while nobody sends: it is believed at once when they do again.
        self.cameras.sends = lambda camera: False
        time.sleep(0.3)
        self.cameras.place('cam6', 0.0)
        time.sleep(0.7)
        self.end = time.time()
        self.cameras.heal()
        self.expect('cam6 has moved by tf, it is left out until it rests',
                    'cam6 has moved by 0.300 m and 0.0 degrees by tf, its new pose', least=0,
                    silence=4.0)

    def test_y_camera_keeps_moving_by_tf(self):
        for i in range(20):
            self.cameras.place('cam6', 0.3 + 0.1 * (i % 3))
            time.sleep(0.2)
        self.cameras.place('cam6', 0.0)
        self.run_fault(0.1)
        self.expect('cam6 has moved by tf, it is left out until it rests')

    def test_z_silhouette_starts_again(self):
        pid = pid_of('silhouette')
        os.kill(pid, signal.SIGKILL)
        time.sleep(0.8)  # what is under way
        self.end = time.time()
        self.expect('is that of /tmp', least=0, silence=5.0)
        self.assertLess(self.recovery, 4.0)
        self.assertFalse(self.said('learning the background, 2'))

    def test_zzy_stands_still_while_the_background_is_learned(self):
        """Nobody can know at first: it is told, and no ghost becomes a pose. When the masks are
        right again is tested in test/silhouette/uncovered_test.cpp."""
        noisy = {}

        def data_of(camera, data):
            which = camera, hash(data), random.randrange(6)
            if which not in noisy:
                noisy[which] = with_noise(data)
            return noisy[which]
        wait_for(lambda: WALKS[0] < self.cameras.index(self.cameras.frame) < WALKS[1], 20)
        self.cameras.stands, self.cameras.data_of = True, data_of
        time.sleep(1.0)
        for camera in CAMERAS:
            pathlib.Path('/tmp/%s.background' % camera).unlink(missing_ok=True)
        os.kill(pid_of('silhouette'), signal.SIGKILL)
        asked = time.time()
        wait_for(lambda: any('whoever stands still there' in m for at, _, _, m in self.states
                             if at > asked), 30)
        time.sleep(3.0)
        self.assertTrue(self.said('somebody has stood still since the background was learned', 1))
        self.end = time.time()
        self.cameras.heal()
        wait_for(lambda: self.said('stood still in view of'), 20)
        self.finish()
        self.assertTrue(self.said('stood still in view of', 1), self.messages())
        self.assertLessEqual(len(self.false), round(0.2 * RATE))

    def test_zzz_expected_errors_cover_the_real_ones(self):
        self.assertGreaterEqual(self.covered, 0.95 * self.limbs, 'of all cases before')


def pid_of(node):
    """By the master, as other runs may have nodes of the same name."""
    uri = rosnode.get_api_uri(rosgraph.Master('/fault_suite'), '/' + node, skip_cache=True)
    code, message, pid = xmlrpc.client.ServerProxy(uri).getPid('/fault_suite')
    assert code == 1, message
    return pid


def runs_again(node, killed):
    try:
        return pid_of(node) != killed
    except OSError:  # it has not registered yet
        return False


def median(values):
    return sorted(values)[len(values) // 2] if values else 99.0


def wait_for(condition, seconds):
    end = time.time() + seconds
    while time.time() < end and not condition():
        time.sleep(0.05)


if __name__ == '__main__':
    wanted = [name for name in os.environ.get('FAULTS', '').split(',') if name]
    for name in [n for n in dir(FaultSuite) if n.startswith('test_')]:
        if wanted and not any(w in name for w in wanted):
            delattr(FaultSuite, name)
    rostest.rosrun('markerless_mocap', 'fault_suite', FaultSuite)

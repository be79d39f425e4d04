"""The live graph with a recording as its cameras: what it publishes is compared with the truth while
something is wrong. Each case prints what was measured."""
import collections
import os
import shutil
import tempfile
import time
import unittest
import xmlrpc.client

import rosgraph
import rosnode
import rospy
from diagnostic_msgs.msg import DiagnosticArray
from faulty_cameras import RATE, Cameras, Recording, places, render
from markerless_mocap.msg import BodyPose, MocapStatus
from tf2_msgs.msg import TFMessage

FALSE = 0.20  # m; without faults the worst joint is off by 0.05 to 0.1
SECONDS = 3.0
Pose = collections.namedtuple('Pose', 'sent latency error limbs')  # s, s, m, m by limb
# Ends of limbs, and their places in part_deviation.
LIMBS = {'l_wrist': 2, 'r_wrist': 3, 'l_ankle': 4, 'r_ankle': 5}


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


class FaultCase(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('fault_suite_test')
        # Its own: what another run has left there would be the background of this one.
        cls.folder = rospy.get_param('silhouette/background_folder')
        os.mkdir(cls.folder)
        cls.addClassCleanup(shutil.rmtree, cls.folder)
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
        self.measured = (
            '%-24s poses %3d of %3d, false %2d, worst %.2f m, latency %.2f s (before %.2f s), '
            'silence %.2f s, back after %.2f s, limbs within twice the expected error %s' % (
                self.id().split('test_')[-1], len(self.during), RATE * (self.end - self.start),
                len(self.false), max((p.error for p in everything), default=0.0), self.latency,
                self.usual_latency, self.silence, self.recovery, within))
        print(self.measured, flush=True)

    def count_covered(self, poses):
        """How many limbs are off by at most twice what was expected of them."""
        covered = [error <= 2 * self.expected[stamp][LIMBS[limb]]
                   for pose in poses for limb, (stamp, error) in pose.limbs.items()
                   if stamp in self.expected]
        type(self).covered += sum(covered)
        type(self).limbs += len(covered)
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
        self.assertLessEqual(len(self.false), round(0.2 * RATE), self.measured)
        self.assertGreaterEqual(len(self.during), least * RATE * (self.end - self.start),
                                self.measured)
        self.assertLess(self.silence, silence, self.measured)

    def messages(self):
        return sorted({(n, l, m) for at, n, l, m in self.states if at >= self.start and l > 0})

    def level_of(self, stage):
        levels = [(level, message) for at, name, level, message in self.states if name == stage]
        return levels[-1] if levels else (None, '')

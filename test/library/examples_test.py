#!/usr/bin/python3
"""The examples while somebody walks and waves, is lost, is not heard of, and is not alone."""
import copy
import math
import statistics
import sys
import time
import unittest
import xml.etree.ElementTree

import numpy
import rosbag
import rospy
import rostest
import tf2_ros
from geometry_msgs.msg import TransformStamped
from markerless_mocap.msg import BodyPose
from nearest_hand.msg import HandDistance
from sensor_msgs.msg import JointState, PointCloud2
from std_msgs.msg import Bool
from tf2_msgs.msg import TFMessage

ROBOT = numpy.array([1.0, 0.2, 1.1])
PERIOD = 1.0 / 15.0
LIMIT = 60.0  # s for what comes at once on an idle machine


class Frame:
    """All messages of one frame set, and the true joints."""

    def __init__(self):
        self.pose = self.tf = self.hull = self.truth = None


def read(folder):
    frames = {}
    kept = {'/pose': 'pose', '/tf': 'tf', '/hull/points': 'hull', '/ground_truth/joints': 'truth'}
    for name in ('film.bag', 'result.bag'):
        with rosbag.Bag(folder + '/' + name) as bag:
            for topic, message, stamp in bag.read_messages(topics=list(kept)):
                setattr(frames.setdefault(stamp.to_nsec(), Frame()), kept[topic], message)
    whole = [frames[s] for s in sorted(frames) if all(vars(frames[s]).values())]
    return [f for f in whole if f.pose.status != BodyPose.LOST]


def true_distance(frame):
    """From the robot to the nearest hand, wrist to finger tips."""
    places = {n: numpy.array([p.x, p.y, p.z])
              for n, p in zip(frame.truth.names, frame.truth.positions)}
    ways = []
    for side in 'lr':
        wrist, tip = places[side + '_wrist'] - ROBOT, places[side + '_hand_tip'] - ROBOT
        share = min(1.0, max(0.0, -wrist.dot(tip - wrist) / (tip - wrist).dot(tip - wrist)))
        ways.append(numpy.linalg.norm(wrist + share * (tip - wrist)))
    return min(ways)


def rotation(axis, angle):
    x, y, z = axis
    cross = numpy.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return numpy.eye(3) + math.sin(angle) * cross + (1 - math.cos(angle)) * cross @ cross


def of_another(frame, body, shift):
    """The same person once more, elsewhere."""
    other = copy.deepcopy(frame)
    other.pose.body_id = body
    for t in other.tf.transforms:
        t.child_frame_id = t.child_frame_id.replace('person1', body)
        t.header.frame_id = t.header.frame_id.replace('person1', body)
        if t.header.frame_id == 'world':
            t.transform.translation.x += shift[0]
            t.transform.translation.y += shift[1]
            t.transform.translation.z += shift[2]
    return other


class Examples(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        rospy.init_node('examples_test')
        cls.frames = read(sys.argv[1])
        cls.answers, cls.commands, cls.following, cls.coarse = [], [], [], []
        rospy.Subscriber('hand_distance', HandDistance, cls.answers.append, queue_size=500)
        rospy.Subscriber('joint_states', JointState, cls.commands.append, queue_size=5000)
        rospy.Subscriber('following', Bool, cls.following.append, queue_size=50)
        rospy.Subscriber('coarse_hull/output', PointCloud2, cls.coarse.append, queue_size=50)
        cls.pose = rospy.Publisher('pose', BodyPose, queue_size=50)
        cls.tf = rospy.Publisher('/tf', TFMessage, queue_size=50)
        cls.hull = rospy.Publisher('hull/points', PointCloud2, queue_size=50)
        cls.static = tf2_ros.StaticTransformBroadcaster()
        cls.buffer = tf2_ros.Buffer()
        cls.listener = tf2_ros.TransformListener(cls.buffer)
        robot = TransformStamped()
        robot.header.frame_id, robot.child_frame_id = 'world', 'tool0'
        robot.transform.translation.x, robot.transform.translation.y, \
            robot.transform.translation.z = ROBOT
        robot.transform.rotation.w = 1.0
        cls.static.sendTransform(robot)
        cls.wait(lambda: cls.pose.get_num_connections() == 2 and cls.tf.get_num_connections() >= 3)

    @staticmethod
    def wait(condition):
        end = time.time() + LIMIT
        while time.time() < end and not condition():
            time.sleep(0.02)
        return condition()

    def send(self, frame, stamp):
        """tf comes before the pose, then after it."""
        for t in frame.tf.transforms:
            t.header.stamp = stamp
        frame.pose.header.stamp = frame.hull.header.stamp = stamp
        self.hull.publish(frame.hull)
        messages = [(self.tf, frame.tf), (self.pose, frame.pose)]
        for publisher, message in messages[::1 if stamp.nsecs % 2 else -1]:
            publisher.publish(message)
            time.sleep(0.005)

    def play(self, frames, late=0.0):
        """{stamp: frame}"""
        start, sent = rospy.Time.now(), {}
        for k, frame in enumerate(frames):
            due = start + rospy.Duration(k * PERIOD)
            rospy.sleep(due - rospy.Time.now())
            self.send(frame, due - rospy.Duration(late))
            sent[due - rospy.Duration(late)] = frame
        return sent

    def play_until(self, condition, edit=lambda frame: [frame]):
        """One frame again and again."""
        end = time.time() + LIMIT
        while time.time() < end and not condition():
            self.play(edit(copy.deepcopy(self.frames[-1])))
            time.sleep(PERIOD)
        self.assertTrue(condition(), self.answers[-1])

    def last(self, **wanted):
        return bool(self.answers) and all(getattr(self.answers[-1], name) == value
                                          for name, value in wanted.items())

    def assert_arm_rests(self):
        self.assertTrue(self.wait(lambda: self.following and not self.following[-1].data))
        self.assertTrue(self.wait(lambda: not any(self.commands[-1].velocity)))
        position, count = self.commands[-1].position, len(self.commands)
        self.assertTrue(self.wait(lambda: len(self.commands) > count + 20))
        self.assertEqual(position, self.commands[-1].position)

    def test_a_distance_is_the_truth_with_every_pose(self):
        self.play_until(lambda: self.last(state=HandDistance.KNOWN))  # tool0 is known
        sent = self.play(self.frames)
        answered = lambda: {a.header.stamp: a for a in self.answers if a.header.stamp in sent}
        self.assertTrue(self.wait(lambda: len(answered()) == len(sent)))
        known = {s: a for s, a in answered().items() if a.state == HandDistance.KNOWN}
        self.assertGreater(len(known), 0.8 * len(sent), {a.reason for a in answered().values()})
        self.assertEqual({'tool0'}, {a.header.frame_id for a in known.values()})
        errors = [abs(a.distance - true_distance(sent[s])) for s, a in known.items()]
        covered = [float(a.margin >= e) for e, a in zip(errors, known.values())]
        print('distance: median error %.1f mm, worst %.1f mm, margin %.1f mm, covers %.0f %%' % (
            1e3 * statistics.median(errors), 1e3 * max(errors),
            1e3 * statistics.median(a.margin for a in known.values()), 100 * statistics.mean(covered)))
        self.assertLess(statistics.median(errors), 0.02)
        self.assertGreater(statistics.mean(covered), 0.9)
        self.assert_speeds(known, sent)

    def assert_speeds(self, known, sent):
        truth = {s: true_distance(f) for s, f in sent.items()}
        stamps = sorted(truth)
        errors = []
        for before, after in zip(stamps, stamps[2:]):
            speed = (truth[before] - truth[after]) / (after - before).to_sec()
            if after in known and not math.isnan(known[after].closing_speed):
                answer = known[after]
                errors.append(abs(answer.closing_speed - speed))
                certain = answer.distance - answer.margin
                if answer.closing_speed > 0:
                    self.assertAlmostEqual(certain / answer.closing_speed, answer.time_to_contact, 6)
                else:
                    self.assertEqual(math.inf, answer.time_to_contact)
                self.assertEqual(certain < answer.protective_distance, answer.stop)
        print('closing speed: median error %.2f m/s of %d' % (statistics.median(errors), len(errors)))
        self.assertGreater(len(errors), len(sent) // 2)
        self.assertLess(statistics.median(errors), 0.2)

    def test_b_the_arm_points_as_the_person_s(self):
        self.play_until(lambda: self.deviation() < math.radians(5))

    def deviation(self):
        """The larger angle between upper arms and between forearms, the person's mirrored."""
        if not self.commands or not self.following[-1].data:
            return math.pi
        places = []
        for link in ('shoulder', 'elbow', 'wrist'):
            t = self.buffer.lookup_transform('torso_person1', 'r_%s_person1' % link, rospy.Time(0))
            places.append(numpy.array([t.transform.translation.x, -t.transform.translation.y,
                                       t.transform.translation.z]))
        pan, lift, roll, elbow = self.commands[-1].position
        upper = rotation((0, 0, 1), pan) @ rotation((0, 1, 0), lift) @ rotation((1, 0, 0), roll)
        fore = upper @ rotation((0, -1, 0), elbow)
        angles = []
        for a, b, robot in ((places[0], places[1], upper[:, 0]), (places[1], places[2], fore[:, 0])):
            angles.append(math.acos(min(1.0, (b - a).dot(robot) / numpy.linalg.norm(b - a))))
        return max(angles)

    def test_c_lost_and_silent(self):
        def lost(frame):  # with tf, so that nothing but the status says it
            frame.pose.status, frame.pose.reason = BodyPose.LOST, 'gone'
            return [frame]
        self.play_until(lambda: self.last(state=HandDistance.KNOWN) and self.following[-1].data)
        self.play_until(lambda: self.last(state=HandDistance.LOST, stop=True), lost)
        self.assertIn('gone', self.answers[-1].reason)
        self.assertTrue(math.isnan(self.answers[-1].distance))
        self.play_until(lambda: not self.following[-1].data, lost)
        self.assert_arm_rests()
        self.play_until(lambda: self.last(state=HandDistance.KNOWN) and self.following[-1].data)
        self.assertTrue(self.wait(lambda: self.last(state=HandDistance.STALE, stop=True)))
        self.assert_arm_rests()

    def test_d_old_stamps(self):
        self.play_until(lambda: self.last(state=HandDistance.KNOWN) and self.following[-1].data)
        for late in (3.0, -3.0):
            said = 's old' if late > 0 else 'ahead'
            count, end = len(self.answers), time.time() + LIMIT
            told = lambda: any(said in a.reason for a in self.answers[count:])
            while time.time() < end and not told():
                self.play(self.frames[-1:], late)
            self.assertTrue(told())
            self.assertTrue(all(a.stop for a in self.answers[count:] if said in a.reason))
            self.assert_arm_rests()

    def test_d_poses_without_frames(self):
        def bare(frame):
            frame.tf.transforms = []
            return [frame]
        self.play_until(lambda: self.last(state=HandDistance.KNOWN) and self.following[-1].data)
        self.play_until(lambda: self.last(state=HandDistance.LOST, stop=True), bare)
        self.assertIn('person1', self.answers[-1].reason + self.answers[-1].body_id)
        self.play_until(lambda: not self.following[-1].data, bare)
        self.assert_arm_rests()

    def test_e_an_arm_that_is_not_seen_may_be_anywhere(self):
        def hide(frame):
            frame.pose.parts_not_seen = ['l_arm', 'r_arm']
            return [frame]
        self.play_until(lambda: self.last(state=HandDistance.UNSEEN), hide)
        answer = self.answers[-1]
        self.assertIn('arm is not seen', answer.reason)
        self.assertLess(answer.distance, true_distance(self.frames[-1]))
        self.assertTrue(math.isnan(answer.closing_speed))
        self.assert_arm_rests()

    def test_f_limits_and_rates_were_obeyed(self):
        robot = xml.etree.ElementTree.fromstring(rospy.get_param('robot_description'))
        limits = {j.get('name'): {k: float(v) for k, v in j.find('limit').attrib.items()}
                  for j in robot.findall('joint') if j.find('limit') is not None}
        commands = list(self.commands)
        self.assertGreater(len(commands), 500)
        fastest = 0.0
        for last, now in zip(commands, commands[1:]):
            seconds = (now.header.stamp - last.header.stamp).to_sec()
            self.assertEqual(set(limits), set(now.name))
            for name, a, b in zip(now.name, last.position, now.position):
                self.assertLessEqual(abs(b - a), limits[name]['velocity'] * max(0.0, seconds) + 1e-6)
                self.assertTrue(limits[name]['lower'] <= b <= limits[name]['upper'])
                fastest = max(fastest, abs(b - a))
        self.assertGreater(fastest, 0.0)

    def test_g_the_hull_passes_the_filters(self):
        self.play_until(lambda: self.coarse)
        self.assertEqual('world', self.coarse[-1].header.frame_id)
        self.assertGreater(self.coarse[-1].width, 20)
        self.assertLess(self.coarse[-1].width, 0.2 * self.frames[-1].hull.width)

    def test_h_several_bodies(self):
        self.play_until(lambda: self.last(state=HandDistance.KNOWN))
        hand = self.answers[-1].point
        near = -0.9 * numpy.array([hand.x, hand.y, hand.z])
        both = lambda frame: [frame, of_another(frame, 'person2', near)]
        self.play_until(lambda: self.last(state=HandDistance.KNOWN, body_id='person2', stop=True)
                        and self.following[-1].data, both)
        far = lambda frame: [frame, of_another(frame, 'person2', [9.0, 0.0, 0.0])]
        self.play_until(lambda: self.last(state=HandDistance.KNOWN, body_id='person1'), far)

        def one_lost(frame):
            other = of_another(frame, 'person2', near)
            other.pose.status, other.tf.transforms = BodyPose.LOST, []
            return [other, frame]
        self.play_until(lambda: self.last(state=HandDistance.LOST, stop=True), one_lost)
        self.assertTrue(self.following[-1].data)  # the arm follows person1, who is not lost
        self.play_until(lambda: self.last(state=HandDistance.STALE, stop=True))
        self.assertIn('person2', self.answers[-1].reason)


if __name__ == '__main__':
    rostest.rosrun('markerless_mocap', 'examples', Examples)

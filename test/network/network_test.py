#!/usr/bin/python3
"""Four computers with two cameras each and one for the rest, in network namespaces: what crosses the
links, and what becomes of the pose when computers die, links fail, clocks differ and roscore ends.

    network_test.py FOLDER_OF_PROGRAMS"""
import os
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import threading
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import namespaces  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
CENTRE = '10.77.0.1'
HOSTS = 4
CAMERAS = [f'cam{i}' for i in range(2 * HOSTS)]
RATE, EMPTY, PERSON = 8.0, 24, 40  # images per second, images of the empty room, images with the person
SIZE = (320, 240)
LONGEST_AGE = 3.0  # s, of a pose when it arrives, on a machine with other work
PROGRAMS = pathlib.Path()


def milliseconds_ahead(camera, text):
    """By which the hull says that the clock of a camera is ahead; NaN: it does not."""
    said = re.search(camera + r' is left out, its nearest stamp is ([\d.]+) ms (later|earlier)', text)
    return float(said[1]) * (1 if said[2] == 'later' else -1) if said else float('nan')


def cameras_of(host):
    return CAMERAS[2 * host:2 * host + 2]


def render(path):
    settings = {'width': SIZE[0], 'height': SIZE[1], 'fps': RATE, 'background_frames': EMPTY,
                'duration': PERSON / RATE}
    subprocess.check_call([PROGRAMS / 'render_capture', path, '--quiet', '--images', 'jpeg', '--rig',
                           'ring7_overhead', '--motion', 'wave_and_walk'] +
                          [s for key, value in settings.items() for s in ('--set', f'{key}={value}')])


class Rig:
    """All computers, and what the centre hears."""

    def __init__(self, folder):
        self.folder, self.bag = folder, folder / 'capture.bag'
        render(self.bag)
        self.centre = namespaces.Computer(CENTRE, CENTRE, folder / 'log')
        self.hosts = [namespaces.Computer(f'10.77.0.{10 + i}', CENTRE, folder / 'log') for i in range(HOSTS)]
        self.links = [namespaces.Link(i, self.centre, host) for i, host in enumerate(self.hosts)]
        self.core = None
        self.start_core()
        self.log = open(folder / 'centre.txt', 'wb')
        names = '[' + ', '.join(CAMERAS) + ']'
        self.centre.start('roslaunch', '--wait', 'markerless_mocap', 'mocap.launch', f'cameras:={names}',
                          'masks:=true', 'mask_transport:=compressed', 'privacy:=true', 'nodelets:=true',
                          output=self.log)
        self.lock = threading.Lock()
        self.poses, self.status, self.hull_reasons, self.diagnostics = [], None, {}, ''

    def start_core(self):
        self.core = self.centre.start('roscore')
        while self.centre.run('rosparam', 'list', check=False, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL).returncode != 0:
            time.sleep(0.2)
        self.centre.run('rosparam', 'set', '/pose_fitting/measure', 'false')

    def start_host(self, number, ahead=0.0):
        host, cameras = self.hosts[number], cameras_of(number)
        host.env['AHEAD'] = str(ahead)
        self.centre.run('rosparam', 'set', f'/silhouette_{number}/cameras', '[' + ', '.join(cameras) + ']')
        host.start(sys.executable, HERE / 'cameras.py', self.bag, EMPTY, RATE, *cameras)
        host.start(PROGRAMS / 'silhouette', f'__name:=silhouette_{number}', '--retry',
                   '_image_transport:=compressed',
                   f'_background_frames:={EMPTY - 6}', f'_background_folder:={self.folder}',
                   '_keep_background:=true', output=self.log)

    def listen(self):
        """Moves this process to the centre."""
        self.centre.enter()
        import rospy
        from diagnostic_msgs.msg import DiagnosticArray
        from markerless_mocap.msg import BodyPose, HullCameras, MocapStatus
        self.rospy, self.lost = rospy, BodyPose.LOST
        rospy.init_node('network_test', disable_signals=True)
        rospy.Subscriber('/pose', BodyPose, self.keep_pose, queue_size=100)
        rospy.Subscriber('/pose/status', MocapStatus, lambda m: setattr(self, 'status', m))
        rospy.Subscriber('/hull/cameras_used', HullCameras, self.keep_cameras)
        rospy.Subscriber('/diagnostics', DiagnosticArray, self.keep_diagnostics)

    def keep_pose(self, pose):
        with self.lock:
            self.poses.append((time.time(), pose))

    def keep_cameras(self, message):
        self.hull_reasons = dict(zip(message.cameras, message.reasons))

    def keep_diagnostics(self, message):
        for status in message.status:
            if status.name.endswith('visual hull') or 'visual_hull' in status.name:
                self.diagnostics = status.message

    def tracked_since(self, start):
        with self.lock:
            return [(at, p) for at, p in self.poses if p.header.stamp.to_sec() > start and p.status != self.lost]

    def used(self):
        status = self.status
        return {c for c, used in zip(status.cameras, status.used) if used} if status else set()

    def close(self):
        for computer in [*self.hosts, self.centre]:
            computer.close()
        for link in self.links:
            link.close()
        self.log.close()


class Network(unittest.TestCase):
    """The tests share one rig and run in the order of their names."""

    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(tempfile.mkdtemp(prefix='mocap_network_'))
        cls.addClassCleanup(shutil.rmtree, cls.folder, ignore_errors=True)
        cls.rig = Rig(cls.folder)
        cls.addClassCleanup(cls.rig.close)
        for number in range(HOSTS):
            cls.rig.start_host(number)
        cls.rig.listen()
        cls.begin()

    @classmethod
    def begin(cls):
        """Lets the cameras begin when every stage listens."""
        import rosgraph
        master = rosgraph.Master('/network_test')
        wanted = {f'/{camera}/{topic}' for camera in CAMERAS
                  for topic in ('image_raw/compressed', 'silhouette/compressed')}
        end = time.time() + 40
        while time.time() < end and not wanted <= {topic for topic, _ in master.getSystemState()[1]}:
            time.sleep(0.2)
        time.sleep(1.0)
        cls.rig.rospy.set_param('/start', time.time() + 0.5)

    def wait(self, condition, seconds, what):
        end = time.time() + seconds
        while time.time() < end:
            if condition():
                return
            time.sleep(0.1)
        with self.rig.lock:
            reasons = {p.reason for _, p in self.rig.poses[-20:]}
        log = (self.folder / 'centre.txt').read_text(errors='replace')[-1500:]
        self.fail(f'{what}: used {sorted(self.rig.used())}, poses {reasons}, hull {self.rig.hull_reasons}, '
                  f'status {self.rig.status and self.rig.status.message}\n{log}')

    def wait_for_poses(self, count=5, seconds=20, what='no poses'):
        start = time.time()
        self.wait(lambda: len(self.rig.tracked_since(start)) >= count, seconds, what)
        return self.rig.tracked_since(start)

    def wait_for_cameras(self, cameras, seconds=20):
        self.wait(lambda: self.rig.used() == set(cameras), seconds, f'not the cameras {sorted(cameras)}')

    def check_never_stale(self, poses):
        stamps = [p.header.stamp.to_sec() for _, p in poses]
        self.assertEqual(sorted(stamps), stamps)
        self.assertEqual(len(set(stamps)), len(stamps))
        self.assertLess(max(at - p.header.stamp.to_sec() for at, p in poses), LONGEST_AGE)

    def test_1_poses_come_from_all_cameras(self):
        self.wait_for_poses(seconds=40)
        self.wait_for_cameras(CAMERAS)
        self.check_never_stale(self.wait_for_poses())

    def test_2_no_image_crosses_a_link_until_somebody_asks_for_it(self):
        from sensor_msgs.msg import CompressedImage
        before = [link.set() for link in self.rig.links]
        self.assertEqual([0] * HOSTS, [counts['jpegs'] for counts in before])
        time.sleep(3.0)
        after = [link.set() for link in self.rig.links]
        rates = [(b['b_to_a'] - a['b_to_a']) / 3.0 for a, b in zip(before, after)]
        # Two readers of two masks of at most 1.5 kB, camera_info, headers, diagnostics.
        self.assertLess(max(rates), 2 * 2 * RATE * 1500 + 20000, rates)
        self.assertEqual([0] * HOSTS, [counts['jpegs'] for counts in after])
        subscriber = self.rig.rospy.Subscriber('/cam0/image_raw/compressed', CompressedImage, lambda image: None)
        self.wait(lambda: self.rig.links[0].set()['jpegs'] > 3, 10, 'an image that is asked for is not seen')
        subscriber.unregister()
        self.assertEqual([0] * (HOSTS - 1), [link.set()['jpegs'] for link in self.rig.links[1:]])

    def test_3_a_computer_dies_and_comes_back(self):
        self.rig.hosts[3].die()
        self.wait_for_cameras(CAMERAS[:6])
        self.check_never_stale(self.wait_for_poses(what='no poses from six cameras'))
        self.wait(lambda: 'cam6' in self.rig.status.message and 'cam7' in self.rig.status.message, 10,
                  'nobody tells of the cameras')
        self.rig.start_host(3)
        self.wait_for_cameras(CAMERAS, 30)

    def test_4_a_link_drops_out_for_two_seconds(self):
        self.rig.links[1].set(drop=True)
        start = time.time()
        self.wait(lambda: self.rig.used() == set(CAMERAS) - set(cameras_of(1)) or time.time() > start + 2, 4, '')
        time.sleep(max(0.0, start + 2 - time.time()))
        poses = self.rig.tracked_since(start)
        self.rig.links[1].set(drop=False)
        self.assertGreaterEqual(len(poses), 3)
        self.check_never_stale(poses)
        self.wait_for_cameras(CAMERAS)

    def test_5_a_link_delays_and_reorders(self):
        self.rig.links[2].set(delay=0.06, jitter=0.04)
        time.sleep(2.0)
        poses = self.wait_for_poses(10)
        self.check_never_stale(poses)
        ages = [at - p.header.stamp.to_sec() for at, p in poses]
        self.assertGreater(statistics.median(ages), 0.06, ages)  # the frame sets wait for these cameras
        self.wait_for_cameras(CAMERAS)
        self.rig.links[2].set(delay=0.0, jitter=0.0)

    def test_6_a_clock_that_differs_is_told_and_its_cameras_are_left_out(self):
        self.rig.hosts[3].die()
        self.wait_for_cameras(CAMERAS[:6])
        self.rig.start_host(3, ahead=0.04)
        for told in (lambda: ' '.join(self.rig.hull_reasons.values()), lambda: self.rig.diagnostics):
            self.wait(lambda: all(abs(milliseconds_ahead(camera, told()) - 40) < 15 for camera in cameras_of(3)), 30,
                      'nobody tells how much the clock is ahead')
        self.check_never_stale(self.wait_for_poses())
        self.assertEqual(set(CAMERAS[:6]), self.rig.used())
        self.rig.hosts[3].die()
        self.rig.start_host(3)
        self.wait_for_cameras(CAMERAS, 30)

    def test_7_roscore_ends_and_is_started_again(self):
        namespaces.end(self.rig.core)
        self.check_never_stale(self.wait_for_poses(what='no poses without roscore'))
        self.rig.start_core()
        self.check_never_stale(self.wait_for_poses(what='no poses after roscore has come back'))
        self.wait(lambda: self.rig.centre.run('timeout', '8', 'rostopic', 'echo', '-n', '1', '/pose/status',
                                              check=False, stdout=subprocess.DEVNULL,
                                              stderr=subprocess.DEVNULL).returncode == 0, 20,
                  'new subscribers find nothing')


def main():
    global PROGRAMS
    namespaces.ensure_allowed()
    PROGRAMS = pathlib.Path(sys.argv.pop(1)).resolve()
    result = unittest.main(exit=False, verbosity=2, warnings='ignore').result
    sys.stdout.flush()
    os._exit(0 if result.wasSuccessful() else 1)  # rospy's threads do not end without a roscore


if __name__ == '__main__':
    main()

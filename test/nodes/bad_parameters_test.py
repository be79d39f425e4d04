#!/usr/bin/python3
"""Each bad parameter gets its sentence, and the node ends with exit code 1, or waits with --retry.
A node that waits, and one whose roscore was started again, need nobody to go on."""
import os
import socket
import subprocess
import tempfile
import time
import unittest
import xmlrpc.client

import rospy
import rostest
from diagnostic_msgs.msg import DiagnosticArray


def refusal(node, *arguments):
    """Exit code and output of a node that must end by itself."""
    done = subprocess.run(['rosrun', 'markerless_mocap', node, '__name:=' + node, *arguments],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=30)
    return done.returncode, done.stdout


def rig_text(names):
    """A rig file of such cameras."""
    camera = ('- {name: %s, size: [64, 48], fx: 50, fy: 50, cx: 32, cy: 24, distortion: [],\n'
              '   position: [%g, -3, 1], orientation: [-0.70711, 0, 0, 0.70711]}\n')
    return 'cameras:\n' + ''.join(camera % (name, 0.5 * i) for i, name in enumerate(names))


class Refusals(unittest.TestCase):
    def test_limits_of_the_process(self):
        for limits, sentence in (('-n 32', 'may open 32 files and connections, allowed are 64 and more'),
                                 ('-v 600000', 'may use 585 MB of addresses, allowed are 1000 MB')):
            done = subprocess.run(
                ['bash', '-c', 'ulimit %s; exec "$(catkin_find --first-only --libexec '
                 'markerless_mocap pose_tree)"' % limits],
                stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=30)
            self.assertEqual(1, done.returncode, done.stdout)
            self.assertIn(sentence, done.stdout)

    def expect(self, sentence, node, *arguments, **parameters):
        for key, value in parameters.items():
            rospy.set_param('/%s/%s' % (node, key), value)
        code, output = refusal(node, *arguments)
        if rospy.has_param('/' + node):
            rospy.delete_param('/' + node)
        self.assertEqual(1, code, output)
        self.assertIn(sentence, output)

    def test_no_cameras(self):
        self.expect('visual_hull/cameras lists 0 cameras, allowed is 2 to 32', 'visual_hull')
        self.expect('silhouette/cameras lists 0 cameras, allowed is 1 to 32', 'silhouette')

    def test_typo(self):
        self.expect('/visual_hull/pich is not an option (value 0.02), did you mean pitch?',
                    'visual_hull', cameras=['a', 'b'], pich=0.02)

    def test_value_out_of_range(self):
        self.expect('/body_segmentation/max_cost is 100, allowed is', 'body_segmentation',
                    max_cost=100.0)

    def test_pose_tree_out_of_range(self):
        self.expect('/pose_tree/prune_ratio is 0.9, allowed is', 'pose_tree', prune_ratio=0.9)

    def test_trust_in_a_camera_that_is_none(self):
        for entry in ('c=0.5', 'a=x', 'a'):
            self.expect("visual_hull/camera_trust has '%s', allowed is <camera of the rig>=<0 to 1>"
                        % entry, 'visual_hull', cameras=['a', 'b'], camera_trust=[entry])

    def test_wrong_type(self):
        self.expect('/silhouette/background_frames is many, allowed is a whole number',
                    'silhouette', cameras=['a'], background_frames='many')

    def test_camera_twice(self):
        self.expect('visual_hull/cameras holds "a"', 'visual_hull', cameras=['a', 'a'])

    def test_silhouettes_without_cameras(self):
        self.expect('pose_fitting/cameras lists 0 cameras, allowed is 2 to 32', 'pose_fitting')

    def test_rig_file_that_is_none(self):
        for node in ('visual_hull', 'pose_fitting'):
            self.expect('cannot read the rig /no/such/file', node, cameras=['a', 'b'],
                        rig_file='/no/such/file')
            self.expect_of_file("key 'camera' is unknown, allowed are cameras", 'rig_file',
                                'camera: 3', node)

    def test_cameras_that_the_rig_file_lacks(self):
        for node in ('visual_hull', 'pose_fitting'):
            self.expect_of_file('the rig lacks b, its cameras are a, c', 'rig_file',
                                rig_text('ac'), node)

    def test_unknown_method(self):
        self.expect('/pose_fitting/method is "magic", allowed is one of contour, hsiao',
                    'pose_fitting', cameras=['a', 'b'], method='magic')

    def test_value_of_a_nested_section(self):
        self.expect('/pose_fitting/contour/rays is 5, allowed is 100 to 20000', 'pose_fitting',
                    cameras=['a', 'b'], contour={'rays': 5})

    def test_key_of_an_earlier_release(self):
        self.expect('/pose_fitting/contour_rays is now /pose_fitting/contour/rays', 'pose_fitting',
                    cameras=['a', 'b'], contour_rays=900)
        self.expect('/pose_fitting/filter is now /pose_fitting/filter/enabled', 'pose_fitting',
                    cameras=['a', 'b'], filter=False)
        self.expect('/pose_fitting/method is "sppso", which is now "fleischmann"', 'pose_fitting',
                    cameras=['a', 'b'], method='sppso')

    def test_unreadable_urdf_template(self):
        self.expect('cannot read /no/such/file', 'pose_fitting', cameras=['a', 'b'],
                    urdf_template='/no/such/file')

    def expect_of_file(self, sentence, option, text, node='pose_fitting'):
        with tempfile.NamedTemporaryFile('w') as file:
            file.write(text)
            file.flush()
            self.expect(sentence, node, cameras=['a', 'b'], **{option: file.name})

    def test_urdf_that_is_none(self):
        self.expect_of_file('URDF', 'urdf_template', 'no xml')

    def test_urdf_without_the_links(self):
        self.expect_of_file('URDF', 'urdf_template', '<robot name="r"><link name="base"/></robot>')

    def test_body_file_that_is_none(self):
        self.expect_of_file('lacks the shape parameter torso', 'body_file', 'height: 1.8')


def node(name, uri=None, **options):
    environment = dict(os.environ, ROS_MASTER_URI=uri) if uri else None
    return subprocess.Popen(['rosrun', 'markerless_mocap', name, '--retry', '__name:=' + name],
                            env=environment, **options)


def wait_for(condition, seconds=60):
    end = time.time() + seconds
    while time.time() < end and not condition():
        time.sleep(0.1)
    return condition()


def answer_of(call, *arguments):
    """The master's answer; None if it refuses or is not there."""
    try:
        code, _, answer = call('/bad_parameters_test', *arguments)
    except OSError:
        return None
    return answer if code == 1 else None


class Waiting(unittest.TestCase):
    def test_a_node_tells_once_and_starts_when_its_parameters_are_good(self):
        rospy.set_param('/visual_hull/cameras', ['a'])
        told = []
        rospy.Subscriber('/diagnostics', DiagnosticArray, lambda array: told.extend(
            s.message for s in array.status if s.name == 'visual_hull: start'))
        with tempfile.TemporaryFile('w+') as log:
            process = node('visual_hull', stdout=log, stderr=subprocess.STDOUT)
            try:
                self.assertTrue(wait_for(lambda: len(told) > 7), told)  # it has tried again
                self.assertIsNone(process.poll())
                rospy.set_param('/visual_hull/cameras', ['a', 'b'])
                self.assertTrue(wait_for(lambda: '/hull/points' in dict(
                    rospy.get_published_topics())))
            finally:
                process.terminate()
                process.wait()
                rospy.delete_param('/visual_hull')
            log.seek(0)
            self.assertEqual(1, log.read().count('lists 1 cameras, allowed is 2 to 32'))
        self.assertIn('lists 1 cameras, allowed is 2 to 32', told[0])


class DamagedBackground(unittest.TestCase):
    def test_it_is_told_and_learned_anew(self):
        told = []
        rospy.Subscriber('/diagnostics', DiagnosticArray, lambda array: told.extend(
            s.message for s in array.status if s.name.endswith('silhouette of a')))
        with tempfile.TemporaryDirectory() as folder:
            file = os.path.join(folder, 'a.background')
            with open(file, 'w') as damaged:
                damaged.write('cut off')
            rospy.set_param('/silhouette', {'cameras': ['a'], 'background_folder': folder})
            process = node('silhouette')
            try:
                sentence = 'the file %s holds no background of a silhouette; it is learned' % file
                self.assertTrue(wait_for(lambda: any(sentence in t for t in told), 20), told)
                self.assertIn('/a/silhouette', dict(rospy.get_published_topics()))
            finally:
                process.terminate()
                process.wait()
                rospy.delete_param('/silhouette')


class RoscoreStartsAgain(unittest.TestCase):
    def start_master(self):
        return subprocess.Popen(['rosmaster', '--core', '-p', str(self.port)],
                                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

    def publishers(self, topic):
        published = (answer_of(self.master.getSystemState) or [[]])[0]
        return [nodes for name, nodes in published if name == topic]

    def subscribers(self, topic):
        subscribed = (answer_of(self.master.getSystemState) or [[], []])[1]
        return [nodes for name, nodes in subscribed if name == topic]

    def hear_diagnostics(self, uri):
        """Messages to a file; the connection outlives roscore."""
        heard = tempfile.NamedTemporaryFile('w+')
        listener = subprocess.Popen(['rostopic', 'echo', '/diagnostics/status'], stdout=heard.fileno(),
                                    env=dict(os.environ, ROS_MASTER_URI=uri, PYTHONUNBUFFERED='1'))
        self.addCleanup(heard.close)
        self.addCleanup(listener.wait)
        self.addCleanup(listener.terminate)
        return lambda text: open(heard.name).read().count(text)

    def test_a_node_registers_again(self):
        with socket.socket() as free:
            free.bind(('localhost', 0))
            self.port = free.getsockname()[1]
        uri = 'http://localhost:%d' % self.port
        self.master = xmlrpc.client.ServerProxy(uri)
        first = self.start_master()
        self.assertTrue(wait_for(lambda: answer_of(self.master.getPid)))
        self.master.setParam('/test', '/visual_hull', {'cameras': ['a', 'b']})
        # Of a stage that is not there while roscore starts again.
        self.master.setParam('/test', '/silhouette', {'cameras': ['a']})
        process = node('visual_hull', uri)
        try:
            self.assertTrue(wait_for(lambda: self.publishers('/hull/points')))
            said = self.hear_diagnostics(uri)
            heard = lambda: said('name: "visual_hull: visual hull"')
            self.assertTrue(wait_for(heard))
            node_address = answer_of(self.master.lookupNode, '/visual_hull')
            service = '/visual_hull/set_running'
            address = answer_of(self.master.lookupService, service)
            self.assertTrue(address)
            # As a setting that is changed while the stage runs. It asks once a second.
            self.master.setParam('/test', '/visual_hull/pitch', 0.04)
            rospy.rostime.wallsleep(4)
            first.terminate()
            first.wait()
            self.assertTrue(wait_for(lambda: said('roscore cannot be reached')))
            # It works on, although it looks for its silent topics every five seconds.
            for _ in range(4):
                before = heard()
                self.assertTrue(wait_for(lambda: heard() > before + 2, 10))
            second = self.start_master()
            try:
                # As when the node looks for a silent topic before it misses its own.
                self.assertTrue(wait_for(lambda: answer_of(self.master.getPid)))
                self.master.registerSubscriber('/visual_hull', '/any', 'std_msgs/String',
                                               node_address)
                for topic in ('/hull/points', '/hull/cameras_used'):
                    self.assertTrue(wait_for(lambda: self.publishers(topic)), topic)
                self.assertTrue(wait_for(lambda: self.subscribers('/a/silhouette')))
                self.assertEqual(address, answer_of(self.master.lookupService, service))
                self.assertTrue(wait_for(lambda: said('roscore was started again')))
                self.assertEqual(['a', 'b'], answer_of(self.master.getParam,
                                                       '/visual_hull/cameras'))
                self.assertEqual(0.04, answer_of(self.master.getParam, '/visual_hull/pitch'))
                self.assertEqual(['a'], answer_of(self.master.getParam, '/silhouette/cameras'))
            finally:
                second.terminate()
                second.wait()
        finally:
            process.terminate()
            process.wait()


if __name__ == '__main__':
    rospy.init_node('bad_parameters_test')
    rostest.rosrun('markerless_mocap', 'bad_parameters', 'bad_parameters_test')

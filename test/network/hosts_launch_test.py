#!/usr/bin/python3
"""hosts_launch: what roslaunch makes of its files, that they start, and what is refused."""
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

import roslaunch.config
import yaml

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROGRAM = ROOT / 'scripts/hosts_launch'
EXAMPLE = ROOT / 'config/hosts.yaml'


def example():
    return yaml.safe_load(EXAMPLE.read_text())


class HostsLaunch(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.launch = pathlib.Path(self.folder.name, 'rig.launch')

    def run_with(self, content, *options):
        hosts = pathlib.Path(self.folder.name, 'hosts.yaml')
        hosts.write_text(content if isinstance(content, str) else yaml.safe_dump(content))
        return subprocess.run([sys.executable, str(PROGRAM), str(hosts), str(self.launch), *map(str, options)],
                              capture_output=True, text=True, check=False)

    def config_of(self, content, *options):
        made = self.run_with(content, *options)
        self.assertEqual(0, made.returncode, made.stderr)
        return roslaunch.config.load_config_default([str(self.launch)], 11311, verbose=False)

    def refusal(self, change):
        rig = example()
        change(rig)
        made = self.run_with(rig)
        self.assertEqual(1, made.returncode)
        self.assertEqual(1, made.stderr.count('\n'), made.stderr)
        self.assertFalse(self.launch.exists())
        return made.stderr

    def test_each_camera_s_silhouettes_are_made_on_its_host(self):
        config = self.config_of(example())
        machines = {node.name: node.machine_name for node in config.nodes}
        self.assertEqual('front', machines.pop('silhouette_front'))
        self.assertEqual('front', machines.pop('usb_cameras_front'))
        self.assertEqual('back', machines.pop('silhouette_back'))
        self.assertEqual('back', machines.pop('usb_cameras_back'))
        self.assertEqual({'mocap'}, set(machines))  # one process: each mask comes once
        values = {name: parameter.value for name, parameter in config.params.items()}
        self.assertEqual(['cam0', 'cam1'], values['/silhouette_front/cameras'])
        self.assertEqual(['cam2', 'cam3'], values['/silhouette_back/cameras'])
        self.assertEqual(['/dev/video0', '/dev/video2'], values['/usb_cameras_back/sources'])
        for stage in ('visual_hull', 'pose_fitting'):
            self.assertEqual(['cam0', 'cam1', 'cam2', 'cam3'], values[f'/{stage}/cameras'])
            self.assertEqual('compressed', values[f'/{stage}/mask_transport'])
            self.assertIs(True, values[f'/{stage}/privacy'])

    def test_machines_are_those_of_the_file(self):
        machines = self.config_of(example()).machines
        self.assertEqual('10.0.0.2', machines['front'].address)
        self.assertEqual('mocap', machines['front'].user)
        self.assertEqual('/home/mocap/env.sh', machines['front'].env_loader)
        self.assertEqual('10.0.0.1', machines['central'].address)

    def test_settings_of_the_configuration_reach_the_hosts(self):
        config = pathlib.Path(self.folder.name, 'config.yaml')
        config.write_text('silhouette: {model: mog2, background_frames: 17}\n')
        values = self.config_of(example(), '--config', config).params
        for host in ('front', 'back'):
            self.assertEqual('mog2', values[f'/silhouette_{host}/model'].value)
            self.assertEqual(17, values[f'/silhouette_{host}/background_frames'].value)

    def test_drivers_are_left_out_where_no_usb_devices_are_named(self):
        rig = example()
        del rig['hosts'][0]['usb']
        nodes = {node.name for node in self.config_of(rig).nodes}
        self.assertNotIn('usb_cameras_front', nodes)
        self.assertIn('machine="front"', self.launch.read_text())

    def test_what_is_wrong_is_told_in_one_sentence(self):
        def hosts(**changes):
            return lambda rig: rig['hosts'][1].update(changes)
        self.assertIn('camera cam0 is on host front and on host back',
                      self.refusal(hosts(cameras=['cam0', 'cam3'])))
        self.assertIn('host front comes twice', self.refusal(hosts(name='front')))
        self.assertIn('host 2 has the key "port"', self.refusal(hosts(port=22)))
        self.assertIn('host back/address is "10.0.0.300"', self.refusal(hosts(address='10.0.0.300')))
        self.assertIn('host back/usb is', self.refusal(hosts(usb=['/dev/video0'])))
        self.assertIn('host 2/user is', self.refusal(hosts(user='$(env HOME)')))
        self.assertIn('host back/cameras holds', self.refusal(hosts(cameras=['cam 2', 'cam3'])))
        self.assertIn('lacks the key "central"', self.refusal(lambda rig: rig.pop('central')))
        self.assertIn('privacy is \'maybe\'', self.refusal(lambda rig: rig.update(privacy='maybe')))
        self.assertIn('hosts is no list', self.refusal(lambda rig: rig.update(hosts={})))
        for text, sentence in (('central: {address: a}\ncentral: {address: b}\n', 'comes twice'),
                               ('[1, 2]', 'has no keys'), ('hosts: [', 'is no YAML')):
            made = self.run_with(text)
            self.assertEqual(1, made.returncode)
            self.assertIn(sentence, made.stderr)

    def test_what_is_no_file_is_told_and_does_not_block(self):
        folder = self.folder.name
        pipe = os.path.join(folder, 'pipe')
        os.mkfifo(pipe)
        no_file = 'it is a folder, pipe or device, allowed are files'
        for hosts, launch, sentence in (
                (pipe, self.launch, f'cannot read {pipe}: {no_file}'),
                ('/dev/zero', self.launch, f'cannot read /dev/zero: {no_file}'),
                ('', self.launch, 'cannot read a file: its name is empty'),
                (sys.executable, self.launch, f'{sys.executable} is no text'),
                (EXAMPLE, pipe, f'cannot write {pipe}: {no_file}'),
                (EXAMPLE, folder + '/none/a', f'cannot write {folder}/none/a: No such file')):
            made = subprocess.run([sys.executable, str(PROGRAM), str(hosts), str(launch)], check=False,
                                  capture_output=True, text=True, timeout=60)
            self.assertEqual(1, made.returncode)
            self.assertIn('hosts_launch: ' + sentence, made.stderr)
            self.assertEqual(1, made.stderr.count('\n'), made.stderr)
        self.assertEqual(['pipe'], os.listdir(folder))

    def test_a_camera_that_the_rig_does_not_have_is_refused(self):
        rig = pathlib.Path(self.folder.name, 'rig.yaml')
        rig.write_text('cameras:\n- {name: cam0}\n- {name: cam1}\n- {name: cam2}\n')
        made = self.run_with(example(), '--rig', rig)
        self.assertEqual(1, made.returncode)
        self.assertIn('camera cam3 is not in', made.stderr)

    def test_it_starts_where_all_machines_are_this_one(self):
        rig = example()
        rig['central'] = {'address': '127.0.0.1'}
        for host in rig['hosts']:
            host.update(address='127.0.0.1')
            for key in ('user', 'env_loader', 'usb'):
                del host[key]
        self.assertEqual(0, self.run_with(rig).returncode)
        port = 20000 + os.getpid() % 10000
        env = dict(os.environ, ROS_MASTER_URI=f'http://127.0.0.1:{port}', ROS_IP='127.0.0.1',
                   ROS_LOG_DIR=self.folder.name)
        with subprocess.Popen(['roslaunch', '-p', str(port), str(self.launch)], env=env,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) as graph:
            try:
                wanted = {'/silhouette_front', '/silhouette_back', '/mocap'}
                listeners, end = set(), time.monotonic() + 60
                while time.monotonic() < end and not wanted <= listeners:
                    time.sleep(0.5)
                    shown = subprocess.run(['rosnode', 'list'], env=env, capture_output=True, text=True,
                                           check=False)
                    listeners = set(shown.stdout.split())
                self.assertLessEqual(wanted, listeners)
                info = subprocess.run(['rosnode', 'info', '/silhouette_back'], env=env, capture_output=True,
                                      text=True, check=True).stdout
                self.assertIn('/cam3/silhouette/compressed', info)
                self.assertNotIn('/cam1/silhouette', info)
            finally:
                graph.terminate()


if __name__ == '__main__':
    unittest.main()

#!/usr/bin/python3
"""Which ports of a computer another one reaches: docs/deployment.md, "Binding to one machine".

    binding_test.py FOLDER_OF_PROGRAMS"""
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import namespaces  # noqa: E402

INSIDE, OUTSIDE = '10.78.0.1', '10.78.0.2'
DOCUMENT = pathlib.Path(__file__).resolve().parent.parent.parent / 'docs' / 'deployment.md'
LEAST_PORTS = 5  # of the master, and two each of rosout and a stage
PROGRAMS = pathlib.Path()
NODES = """import rosgraph, sys
master = rosgraph.Master('/binding_test')
for node in {node for kind in master.getSystemState() for _, nodes in kind for node in nodes}:
    print(master.lookupNode(node))"""
CONNECT = 'import socket, sys; socket.create_connection((sys.argv[1], int(sys.argv[2])), 1).close()'


class Binding(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.inside, self.outside = (namespaces.Computer(address, INSIDE, self.folder.name)
                                     for address in (INSIDE, OUTSIDE))
        self.addCleanup(self.inside.close)
        self.addCleanup(self.outside.close)
        self.addCleanup(namespaces.Link(0, self.inside, self.outside).close)

    def ports(self):
        listening = self.inside.run('ss', '-tlnH', stdout=subprocess.PIPE, text=True).stdout
        return [int(line.split()[3].rsplit(':', 1)[1]) for line in listening.splitlines()]

    def graph_with(self, address):
        """Starts a master and a stage. Returns their ports."""
        self.inside.env.update(ROS_IP=address, ROS_MASTER_URI=f'http://{address}:11311')
        self.inside.start('roscore')
        self.inside.start(PROGRAMS / 'pose_tree', '--retry')
        end = time.time() + 60
        while len(self.ports()) < LEAST_PORTS and time.time() < end:
            time.sleep(0.2)
        self.assertGreaterEqual(len(self.ports()), LEAST_PORTS)
        self.inside.run('rosparam', 'list', stdout=subprocess.DEVNULL)
        return self.ports()

    def control_ports(self):
        """Of the nodes: those of their XML-RPC servers."""
        uris = self.inside.run(sys.executable, '-c', NODES, stdout=subprocess.PIPE, text=True).stdout
        return {int(uri.rstrip('/').rsplit(':', 1)[1]) for uri in uris.split()}

    def reached(self, ports):
        return [port for port in ports
                if self.outside.run(sys.executable, '-c', CONNECT, INSIDE, port, check=False,
                                    stderr=subprocess.DEVNULL).returncode == 0]

    def test_with_an_address_of_the_loopback_only_control_ports_of_nodes_are_reached(self):
        ports = self.graph_with('127.0.0.1')
        control = self.control_ports()
        self.assertEqual(2, len(control))
        self.assertEqual(control, set(self.reached(ports)))
        self.assertIn(11311, ports)

    def test_behind_the_documented_firewall_no_port_is_reached(self):
        ports = self.graph_with(INSIDE)
        lines = re.findall(r'^    (nft .*)$', DOCUMENT.read_text(), re.M)
        self.assertEqual(3, len(lines))
        for line in lines:
            self.inside.run(*shlex.split(line))
        self.assertEqual([], self.reached(ports))
        self.inside.run('rosparam', 'list', stdout=subprocess.DEVNULL)

    def test_with_its_own_address_all_ports_are_reached(self):
        ports = self.graph_with(INSIDE)
        self.assertEqual(ports, self.reached(ports))


if __name__ == '__main__':
    namespaces.ensure_allowed()
    PROGRAMS = pathlib.Path(sys.argv.pop(1)).resolve()
    unittest.main(verbosity=2, warnings='ignore')

"""Computers in network namespaces of this one, and links between them."""
import contextlib
import ctypes
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

SKIPPED = 77  # exit code by which ctest knows it
HERE = pathlib.Path(__file__).resolve().parent


def ensure_allowed():
    """Becomes root of a user namespace where needed. Ends the process where namespaces are not allowed."""
    if os.geteuid() != 0 and 'MOCAP_UNSHARED' not in os.environ:
        if subprocess.run(['unshare', '-rn', 'true'], stderr=subprocess.DEVNULL, check=False).returncode == 0:
            os.environ['MOCAP_UNSHARED'] = '1'
            os.execvp('unshare', ['unshare', '-rn', sys.executable, *sys.argv])
    try:
        possible = subprocess.run(['unshare', '-n', 'true'], stderr=subprocess.DEVNULL,
                                  check=False).returncode == 0
        os.close(os.open('/dev/net/tun', os.O_RDWR))
        possible = possible and shutil.which('ip') is not None
    except OSError:
        possible = False
    if not possible:
        print('skipped: network namespaces and /dev/net/tun are not allowed here, or iproute2 is missing')
        sys.exit(SKIPPED)


class Computer:
    """A network namespace with an address, and the processes that are started in it."""

    def __init__(self, address, master, log_folder):
        self.address, self.processes = address, []
        self.holder = subprocess.Popen(['unshare', '-n', 'sleep', 'infinity'])
        own = os.readlink('/proc/self/ns/net')
        while os.readlink(f'/proc/{self.holder.pid}/ns/net') == own:
            time.sleep(0.01)
        self.env = dict(os.environ, ROS_IP=address, ROS_MASTER_URI=f'http://{master}:11311',
                        ROS_LOG_DIR=str(log_folder))
        self.env.pop('ROS_HOSTNAME', None)
        self.run('ip', 'link', 'set', 'lo', 'up')

    def command(self, *arguments):
        return ['nsenter', '-t', str(self.holder.pid), '-n', '--', *map(str, arguments)]

    def run(self, *arguments, **options):
        return subprocess.run(self.command(*arguments), env=self.env, check=options.pop('check', True),
                              **options)

    def start(self, *arguments, output=subprocess.DEVNULL):
        process = subprocess.Popen(self.command(*arguments), env=self.env, stdin=subprocess.DEVNULL,
                                   stdout=output, stderr=subprocess.STDOUT, start_new_session=True)
        self.processes.append(process)
        return process

    def enter(self):
        """Moves the calling process, which has one thread, to this computer."""
        with open(f'/proc/{self.holder.pid}/ns/net') as space:
            if ctypes.CDLL(None, use_errno=True).setns(space.fileno(), 0x40000000) != 0:
                raise OSError(ctypes.get_errno(), 'setns')
        os.environ.update(self.env)
        os.environ.pop('ROS_HOSTNAME', None)

    def die(self):
        """All its processes end at once, without a word to anybody."""
        for process in self.processes:
            end(process)
        self.processes = []

    def close(self):
        self.die()
        for pid in self.pids():  # roslaunch's nodes are no children of ours
            if pid != os.getpid():
                with contextlib.suppress(ProcessLookupError):
                    os.kill(pid, signal.SIGKILL)
        self.holder.wait()

    def pids(self):
        """Of all processes in the namespace."""
        space, found = os.readlink(f'/proc/{self.holder.pid}/ns/net'), []
        for folder in pathlib.Path('/proc').glob('[0-9]*'):
            try:
                if os.readlink(folder / 'ns/net') == space:
                    found.append(int(folder.name))
            except OSError:  # it has ended, or belongs to somebody else
                pass
        return found


class Link:
    """A wire between two computers; see link.py."""

    def __init__(self, number, a, b):
        self.process = subprocess.Popen(
            [sys.executable, str(HERE / 'link.py'), str(number), str(a.holder.pid), a.address,
             str(b.holder.pid), b.address], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        if self.process.stdout.readline() != 'ready\n':
            raise RuntimeError('a link does not start')

    def set(self, **settings):
        """Returns what has passed so far."""
        self.process.stdin.write(json.dumps(settings) + '\n')
        self.process.stdin.flush()
        return json.loads(self.process.stdout.readline())

    def close(self):
        self.process.stdin.close()
        self.process.wait()


def end(process):
    """Kills a process and those that it has started."""
    try:
        os.killpg(process.pid, signal.SIGKILL)
    except ProcessLookupError:
        pass
    process.wait()

#!/usr/bin/python3
"""A network link between two namespaces that delays, reorders and drops packets, as a process.

    link.py NUMBER PID_A ADDRESS_A PID_B ADDRESS_B

Packets go through two TUN devices. Commands come as JSON lines on stdin: {"delay": s, "jitter": s,
"drop": true} sets what is done to them, {} changes nothing. Each is answered by what has passed so far:
bytes from B to A and back, and how many packets from B to A held the start of a JPEG."""
import ctypes
import fcntl
import heapq
import json
import os
import random
import selectors
import struct
import subprocess
import sys
import time

TUNSETIFF, IFF_TUN, IFF_NO_PI, CLONE_NEWNET = 0x400454ca, 0x0001, 0x1000, 0x40000000
MTU = 1400
JPEG_START = b'\xff\xd8\xff\xe0\x00\x10JFIF'


def enter(pid):
    """Moves this process to the network namespace of another."""
    with open(f'/proc/{pid}/ns/net') as space:
        if ctypes.CDLL(None, use_errno=True).setns(space.fileno(), CLONE_NEWNET) != 0:
            raise OSError(ctypes.get_errno(), 'setns')


def open_end(name, pid, address, peer):
    enter(pid)
    tun = os.open('/dev/net/tun', os.O_RDWR | os.O_NONBLOCK)
    fcntl.ioctl(tun, TUNSETIFF, struct.pack('16sH22x', name.encode(), IFF_TUN | IFF_NO_PI))
    subprocess.run(['ip', 'address', 'add', address, 'peer', peer, 'dev', name], check=True)
    subprocess.run(['ip', 'link', 'set', name, 'mtu', str(MTU), 'up'], check=True)
    return tun


class Link:
    def __init__(self, a, b):
        self.other = {a: b, b: a}
        self.from_b = b
        self.waiting, self.number = [], 0
        self.settings = {'delay': 0.0, 'jitter': 0.0, 'drop': False}
        self.passed = {a: 0, b: 0}
        self.jpegs = 0

    def receive(self, end):
        try:
            packet = os.read(end, 65536)
        except BlockingIOError:
            return
        if self.settings['drop']:
            return
        due = time.monotonic() + self.settings['delay'] + random.uniform(0, self.settings['jitter'])
        self.number += 1
        heapq.heappush(self.waiting, (due, self.number, self.other[end], packet))
        self.passed[end] += len(packet)
        self.jpegs += end == self.from_b and JPEG_START in packet

    def send_due(self):
        """Returns the time until the next packet is due, s."""
        while self.waiting and self.waiting[0][0] <= time.monotonic():
            _, _, end, packet = heapq.heappop(self.waiting)
            try:
                os.write(end, packet)
            except OSError:  # a full queue: the packet is lost, as on a wire
                pass
        return max(0.0, self.waiting[0][0] - time.monotonic()) if self.waiting else 1.0

    def answer(self, line):
        self.settings.update(json.loads(line))
        a, b = self.other[self.from_b], self.from_b
        print(json.dumps({'b_to_a': self.passed[b], 'a_to_b': self.passed[a], 'jpegs': self.jpegs}),
              flush=True)


def main():
    number, pid_a, address_a, pid_b, address_b = sys.argv[1:]
    a = open_end('mocap' + number, pid_a, address_a, address_b)
    b = open_end('mocap' + number, pid_b, address_b, address_a)
    link = Link(a, b)
    with selectors.DefaultSelector() as selector:
        for end in (a, b, sys.stdin.fileno()):
            selector.register(end, selectors.EVENT_READ)
        print('ready', flush=True)
        wait = 1.0
        while True:
            for key, _ in selector.select(wait):
                if key.fd != sys.stdin.fileno():
                    link.receive(key.fd)
                    continue
                line = sys.stdin.readline()
                if not line:
                    return
                link.answer(line)
            wait = link.send_due()


if __name__ == '__main__':
    main()

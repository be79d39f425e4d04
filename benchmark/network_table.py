#!/usr/bin/python3
"""Bytes and latency of several computers' cameras against their number, as a table.

    . devel/setup.bash
    sudo -E benchmark/network_table.py CAPTURE.bag [--cameras 4 8 16 32] [--rate 30] [--seconds 10]

CAPTURE.bag holds <camera>/silhouette (or that of the ground truth, as render_capture writes it) and
camera_info. Four network namespaces play the masks of a
quarter of the cameras each, with the stamps of now; where there are more cameras than in the bag, they
are repeated. The stages of the centre run in a fifth. What crosses the wires is counted by the kernel.

For each number of cameras: masks as PNG, raw masks, and raw colour images of the same size (played as
noise, with one reader). `sent` is the fraction of the messages that the players could send, `poses` that
of the frame sets that were answered, `tracked` that of poses that are not lost; where they are below 1,
the processors of this machine do not hold that many. Latencies are medians from the stamp of the image to
the mask at the centre, and to the tracked pose."""
import argparse
import json
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / 'test/network'))
import namespaces  # noqa: E402

HOSTS = 4
CENTRE = '10.78.0.1'
KINDS = ('png', 'masks', 'images')
WARM_UP = 8.0  # s, in which the person is found


def connect(centre, hosts):
    """A bridge at the centre, and a veth pair to each host."""
    centre.run('ip', 'link', 'add', 'bridge', 'type', 'bridge')
    centre.run('ip', 'address', 'add', CENTRE + '/24', 'dev', 'bridge')
    centre.run('ip', 'link', 'set', 'bridge', 'up')
    for number, host in enumerate(hosts):
        centre.run('ip', 'link', 'add', f'host{number}', 'type', 'veth', 'peer', 'name', 'centre', 'netns',
                   host.holder.pid)
        centre.run('ip', 'link', 'set', f'host{number}', 'master', 'bridge', 'up')
        host.run('ip', 'address', 'add', host.address + '/24', 'dev', 'centre')
        host.run('ip', 'link', 'set', 'centre', 'up')


def bytes_sent(host):
    shown = host.run('ip', '-j', '-s', 'link', 'show', 'centre', capture_output=True, text=True).stdout
    return json.loads(shown)[0]['stats64']['tx']['bytes']


def play(kind, bag, rate, start, seconds, cameras):
    """In a host: publishes what the cameras would send, and prints the fraction that was sent."""
    import numpy
    import rosbag
    import rospy
    from sensor_msgs.msg import CameraInfo, CompressedImage, Image
    topics = {topic.split('/')[-2]: topic for topic in rosbag.Bag(bag).get_type_and_topic_info()[1]
              if topic.endswith('/silhouette')}
    sources = sorted(topics)
    recorded = {}
    for camera in cameras:
        source = sources[int(camera[3:]) % len(sources)]
        masks = [m for _, m, _ in rosbag.Bag(bag).read_messages(topics=[topics[source]])]
        info = next(rosbag.Bag(bag).read_messages(topics=['/' + source + '/camera_info']))[1]
        recorded[camera] = [m for m in masks if max(m.data)], info
    rospy.init_node('player_' + cameras[0])
    names = {'png': ('/silhouette/compressed', CompressedImage), 'masks': ('/silhouette', Image),
             'images': ('/image_raw', Image)}
    topic, message_type = names[kind]
    out = {c: rospy.Publisher(c + topic, message_type, queue_size=4, tcp_nodelay=True) for c in cameras}
    infos = {c: rospy.Publisher(c + '/camera_info', CameraInfo, queue_size=4) for c in cameras}
    messages = {}
    for camera, (masks, info) in recorded.items():
        if kind == 'png':
            masks = [png_of(mask) for mask in masks]
        if kind == 'images':
            size = masks[0].width * masks[0].height * 3
            noise = numpy.random.default_rng(1).integers(0, 256, size, numpy.uint8).tobytes()
            masks = [Image(width=masks[0].width, height=masks[0].height, step=3 * masks[0].width,
                           encoding='bgr8', data=noise)]
        for mask in masks:
            mask.header.frame_id = info.header.frame_id
        messages[camera] = masks
    sent, number = 0, 0
    while number < int(seconds * rate):
        stamp = start + number / rate
        time.sleep(max(0.0, stamp - time.time()))
        for camera in cameras:
            masks, info = messages[camera], recorded[camera][1]
            place = number % (2 * len(masks) - 1)
            mask = masks[min(place, 2 * len(masks) - 1 - place) % len(masks)]
            mask.header.stamp = info.header.stamp = rospy.Time.from_sec(stamp)
            out[camera].publish(mask)
            if number % int(rate) == 0:
                infos[camera].publish(info)
        sent += 1
        number = max(number + 1, int((time.time() - start) * rate))
    print('sent', sent / int(seconds * rate), flush=True)


def png_of(mask):
    """As the silhouette stage compresses masks without unknown pixels: one bit, deflate's level 1."""
    import struct
    import zlib

    import numpy
    from sensor_msgs.msg import CompressedImage
    pixels = numpy.frombuffer(mask.data, numpy.uint8).reshape(mask.height, mask.width)
    rows = numpy.packbits(pixels > 0, axis=1)
    rows = numpy.hstack([numpy.zeros((mask.height, 1), numpy.uint8), rows]).tobytes()

    def chunk(name, data):
        return struct.pack('>I', len(data)) + name + data + struct.pack('>I', zlib.crc32(name + data))
    head = struct.pack('>IIBBBBB', mask.width, mask.height, 1, 0, 0, 0, 0)
    data = b'\x89PNG\r\n\x1a\n' + chunk(b'IHDR', head) + chunk(b'IDAT', zlib.compress(rows, 1)) + chunk(b'IEND', b'')
    return CompressedImage(header=mask.header, format='mono8; png compressed ', data=data)


def measure(kind, count, arguments, folder):
    """One row of the table."""
    centre = namespaces.Computer(CENTRE, CENTRE, folder)
    hosts = [namespaces.Computer(f'10.78.0.{10 + i}', CENTRE, folder) for i in range(HOSTS)]
    cameras = [f'cam{i}' for i in range(count)]
    try:
        connect(centre, hosts)
        centre.start('roscore')
        while centre.run('rosparam', 'list', check=False, capture_output=True).returncode != 0:
            time.sleep(0.2)
        centre.run('rosparam', 'set', '/pose_fitting/measure', 'false')
        if kind != 'images':
            centre.start('roslaunch', '--wait', 'markerless_mocap', 'mocap.launch', 'nodelets:=true',
                         'privacy:=true', 'masks:=true', 'cameras:=[' + ', '.join(cameras) + ']',
                         'mask_transport:=' + ('compressed' if kind == 'png' else 'raw'))
        start = time.time() + 12.0 + count / 2.0  # until all is loaded
        length = WARM_UP + arguments.seconds + 2.0
        players = [host.start(sys.executable, __file__, arguments.bag, '--play', kind, '--rate',
                              arguments.rate, '--start', start, '--seconds', length, '--names',
                              *cameras[i::HOSTS], output=subprocess.PIPE) for i, host in enumerate(hosts)]
        heard = listen(kind, centre, cameras, arguments, start)
        time.sleep(max(0.0, start + WARM_UP - time.time()))
        before = [bytes_sent(host) for host in hosts]
        began = time.time()
        time.sleep(arguments.seconds)
        took = time.time() - began
        rates = [8e-6 * (bytes_sent(host) - b) / took for host, b in zip(hosts, before)]
        sent = [float(p.communicate(timeout=60)[0].split()[-1]) for p in players]
        text = heard.communicate(timeout=60)[0].decode().split('result ')[-1].split()
        return rates, min(sent), text
    finally:
        for computer in [*hosts, centre]:
            computer.close()


def listen(kind, centre, cameras, arguments, start):
    return centre.start(sys.executable, __file__, arguments.bag, '--listen', kind, '--start', start, '--seconds',
                        arguments.seconds, '--rate', arguments.rate, '--names', *cameras,
                        output=subprocess.PIPE)


def hear(kind, bag, rate, start, seconds, cameras):
    """At the centre: sends the transforms, and prints latencies of one camera's masks and of the poses."""
    import rosbag
    import rospy
    from markerless_mocap.msg import BodyPose
    from sensor_msgs.msg import Image
    from tf2_msgs.msg import TFMessage
    rospy.init_node('network_table')
    tf = rospy.Publisher('/tf_static', TFMessage, queue_size=1, latch=True)
    for _, message, _ in rosbag.Bag(bag).read_messages(topics=['/tf_static']):
        tf.publish(message)
    masks, poses, tracked, lock = [], [], [], threading.Lock()

    def keep(times):
        def take(message):
            now = time.time()
            if start + WARM_UP <= now < start + WARM_UP + seconds:
                with lock:
                    times.append(now - message.header.stamp.to_sec())
                    if getattr(message, 'status', BodyPose.LOST) != BodyPose.LOST:
                        tracked.append(times[-1])
        return take
    if kind == 'images':
        subscribers = [rospy.Subscriber(c + '/image_raw', Image, keep(masks), queue_size=2, buff_size=2 ** 22,
                                        tcp_nodelay=True) for c in cameras]
    else:
        subscribers = [rospy.Subscriber('/pose', BodyPose, keep(poses), queue_size=100, tcp_nodelay=True)]
    time.sleep(max(0.0, start + WARM_UP + seconds - time.time()))
    if kind != 'images':  # now that bytes are counted: one camera's masks
        late, topic = [], cameras[-1] + '/silhouette' + ('/compressed' if kind == 'png' else '')
        subscribers.append(rospy.Subscriber(topic, rospy.AnyMsg, lambda m: late.append(
            time.time() - stamp_of(m)), queue_size=100, tcp_nodelay=True))
        time.sleep(1.5)
        masks = late
    print('result', *(f'{1e3 * statistics.median(t):.0f}' if t else '-' for t in (masks, tracked)),
          f'{len(poses) / (rate * seconds):.2f}' if poses else '-',
          f'{len(tracked) / len(poses):.2f}' if poses else '-', flush=True)
    os._exit(0)


def stamp_of(message):
    """Of any message that begins with a header."""
    import struct
    _, seconds, nanoseconds = struct.unpack_from('<III', message._buff)
    return seconds + 1e-9 * nanoseconds


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument('bag')
    parser.add_argument('--cameras', type=int, nargs='+', default=[4, 8, 16, 32])
    parser.add_argument('--kinds', nargs='+', choices=KINDS, default=KINDS)
    parser.add_argument('--rate', type=float, default=30.0, help='frame sets per second')
    parser.add_argument('--seconds', type=float, default=10.0)
    for name in ('--play', '--listen'):
        parser.add_argument(name, help=argparse.SUPPRESS)
    parser.add_argument('--start', type=float, help=argparse.SUPPRESS)
    parser.add_argument('--names', nargs='+', help=argparse.SUPPRESS)
    arguments = parser.parse_args()
    part = (arguments.bag, arguments.rate, arguments.start, arguments.seconds, arguments.names)
    if arguments.play:
        return play(arguments.play, *part)
    if arguments.listen:
        return hear(arguments.listen, *part)
    namespaces.ensure_allowed()
    print('| cameras | travels | Mbit/s per link | Mbit/s in all | sent | to the centre, ms | to the pose, ms '
          '| poses | tracked |\n|---|---|---|---|---|---|---|---|---|')
    for count in arguments.cameras:
        for kind in arguments.kinds:
            with tempfile.TemporaryDirectory() as folder:
                rates, sent, heard = measure(kind, count, arguments, folder)
            print(f'| {count} | {kind} | {max(rates):.1f} | {sum(rates):.1f} | {sent:.2f} | '
                  + ' | '.join(heard) + ' |', flush=True)
    return None


if __name__ == '__main__':
    main()

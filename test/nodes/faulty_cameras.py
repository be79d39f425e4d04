"""Plays a rendered recording as live cameras, forward and backward, and damages what they send."""
import copy
import math
import subprocess
import threading

import cv2
import numpy
import rosbag
import rospy
import tf2_ros
from geometry_msgs.msg import TransformStamped
from sensor_msgs.msg import CameraInfo, CompressedImage

CAMERAS = ['cam%d' % i for i in range(8)]
RATE, EMPTY, PERSON = 15.0, 45, 120  # per second, then frame sets


def render(path):
    settings = ['width=320', 'height=240', 'fps=%g' % RATE, 'background_frames=%d' % EMPTY,
                'duration=%g' % (PERSON / RATE)]
    subprocess.check_call(['rosrun', 'markerless_mocap', 'render_capture', path, '--quiet',
                           '--images', 'jpeg', '--rig', 'ring7_overhead', '--motion',
                           'wave_and_walk'] + [s for x in settings for s in ('--set', x)])


def matrix(transform):
    q, t = transform.rotation, transform.translation
    x, y, z, w = q.x, q.y, q.z, q.w
    return numpy.array([
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w), t.x],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w), t.y],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y), t.z],
        [0, 0, 0, 1]])


def places(transforms):
    """Place of each link in the world, by its name without the body's."""
    poses, found = {'world': numpy.eye(4)}, {}
    waiting = list(transforms)
    while waiting:
        rest = []
        for t in waiting:
            if t.header.frame_id in poses:
                poses[t.child_frame_id] = poses[t.header.frame_id] @ matrix(t.transform)
                found[t.child_frame_id.rsplit('_', 1)[0]] = poses[t.child_frame_id][:3, 3]
            else:
                rest.append(t)
        if len(rest) == len(waiting):
            break
        waiting = rest
    return found


def redrawn(data, change):
    picture = cv2.imdecode(numpy.frombuffer(data, numpy.uint8), cv2.IMREAD_COLOR)
    return cv2.imencode('.jpg', change(picture), [cv2.IMWRITE_JPEG_QUALITY, 90])[1].tobytes()


def bytes_of(levels):
    return numpy.clip(levels, 0, 255).astype(numpy.uint8)


def in_light(data, factor):
    """A JPEG in light of so many times the usual."""
    return redrawn(data, lambda picture: bytes_of(factor * picture.astype(numpy.float32)))


def with_noise(data):
    return redrawn(data, lambda picture: bytes_of(picture + numpy.random.normal(0, 2, picture.shape)))


class Recording:
    def __init__(self, path):
        sets, self.infos, self.truth, self.static = {}, {}, {}, []
        with rosbag.Bag(path) as bag:
            for topic, message, _ in bag.read_messages():
                if topic.endswith('/compressed'):
                    stamp = message.header.stamp.to_nsec()
                    sets.setdefault(stamp, {})[topic.strip('/').split('/')[0]] = bytes(message.data)
                elif topic.endswith('/camera_info'):
                    self.infos[topic.strip('/').split('/')[0]] = message
                elif topic == '/tf_static':
                    self.static += message.transforms
                elif topic == '/ground_truth/joints':
                    places = {n: (p.x, p.y, p.z) for n, p in zip(message.names, message.positions)
                              if n[:2] in ('l_', 'r_')}
                    self.truth[message.header.stamp.to_nsec()] = places
        self.stamps = sorted(sets)
        self.images = [sets[stamp] for stamp in self.stamps]
        self.places = [self.truth.get(stamp) for stamp in self.stamps]


class Cameras:
    """What a fault changes are the functions `stamp_of`, `content_of`, `data_of`, `info_of`,
    `frame_of`, `sends`, each by camera. While `stands` the person keeps still."""

    def __init__(self, recording):
        self.recording, self.frame, self.tick_count = recording, 0, 0
        self.content = {}  # stamp, ns -> frame set of the recording
        self.sent_at = {}  # stamp, ns -> time
        self.heal()
        self.images = {c: rospy.Publisher(c + '/image_raw/compressed', CompressedImage, queue_size=5)
                       for c in CAMERAS}
        self.infos = {c: rospy.Publisher(c + '/camera_info', CameraInfo, queue_size=5)
                      for c in CAMERAS}
        self.broadcaster = tf2_ros.StaticTransformBroadcaster()
        self.static = {}
        self.publish_static(recording.static)
        self.running = True
        self.thread = threading.Thread(target=self.run, daemon=True)

    def heal(self):
        self.stamp_of = lambda camera, stamp: stamp
        self.content_of = lambda camera, frame: frame
        self.data_of = lambda camera, data: data
        self.info_of = lambda camera, info: info
        self.frame_of = lambda camera, frame: frame
        self.sends = lambda camera: True
        self.stands = False

    def place(self, camera, shift):
        moved = TransformStamped()
        for transform in self.recording.static:
            if transform.child_frame_id.startswith(camera + '_'):
                moved = copy.deepcopy(transform)
        moved.transform.translation.x += shift
        self.publish_static([moved])

    def hang(self, child, parent):
        """A camera or another frame onto a frame."""
        hung = TransformStamped()
        hung.header.frame_id = parent
        hung.child_frame_id = child + '_optical' if child in CAMERAS else child
        hung.transform.rotation.w = 1.0
        self.publish_static([hung])

    def publish_static(self, transforms):
        """All of them each time: a node that starts later gets the last message only."""
        self.static.update((transform.child_frame_id, transform) for transform in transforms)
        self.broadcaster.sendTransform(list(self.static.values()))

    def index(self, frame):
        if frame < EMPTY:
            return frame
        at = (frame - EMPTY) % (2 * PERSON - 2)
        return EMPTY + (at if at < PERSON else 2 * PERSON - 2 - at)

    def run(self):
        rate = rospy.Rate(RATE)
        while self.running and not rospy.is_shutdown():
            self.send()
            rate.sleep()

    def send(self):
        now = rospy.Time.now()
        for camera in CAMERAS:
            if not self.sends(camera):
                continue
            stamp = self.stamp_of(camera, now)
            frame = self.index(self.content_of(camera, self.frame))
            info = copy.copy(self.info_of(camera, self.recording.infos[camera]))
            info.header = copy.copy(self.recording.infos[camera].header)
            info.header.stamp = stamp
            info.header.frame_id = self.frame_of(camera, info.header.frame_id)
            self.infos[camera].publish(info)
            image = CompressedImage(format='jpeg')
            image.header.stamp, image.header.frame_id = stamp, info.header.frame_id
            image.data = self.data_of(camera, self.recording.images[frame][camera])
            self.images[camera].publish(image)
            self.content[stamp.to_nsec()] = self.index(self.frame)
            self.sent_at[stamp.to_nsec()] = now.to_sec()
        self.frame += not self.stands

    def nearest(self, stamp_ns):
        return min(list(self.content), key=lambda s: abs(s - stamp_ns))

    def limb_error(self, found, limb, stamp_ns):
        """The distance of a joint from the truth, m."""
        truth = self.recording.places[self.content[self.nearest(stamp_ns)]]
        return math.dist(found[limb], truth[limb]) if truth else 9.0

    def error(self, found, stamp_ns):
        """The largest distance of a joint that is told from the truth, m."""
        truth = self.recording.places[self.content[self.nearest(stamp_ns)]]
        if truth is None:
            return 9.0
        shared = [name for name in found if name in truth]
        return max((math.dist(found[name], truth[name]) for name in shared), default=0.0)

"""Ways to break a recording: each changes a film, at one camera or at all, and returns the camera that
it is of, or ''. Their names are the findings of docs/checking.md."""
import math

import cv2
import numpy as np
import rosbag
import rospy


class Film:
    """The messages of a bag as lists, to be changed and written."""

    def __init__(self, path):
        self.images, self.infos, self.poses = {}, {}, {}
        with rosbag.Bag(str(path)) as bag:
            for topic, message, time in bag.read_messages():
                camera = topic.strip('/').split('/')[0]
                if topic.startswith('/ground_truth'):
                    continue
                if topic.endswith('image_raw/compressed'):
                    self.images.setdefault(camera, []).append([message, time.to_sec()])
                elif topic.endswith('camera_info'):
                    self.infos.setdefault(camera, []).append([message, time.to_sec()])
                elif topic == '/tf_static':
                    for transform in message.transforms:
                        self.poses[transform.child_frame_id[:-len('_optical')]] = transform
                    self.tf = message
        self.cameras = sorted(self.images)

    def write(self, path):
        with rosbag.Bag(str(path), 'w') as bag:
            start = min(times[0][1] for times in self.images.values() if times)
            self.tf.transforms = list(self.poses.values())
            bag.write('/tf_static', self.tf, rospy.Time.from_sec(start))
            for kind, streams in (('image_raw/compressed', self.images), ('camera_info', self.infos)):
                for camera, messages in streams.items():
                    for message, time in messages:
                        bag.write(f'/{camera}/{kind}', message, rospy.Time.from_sec(time))

    def shift(self, camera, seconds):
        """Stamps and times of reception, so that only the motion can tell."""
        for stream in (self.images, self.infos):
            for i, entry in enumerate(stream[camera]):
                moved = seconds(entry[0].header.stamp.to_sec(), i)
                entry[1] = entry[1] + moved
                entry[0].header.stamp = rospy.Time.from_sec(entry[0].header.stamp.to_sec() + moved)

    def change(self, camera, edit, first=0.0, last=1.0):
        images = self.images[camera]
        for i in range(int(first * len(images)), int(last * len(images))):
            message = images[i][0]
            picture = cv2.imdecode(np.frombuffer(message.data, np.uint8), cv2.IMREAD_COLOR)
            picture = np.clip(edit(picture.astype(np.float32), i), 0, 255).astype(np.uint8)
            message.data = cv2.imencode('.jpg', picture)[1].tobytes()

    def pose(self, camera):
        t, q = self.poses[camera].transform.translation, self.poses[camera].transform.rotation
        x, y, z, w = q.x, q.y, q.z, q.w
        rotation = np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                             [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                             [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])
        return rotation, np.array([t.x, t.y, t.z])

    def place(self, camera, rotation, translation):
        vector = cv2.Rodrigues(rotation)[0].ravel()
        angle = np.linalg.norm(vector)
        axis = vector / angle if angle > 0 else vector
        q = self.poses[camera].transform.rotation
        q.x, q.y, q.z = (math.sin(angle / 2) * axis).tolist()
        q.w = math.cos(angle / 2)
        t = self.poses[camera].transform.translation
        t.x, t.y, t.z = [float(value) for value in translation]


def turn(axis, degrees):
    return cv2.Rodrigues(np.asarray(axis, float) * math.radians(degrees))[0]


def camera_info_missing(film, camera, rng):
    film.infos[camera] = []
    return camera


def camera_info_zero(film, camera, rng):
    for message, _ in film.infos[camera]:
        message.K = [0.0] * 9
    return camera


def camera_info_size(film, camera, rng):
    for message, _ in film.infos[camera]:
        message.width, message.height = 640, 480
        message.K = [2 * value for value in message.K[:8]] + [1]
    return camera


def camera_info_changes(film, camera, rng):
    for i, (message, _) in enumerate(film.infos[camera]):
        factor = 1 + 0.02 * math.sin(0.05 * i)
        message.K = [factor * message.K[0], *message.K[1:4], factor * message.K[4], *message.K[5:]]
    return camera


def camera_info_implausible(film, camera, rng):
    for message, _ in film.infos[camera]:
        message.K = [4 * value for value in message.K[:8]] + [1]
    return camera


def image_size_changes(film, camera, rng):
    images = film.images[camera]
    for message, _ in images[len(images) // 2:]:
        picture = cv2.imdecode(np.frombuffer(message.data, np.uint8), cv2.IMREAD_COLOR)
        message.data = cv2.imencode('.jpg', cv2.resize(picture, (160, 120)))[1].tobytes()
    return camera


def images_missing(film, camera, rng):
    film.images[camera] = []
    return camera


def tf_missing(film, camera, rng):
    del film.poses[camera]
    return camera


def units_not_metres(film, camera, rng):
    for name in film.cameras:
        rotation, place = film.pose(name)
        film.place(name, rotation, 1000 * place)
    return ''


def world_z_down(film, camera, rng):
    for name in film.cameras:
        rotation, place = film.pose(name)
        flip = turn([1, 0, 0], 180)
        film.place(name, flip @ rotation, flip @ place)
    return ''


def world_z_not_up(film, camera, rng):
    for name in film.cameras:
        rotation, place = film.pose(name)
        flip = turn([1, 0, 0], -90)
        film.place(name, flip @ rotation, flip @ place)
    return ''


def rotation_inverted(film, camera, rng):
    for name in film.cameras:
        rotation, place = film.pose(name)
        film.place(name, rotation.T, place)
    return ''


def rotation_inverted_of_one(film, camera, rng):
    rotation, place = film.pose(camera)
    film.place(camera, rotation.T, place)
    return camera


def pose_inverted(film, camera, rng):
    for name in film.cameras:
        rotation, place = film.pose(name)
        film.place(name, rotation.T, -rotation.T @ place)
    return ''


def translation_inverted(film, camera, rng):
    for name in film.cameras:
        rotation, place = film.pose(name)
        film.place(name, rotation, -rotation.T @ place)
    return ''


def axes_not_optical(film, camera, rng):
    body_of_optical = np.array([[0, 0, 1], [-1, 0, 0], [0, -1, 0]], float)
    for name in film.cameras:
        rotation, place = film.pose(name)
        film.place(name, rotation @ body_of_optical.T, place)
    return ''


def no_common_volume(film, camera, rng):
    rotation, place = film.pose(camera)
    film.place(camera, rotation @ turn([0, 1, 0], 170), place)
    film.change(camera, lambda picture, i: 0 * picture + 90 + rng.normal(0, 20, picture.shape))
    return camera


def cameras_exchanged(film, camera, rng):
    other = film.cameras[(film.cameras.index(camera) + 1) % len(film.cameras)]
    film.images[camera], film.images[other] = film.images[other], film.images[camera]
    return ', '.join(sorted([camera, other]))


def poses_identical(film, camera, rng):
    other = film.cameras[(film.cameras.index(camera) + 1) % len(film.cameras)]
    film.place(camera, *film.pose(other))
    return ', '.join(sorted([camera, other]))


def time_offset(film, camera, rng):
    late = rng.choice([-1, 1]) * rng.uniform(0.04, 0.3)
    film.shift(camera, lambda stamp, i: late)
    return camera


def clock_drifts(film, camera, rng):
    start = film.images[camera][0][1]
    film.shift(camera, lambda stamp, i: 0.015 * (stamp - start))
    return camera


def clocks_apart(film, camera, rng):
    film.shift(camera, lambda stamp, i: 3600.0)
    return camera


def stamps_of_reception(film, camera, rng):
    film.shift(camera, lambda stamp, i: abs(rng.normal(0, 0.012)))
    return camera


def stamps_jitter(film, camera, rng):
    for message, _ in film.images[camera]:
        message.header.stamp = rospy.Time.from_sec(message.header.stamp.to_sec() + rng.normal(0, 0.008))
    return camera


def stamps_zero(film, camera, rng):
    for message, _ in film.images[camera]:
        message.header.stamp = rospy.Time(0)
    return camera


def stamps_jump_back(film, camera, rng):
    images = film.images[camera]
    for message, _ in images[len(images) // 2:]:
        message.header.stamp -= rospy.Duration(1.7)
    return camera


def images_dropped(film, camera, rng):
    film.images[camera] = [entry for entry in film.images[camera] if rng.random() > 0.08]
    return camera


def rate_differs(film, camera, rng):
    film.images[camera] = film.images[camera][::2]
    return camera


def images_frozen(film, camera, rng):
    images = film.images[camera]
    half = len(images) // 2
    for message, _ in images[half:half + 40]:
        message.data = images[half][0].data
    return camera


def light_flickers(film, camera, rng):
    hertz = rng.uniform(1.5, 12)
    film.change(camera, lambda picture, i: picture * (1 + 0.08 * math.sin(2 * math.pi * hertz * i / 30)))
    return camera


def exposure_wanders(film, camera, rng):
    count = len(film.images[camera])
    film.change(camera, lambda picture, i: picture * (1 + 0.25 * (i / count) ** 2))
    return camera


def white_balance_wanders(film, camera, rng):
    count = len(film.images[camera])
    film.change(camera, lambda picture, i: picture * np.array([1 + 0.1 * i / count, 1, 1], np.float32))
    return camera


def image_dark(film, camera, rng):
    film.change(camera, lambda picture, i: 0.12 * picture)
    return camera


def image_overexposed(film, camera, rng):
    film.change(camera, lambda picture, i: 2.6 * picture)
    return camera


def image_covered(film, camera, rng):
    film.change(camera, lambda picture, i: 0 * picture + 30 + rng.normal(0, 2, picture.shape), 0.4)
    return camera


def image_blurred(film, camera, rng):
    film.change(camera, lambda picture, i: cv2.GaussianBlur(picture, (0, 0), 5))
    return camera


def turned_picture(film, camera, rotation):
    k = np.array(film.infos[camera][0][0].K).reshape(3, 3)
    warp = k @ rotation @ np.linalg.inv(k)
    return lambda picture, i: cv2.warpPerspective(picture, warp, (picture.shape[1], picture.shape[0]),
                                                  borderMode=cv2.BORDER_REPLICATE)


def camera_moved(film, camera, rng):
    bump = turn([0, 1, 0], 1.0) @ turn([1, 0, 0], 0.6)
    film.change(camera, turned_picture(film, camera, bump), rng.uniform(0.4, 0.7))
    return camera


def camera_turned(film, camera, rng):
    rotation, place = film.pose(camera)
    axis = rng.choice([0, 1])
    film.place(camera, rotation @ turn([axis, 1 - axis, 0], rng.choice([-1, 1]) * rng.uniform(2, 5)), place)
    return camera


def image_upside_down(film, camera, rng):
    film.change(camera, lambda picture, i: picture[::-1, ::-1])
    return camera


def image_mirrored(film, camera, rng):
    film.change(camera, lambda picture, i: picture[:, ::-1])
    return camera


def focal_length_wrong(film, camera, rng):
    factor = rng.choice([0.75, 1.3])
    for message, _ in film.infos[camera]:
        message.K = [factor * message.K[0], *message.K[1:4], factor * message.K[4], *message.K[5:]]
    return camera


def volume_cuts_person(film, camera, rng):
    """The world's origin is not where the person is."""
    for name in film.cameras:
        rotation, place = film.pose(name)
        film.place(name, rotation, place + np.array([1.4, 0, 0]))
    return ''


def distortion_wrong(film, camera, rng):
    for message, _ in film.infos[camera]:
        message.D = [message.D[0] - 0.45, 0.1, 0, 0, 0]
    return camera


EDITS = [camera_info_missing, camera_info_zero, camera_info_size, camera_info_changes,
         camera_info_implausible, image_size_changes, images_missing, tf_missing, units_not_metres,
         world_z_down, world_z_not_up, rotation_inverted, rotation_inverted_of_one, pose_inverted,
         translation_inverted, axes_not_optical, no_common_volume, cameras_exchanged,
         poses_identical, time_offset, clock_drifts, clocks_apart, stamps_of_reception,
         stamps_jitter, stamps_zero, stamps_jump_back, images_dropped, rate_differs, images_frozen,
         light_flickers, exposure_wanders, white_balance_wanders, image_dark, image_overexposed,
         image_covered, image_blurred, camera_moved, camera_turned, image_upside_down,
         image_mirrored, focal_length_wrong, distortion_wrong, volume_cuts_person]

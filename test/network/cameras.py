#!/usr/bin/python3
"""Plays some cameras of a recording with JPEGs, with the stamps of now, in step with other computers.

    cameras.py BAG EMPTY RATE CAMERA...

The time of the first image is the parameter /start. The clock of this computer is AHEAD seconds ahead of
the others, a variable of the environment. After the EMPTY images of the empty room, the others
are played forwards and backwards for ever."""
import os
import sys
import time

import rosbag
import rospy
from sensor_msgs.msg import CameraInfo, CompressedImage
from tf2_msgs.msg import TFMessage


def read(path, cameras):
    images, infos, transforms = {c: [] for c in cameras}, {}, TFMessage()
    with rosbag.Bag(path) as bag:
        for topic, message, _ in bag.read_messages():
            camera, _, kind = topic.strip('/').partition('/')
            if kind == 'image_raw/compressed' and camera in images:
                images[camera].append(message.data)
            elif kind == 'camera_info' and camera in images:
                infos[camera] = message
            elif topic.strip('/') == 'tf_static':
                transforms.transforms += message.transforms
    frames = {info.header.frame_id for info in infos.values()}
    transforms.transforms = [t for t in transforms.transforms if t.child_frame_id in frames]
    return images, infos, transforms


def main():
    path, empty, rate, cameras = sys.argv[1], int(sys.argv[2]), float(sys.argv[3]), sys.argv[4:]
    images, infos, transforms = read(path, cameras)
    rospy.init_node('cameras_' + cameras[0])
    tf = rospy.Publisher('/tf_static', TFMessage, queue_size=1, latch=True)
    tf.publish(transforms)
    out = {c: (rospy.Publisher(c + '/image_raw/compressed', CompressedImage, queue_size=4),
               rospy.Publisher(c + '/camera_info', CameraInfo, queue_size=4)) for c in cameras}
    while not rospy.has_param('/start'):
        time.sleep(0.1)
    start = rospy.get_param('/start')
    ahead = float(os.environ.get('AHEAD', 0))
    length = len(images[cameras[0]]) - empty
    number = max(0, int((time.time() - start) * rate) + 1)
    while not rospy.is_shutdown():
        stamp = start + number / rate
        time.sleep(max(0.0, stamp - time.time()))
        at = number
        if number >= empty:
            place = (number - empty) % (2 * length - 2)
            at = empty + min(place, 2 * length - 2 - place)
        for camera in cameras:
            image = CompressedImage(format='jpeg', data=images[camera][at])
            image.header.stamp = infos[camera].header.stamp = rospy.Time.from_sec(stamp + ahead)
            image.header.frame_id = infos[camera].header.frame_id
            out[camera][0].publish(image)
            out[camera][1].publish(infos[camera])
        number = max(number + 1, int((time.time() - start) * rate))


if __name__ == '__main__':
    main()

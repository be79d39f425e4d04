"""Faults of the fault suite: images that do not come, or are not what they seem."""
import subprocess
import time

import cv2
from fault_case import SECONDS
from faulty_cameras import CAMERAS, RATE, in_light, redrawn
from markerless_mocap.msg import MocapStatus


class CameraFaults:
    def test_two_publishers_of_one(self):
        """The other one sends images without stamp and pixels."""
        other = subprocess.Popen(['rostopic', 'pub', '-r', str(RATE), '/cam4/image_raw/compressed',
                                  'sensor_msgs/CompressedImage', '{format: jpeg}'],
                                 stdout=subprocess.DEVNULL)
        try:
            time.sleep(2.0)  # it takes a while to start
            self.run_fault()
        finally:
            other.kill()  # rospy does not always end by SIGTERM
            other.wait()
        self.expect('sends on /cam4/image_raw/compressed, too; allowed is one sender', least=0.8)

    def test_camera_gone(self):
        self.cameras.sends = lambda camera: camera != 'cam3'
        self.run_fault(4.0)
        self.expect('no messages on /cam3/silhouette', 'no messages on /cam3/image_raw')
        self.assertLess(self.latency, self.usual_latency + 0.35)

    def test_cameras_gone(self):
        self.cameras.sends = lambda camera: False
        time.sleep(SECONDS + 0.5)
        for stage in ('visual hull', 'body segmentation', 'pose tree', 'pose fitting',
                      'silhouette of cam0'):
            level, message = self.level_of(stage)
            self.assertEqual(2, level, (stage, message))
        self.assertEqual(MocapStatus.ERROR, self.beats[-1].level)
        self.assertEqual(CAMERAS, self.beats[-1].cameras)
        self.assertGreater((self.beats[-1].header.stamp - self.beats[-1].last_stamps[0]).to_sec(), 2)
        self.end = time.time()
        self.cameras.heal()
        self.expect('no silhouettes come from any camera', 'no messages on /cam0/image_raw', least=0,
                    level=2, silence=5.5)
        self.assertLess(self.recovery, 1.5)

    def test_content_of_one_late(self):
        self.cameras.content_of = lambda camera, frame: frame - 3 * (camera == 'cam2')
        self.run_fault()
        self.expect(level=0)

    def freeze(self, *frozen):
        at = self.cameras.frame
        self.cameras.content_of = lambda camera, frame: at if camera in frozen else frame
        self.run_fault()
        self.assertTrue(self.warned(frozen[0]), self.beats[-4:])
        self.expect(*[camera + ' is frozen' for camera in frozen])

    def warned(self, camera):
        """A consumer of pose/status alone is told that a camera is not used."""
        return any(beat.level == MocapStatus.WARN and 'without ' + camera in beat.message and
                   not beat.used[beat.cameras.index(camera)]
                   for beat in self.beats if beat.header.stamp.to_sec() >= self.start)

    def test_one_frozen(self):
        self.freeze('cam1')

    def test_two_frozen(self):
        self.freeze('cam1', 'cam4')

    def test_truncated_jpegs_of_one(self):
        self.cameras.data_of = (lambda camera, data:
                                data[:len(data) // 2] if camera == 'cam5' else data)
        self.run_fault()
        self.expect('cam5 has sent images that cannot be used')

    # Last: some damaged JPEGs are decoded without complaint, and what they do to a background stays
    # for a while (it is told that it is stale).
    def test_zz_corrupted_jpegs(self):
        self.cameras.data_of = lambda camera, data: data[:1500] + b'\x5a' * 400 + data[1900:]
        self.run_fault(2.0)
        self.expect('has sent images that cannot be used', least=0, silence=4.0)
        self.assertLess(self.recovery, 1.5)

    def pictures_of_one(self, change, *sentences):
        self.cameras.data_of = lambda camera, data: change(data) if camera == 'cam5' else data
        self.run_fault()
        self.expect(*sentences)

    def test_pictures_of_one_are_black(self):
        self.pictures_of_one(lambda data: in_light(data, 0.0))

    def test_pictures_of_one_are_mirrored(self):
        self.pictures_of_one(lambda data: redrawn(data, lambda picture: cv2.flip(picture, 1)))

    def test_pictures_of_one_are_half_as_large(self):
        self.pictures_of_one(lambda data: redrawn(data, lambda picture: picture[::2, ::2]),
                             'cam5 has sent images that cannot be used')

    def test_pictures_of_one_are_empty(self):
        self.pictures_of_one(lambda data: b'', 'cam5 has sent images that cannot be used')

    def test_pictures_of_all_are_grey(self):
        """The cameras send all the time, and nothing says that they do not."""
        self.cameras.data_of = lambda camera, data: redrawn(data, lambda picture: picture[:, :, 1])
        self.run_fault()
        self.expect('no silhouettes come from any camera', 'allowed is 320 x 240 BGR', least=0,
                    silence=5.5)
        self.assertFalse(self.said('no camera sends'))
        self.assertFalse(self.said('no messages on /cam0/image_raw'))

    def light(self, factor):
        self.cameras.data_of = lambda camera, data: in_light(data, factor)
        time.sleep(SECONDS)
        self.end = time.time()
        self.cameras.heal()

    def test_white_light(self):
        self.light(8.0)
        self.expect(least=0, silence=5.0)
        self.assertLess(self.recovery, 1.5)
        self.assertFalse(self.said('stood still in view'))

    def test_darkness(self):
        self.light(0.02)
        self.expect(least=0, silence=5.0)
        self.assertLess(self.recovery, 1.5)
        self.assertFalse(self.said('stood still in view'))

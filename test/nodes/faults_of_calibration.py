"""Faults of the fault suite: camera_info and tf."""
import time

from fault_case import SECONDS
from sensor_msgs.msg import CameraInfo


class CalibrationFaults:
    def test_k_wanders(self):
        def info_of(camera, info):
            wandering = CameraInfo(**{name: getattr(info, name) for name in info.__slots__})
            wandering.K = list(info.K)
            wandering.K[0] += 0.01 * (self.cameras.frame % 50)
            return wandering
        self.cameras.info_of = info_of
        self.run_fault()
        self.expect('changes all the time')

    def test_camera_info_of_other_images(self):
        def info_of(camera, info):
            other = CameraInfo(**{name: getattr(info, name) for name in info.__slots__})
            other.width = other.height = 30000
            return other
        self.cameras.info_of = info_of
        self.run_fault()
        self.expect('but the new one is not used: it says 30000 x 30000')

    def test_camera_info_of_no_lens(self):
        def info_of(camera, info):
            other = CameraInfo(**{name: getattr(info, name) for name in info.__slots__})
            other.D = [1e6, -1e9, 0.0, 0.0, 0.0]
            return other
        self.cameras.info_of = info_of
        self.run_fault()
        self.expect('but the new one is not used')

    def test_camera_info_of_no_view(self):
        """Its principal point is far beside the image."""
        self.k_of_one({2: 1e6})
        self.expect('but the new one is not used: camera \'cam2\': by K', least=0.8)

    def test_camera_info_of_another_camera(self):
        """A calibration of half the focal length, or of a part of a larger image."""
        for change in ({0: 150.0, 4: 150.0}, {2: 3 * 320.0}):
            self.start = time.time()
            self.k_of_one(change)
            self.expect('the person is seen elsewhere by cam2', least=0.8)
            self.assertLess(self.recovery, 1.0)

    def k_of_one(self, change):
        def info_of(camera, info):
            other = CameraInfo(**{name: getattr(info, name) for name in info.__slots__})
            other.K = list(info.K)
            for place, value in change.items():
                other.K[place] = value
            return other if camera == 'cam2' else info
        self.cameras.info_of = info_of
        self.run_fault(4.0)

    def test_frame_of_one_is_empty(self):
        self.cameras.frame_of = lambda camera, frame: '' if camera == 'cam2' else frame
        self.run_fault()
        self.expect('cam2 has changed, but the new one is not used: its frame_id is empty')

    def test_frame_of_one_is_anothers(self):
        self.cameras.frame_of = lambda camera, frame: frame.replace('cam2', 'cam3')
        self.run_fault()
        self.expect('cam2 has changed, but the new one is not used: its frame_id cam3_optical is '
                    'that of cam3', least=0.8)

    def test_tf_of_one_is_no_number(self):
        self.cameras.place('cam2', float('nan'))
        time.sleep(SECONDS)
        self.end = time.time()
        self.cameras.place('cam2', 0.0)
        self.expect('a transform of cam2_optical to tf that is not used', least=0.8)

    def test_tf_of_one_loops(self):
        self.cameras.hang('cam2', 'mount')
        self.cameras.hang('mount', 'cam2_optical')
        time.sleep(SECONDS)
        self.end = time.time()
        self.cameras.place('cam2', 0.0)
        self.expect('tf does not connect cam2_optical of cam2 to world; cam2 is used where it was '
                    'before', least=0.8)

    def test_y_camera_moves_by_tf(self):
        self.cameras.place('cam6', 0.3)
        self.run_fault(2.0)
        # The way back, while nobody sends: it is believed at once when they do again.
        self.cameras.sends = lambda camera: False
        time.sleep(0.3)
        self.cameras.place('cam6', 0.0)
        time.sleep(0.7)
        self.end = time.time()
        self.cameras.heal()
        self.expect('cam6 has moved by tf, it is left out until it rests',
                    'cam6 has moved by 0.300 m and 0.0 degrees by tf, its new pose', least=0,
                    silence=4.0)

    def test_y_camera_keeps_moving_by_tf(self):
        for i in range(20):
            self.cameras.place('cam6', 0.3 + 0.1 * (i % 3))
            time.sleep(0.2)
        self.cameras.place('cam6', 0.0)
        self.run_fault(0.1)
        self.expect('cam6 has moved by tf, it is left out until it rests')

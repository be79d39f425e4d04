"""Faults of the fault suite: clocks and stamps."""
import time

import rospy
from fault_case import SECONDS
from faulty_cameras import CAMERAS


class ClockFaults:
    def step(self, seconds):
        shift = rospy.Duration.from_sec(seconds)
        self.cameras.stamp_of = lambda camera, stamp: stamp + shift
        time.sleep(SECONDS)
        self.end = time.time()

    def set_right(self):
        self.cameras.heal()
        time.sleep(1.5)

    def test_clock_back_1s(self):
        self.step(-1.0)
        self.expect('set back by 1.0', 'set back by 0.9', some=True)
        self.assertFalse(self.said('learning the background'))
        self.set_right()

    def test_clock_back_300ms(self):
        self.step(-0.3)
        self.expect('set back by 0.3', 'set back by 0.2', some=True)
        self.set_right()

    def test_clock_ahead_1000s_and_right_again(self):
        self.cameras.stamp_of = lambda camera, stamp: stamp + rospy.Duration(1000)
        self.run_fault()
        self.expect('the clock was set ahead by', 'the clock was set back by')
        self.assertLess(self.recovery, 1.0)

    def test_clock_back_100s_and_right_again(self):
        self.cameras.stamp_of = lambda camera, stamp: stamp - rospy.Duration(100)
        self.run_fault()
        self.expect('the clock was set back by', 'the clock was set ahead by')
        self.assertLess(self.recovery, 1.0)

    def test_one_image_ahead(self):
        left = {camera: 1 for camera in CAMERAS}

        def stamp_of(camera, stamp):
            left[camera] -= 1
            return stamp + rospy.Duration(1.0) if left[camera] >= 0 else stamp
        self.cameras.stamp_of = stamp_of
        self.run_fault()
        self.expect()
        self.assertFalse(self.said('learning the background'))

    def test_stamps_zero(self):
        self.cameras.stamp_of = lambda camera, stamp: rospy.Time(0)
        self.run_fault()
        self.expect('stamps of cam0', least=0, level=2, silence=5.0)
        self.assertLess(self.recovery, 1.5)

    def test_stamps_stand_still(self):
        """They go on by a nanosecond each."""
        first, sent = rospy.Time.now(), dict.fromkeys(CAMERAS, 0)

        def stamp_of(camera, stamp):
            sent[camera] += 1
            return first + rospy.Duration(0, sent[camera])
        self.cameras.stamp_of = stamp_of
        self.run_fault()
        self.expect('images of cam0 have the same stamp', least=0, silence=5.0)
        self.assertLess(self.recovery, 1.5)

    def test_stamps_of_one_off(self):
        for shift in (0.03, -0.05, 0.05):
            self.start = time.time()
            self.cameras.stamp_of = (lambda camera, stamp, s=rospy.Duration(shift):
                                     stamp + s if camera == 'cam2' else stamp)
            self.run_fault(4.0)
            self.expect('cam2 is left out, its nearest stamp is')

    def test_stamps_of_all_apart(self):
        """The cameras are not in step: none fits to another."""
        self.cameras.stamp_of = (lambda camera, stamp:
                                 stamp + rospy.Duration(0, 8000000 * CAMERAS.index(camera)))
        self.run_fault(4.0)
        self.expect('the frame set has the masks of 1 of 8 cameras',
                    'cam1 is left out, its nearest stamp is', least=0, silence=7.0)
        self.assertLess(self.recovery, 1.5)

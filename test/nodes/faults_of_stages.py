"""Faults of the fault suite: stages that hang or end."""
import os
import signal
import time

from fault_case import SECONDS, pid_of, runs_again, wait_for


class StageFaults:
    def stop_stage(self, stage):
        """A stage that nobody needs to follow the person: poses go on."""
        pid = pid_of(stage)
        os.kill(pid, signal.SIGSTOP)
        try:
            time.sleep(SECONDS + 1.0)
            self.end = time.time()
        finally:
            os.kill(pid, signal.SIGCONT)
        self.expect()
        self.assertLess(self.latency, self.usual_latency + 0.35)

    def test_pose_tree_hangs(self):
        self.stop_stage('pose_tree')

    def test_body_segmentation_hangs(self):
        self.stop_stage('body_segmentation')

    def kill_stage(self, stage):
        pid = pid_of(stage)
        os.kill(pid, signal.SIGKILL)
        time.sleep(SECONDS)
        wait_for(lambda: runs_again(stage, pid), 30)
        self.end = time.time()
        self.expect()
        self.assertLess(self.latency, self.usual_latency + 0.35)

    def test_pose_tree_is_killed(self):
        self.kill_stage('pose_tree')

    def test_visual_hull_is_killed(self):
        self.kill_stage('visual_hull')

    def test_visual_hull_hangs(self):
        self.stop_stage('visual_hull')

    def test_z_silhouette_starts_again(self):
        pid = pid_of('silhouette')
        os.kill(pid, signal.SIGKILL)
        time.sleep(0.8)  # what is under way
        self.end = time.time()
        self.expect('is that of ' + self.folder, least=0, silence=5.0)
        self.assertLess(self.recovery, 4.0)
        self.assertFalse(self.said('learning the background, 2'))

    def test_z_pose_fitting_is_killed(self):
        pid = pid_of('pose_fitting')
        os.kill(pid, signal.SIGKILL)
        wait_for(lambda: runs_again('pose_fitting', pid), 30)
        self.end = time.time()
        self.expect(least=0, silence=5.0)
        # From when it has all inputs: rospy, which sends here, connects one subscriber after another.
        searched = [at for at, reason in self.lost if at > self.start and 'searched for' in reason]
        self.assertLess(self.end + self.recovery - min(searched), 1.0)

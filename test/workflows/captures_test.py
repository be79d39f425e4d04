"""scripts/captures over small rendered recordings: failures, what is done again, interruptions, parts."""
import collections
import csv
import math
import os
import signal
import time
import unittest

import rosbag

from one_node_slurm import one_node_slurm, what_is_missing
from workflow_fixture import WorkflowTest

SHORT = 'formats: [csv]\ncheck_recording: {seconds: 1}\n'
UNMEASURED = SHORT + 'config: {pose_fitting: {measure: false}}\n'
FEW = {'rig': 'ring4'}  # where the workflow is tested and not the pose


def times(folder, pattern):
    return {path: path.stat().st_mtime_ns for path in folder.glob(pattern)}


class Folder(WorkflowTest):
    """Two good recordings and a damaged one. The cases go through the life of a folder, in this order."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.render(cls.folder / 'recordings' / 'anna.bag', 'duration=1', **FEW)
        cls.render(cls.folder / 'recordings' / 'ben.bag', 'duration=1', 'male=0', **FEW)
        bytes_of_anna = (cls.folder / 'recordings' / 'anna.bag').read_bytes()
        (cls.folder / 'recordings' / 'cut_off.bag').write_bytes(bytes_of_anna[:len(bytes_of_anna) // 2])
        (cls.folder / 'options.yaml').write_text(UNMEASURED)
        cls.out = cls.folder / 'results'

    def captures(self, *words):
        return self.run_script('captures', 'recordings', '--options', 'options.yaml', '--out', 'results', *words)

    def test_1_a_damaged_recording_does_not_stop_the_others(self):
        os.chmod(self.folder / 'recordings', 0o555)
        code, out, err = self.captures()
        os.chmod(self.folder / 'recordings', 0o755)
        self.assertEqual(code, 1, err)
        self.assertIn('2 of 3 recordings done', out)
        sentences = [line for line in err.splitlines() if line.startswith('captures: ')]
        self.assertEqual(len(sentences), 1, err)
        self.assertRegex(sentences[0], r'cut_off: \w+: .*cut_off.bag (is not a bag|has no index)')
        rows = {row[0]: row for row in self.rows(self.out / 'overview.html')}
        self.assertEqual(sorted(rows), ['anna', 'ben', 'cut_off'])
        self.assertEqual([rows['anna'][1], rows['ben'][1]], ['done', 'done'])
        self.assertIn('cut_off.bag', rows['cut_off'][1])
        for name in ('anna', 'ben'):
            for file in ('result.bag', 'check.json', 'motion.csv', 'report/report.html'):
                self.assertTrue((self.out / name / file).is_file(), file)

    def test_2_only_what_changed_is_done_again(self):
        (self.folder / 'recordings' / 'cut_off.bag').unlink()
        before = times(self.out, '*/result.bag')
        anna = self.folder / 'recordings' / 'anna.bag'
        os.utime(anna)  # the time alone changes nothing
        code, _, err = self.captures()
        self.assertEqual(code, 0, err)
        self.assertIn('2 of 2 had been done before', err)
        self.assertEqual(times(self.out, '*/result.bag'), before)
        self.render(self.folder / 'recordings' / 'ben.bag', 'duration=1', 'male=0', 'seed=9', **FEW)
        self.assertEqual(self.captures()[0], 0)
        after = times(self.out, '*/result.bag')
        self.assertEqual({path.parent.name for path in before if before[path] != after[path]}, {'ben'})

    def test_3_options_of_one_step_or_one_recording_leave_the_rest_alone(self):
        before = times(self.out, '*/result.bag')
        exported = times(self.out, '*/motion.csv')
        (self.folder / 'options.yaml').write_text(UNMEASURED + 'export_motion: {angles: true}\n'
                                                  'recordings: {anna: {mocap_offline: {poses-only: true}}}\n')
        self.assertEqual(self.captures()[0], 0)
        after = times(self.out, '*/result.bag')
        self.assertEqual({path.parent.name for path in before if before[path] != after[path]}, {'anna'})
        self.assertTrue(all(times(self.out, '*/motion.csv')[path] != exported[path] for path in exported))

    def test_4_an_interrupted_run_goes_on(self):
        words = ('captures', 'recordings', '--options', 'options.yaml', '--out', 'again', '--cores', '1')
        process = self.start(*words)
        done = self.folder / 'again'
        for _ in range(3000):
            if len(times(done, '*/logs/*.log')) > 1:  # the second step has begun
                break
            time.sleep(0.02)
        before = times(done, '*/result.bag')  # one that is written now may count as not complete
        process.send_signal(signal.SIGINT)
        _, err = process.communicate()
        self.assertEqual(process.returncode, 130, err)
        self.assertIn('interrupted; the same command goes on from here', err)
        self.assertEqual(list(done.rglob('*.active')), [])
        self.assertTrue(before)
        code, _, err = self.run_script(*words)
        self.assertEqual(code, 0, err)
        after = times(done, '*/result.bag')
        self.assertEqual(len(after), 2)
        self.assertEqual({path: after[path] for path in before}, before)

    def test_5_wrong_options_are_told_before_anything_runs(self):
        for text, sentence in (('format: [csv]', 'there is no option format'),
                               ('formats: [fbx]', 'there is no format fbx'),
                               ('mocap_offline: {start: 3}', 'mocap_offline/start cannot be given here')):
            (self.folder / 'wrong.yaml').write_text(text)
            code, _, err = self.run_script('captures', 'recordings', '--options', 'wrong.yaml', '--out', 'wrong')
            self.assertEqual(code, 1)
            self.assertIn(sentence, err)
            self.assertEqual(len(err.splitlines()), 1, err)


class Parts(WorkflowTest):
    """One recording, followed whole and in parts."""

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.render(cls.folder / 'long.bag', 'duration=8', motion='walk_in_circle')

    def follow(self, name, cut):
        (self.folder / f'{name}.yaml').write_text(SHORT + f'cut: {cut}\n')
        code, _, err = self.run_script('captures', 'long.bag', '--options', f'{name}.yaml', '--out', name)
        self.assertEqual(code, 0, err)
        return self.folder / name / 'long'

    @staticmethod
    def counts(folder):
        with rosbag.Bag(str(folder / 'result.bag')) as bag:
            return collections.Counter(topic for topic, _, _ in bag.read_messages(raw=True))

    @staticmethod
    def joints(folder):
        with open(folder / 'motion.csv') as file:
            return {(row['stamp_s'], row['joint']): [float(row[axis]) for axis in ('x_m', 'y_m', 'z_m')]
                    for row in csv.DictReader(file) if row['x_m']}

    def test_the_joined_result_is_the_whole_one_though_an_overlap_was_too_short(self):
        whole = self.follow('whole', 'false')
        joined = self.follow('joined', '{part_minutes: 0.08, overlap_s: 0.7}')
        log = (joined / 'logs/follow.log').read_text()
        self.assertIn('parts 1 and 2 do not agree: their overlap of', log)
        self.assertIn('part 2 again with an overlap of 2.1 s', log)
        self.assertIn('joined at', log)
        self.assertTrue((joined / 'parts/2/report/report.html').is_file())
        self.assertEqual(self.counts(joined), self.counts(whole))
        a, b = self.joints(whole), self.joints(joined)
        self.assertEqual(set(a), set(b))
        for stamp in {stamp for stamp, _ in a}:
            apart = [math.dist(a[key], b[key]) for key in a if key[0] == stamp]
            self.assertLess(sum(apart) / len(apart), 0.005, stamp)

    def test_parts_that_do_not_agree_are_not_joined(self):
        (self.folder / 'never.yaml').write_text(UNMEASURED + 'cut: {part_minutes: 0.08, overlap_s: 0.05}\n'
                                                'mocap_offline: {poses-only: true}\n')
        code, _, err = self.run_script('captures', 'long.bag', '--options', 'never.yaml', '--out', 'never')
        self.assertEqual(code, 1)
        self.assertRegex(err.splitlines()[-1], r'captures: long: join_results: parts 1 and 2 do not agree: ')
        self.assertFalse((self.folder / 'never/long/result.bag').exists())


class Slurm(WorkflowTest):
    @unittest.skipIf(what_is_missing(), what_is_missing())
    def test_the_same_workflow_runs_on_slurm(self):
        self.render(self.folder / 'anna.bag', 'duration=1', **FEW)
        (self.folder / 'options.yaml').write_text(UNMEASURED + 'memory_mb: 700\n')
        with one_node_slurm(self.folder / 'slurm') as environment:
            code, out, err = self.run_script('captures', 'anna.bag', '--options', 'options.yaml', '--profile',
                                             'slurm', environment=environment)
        self.assertEqual(code, 0, err)
        self.assertIn('1 of 1 recordings done', out)
        log = (self.folder / 'captures_results/snakemake.log').read_text()
        self.assertEqual(log.count('Submitted job'), 3, log)  # checking, following, exporting
        self.assertTrue((self.folder / 'captures_results/anna/motion.csv').is_file())


if __name__ == '__main__':
    unittest.main(verbosity=2)

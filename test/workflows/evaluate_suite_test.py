"""scripts/evaluate_suite over a small suite: its table, what is done again, what is kept."""
import unittest

from workflow_fixture import WorkflowTest

SUITE = '''
captures:
  wave: {motion: wave, rig: ring7_overhead, duration: 2, fps: 15, width: 200, height: 150}
  nobody_moves: {motion: no_such_motion}
methods:
  default: {}
  coarse: {visual_hull: {pitch: 0.05}}
'''


class Suite(WorkflowTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        (cls.folder / 'small.yaml').write_text(SUITE)

    def suite(self):
        return self.run_script('evaluate_suite', '--profile', 'small.yaml', '--out', 'out')

    def test_1_each_line_has_figures_or_a_sentence(self):
        code, out, err = self.suite()
        self.assertEqual(code, 1)
        lines = {tuple(cell.strip() for cell in line.split('|')[1:3]): line.split('|')[3:-1]
                 for line in out.splitlines() if line.startswith('| ')}
        for method in ('default', 'coarse'):
            self.assertLess(float(lines['wave', method][0]), 60, err)
            self.assertGreater(float(lines['wave', method][-1]), 0)
            self.assertIn('render_capture: ', lines['nobody_moves', method][0])
            self.assertIn(('mean', method), lines)
        self.assertEqual(len(self.rows(self.folder / 'out/table.html')), 6)
        self.assertEqual(list((self.folder / 'out').rglob('*.bag')), [])

    def test_2_only_a_changed_method_is_done_again(self):
        kept = self.folder / 'out/results/wave--default.json'
        changed = self.folder / 'out/results/wave--coarse.json'
        before = kept.stat().st_mtime_ns, changed.stat().st_mtime_ns
        (self.folder / 'small.yaml').write_text(SUITE.replace('  nobody_moves: {motion: no_such_motion}\n', '')
                                                .replace('0.05', '0.06'))
        code, _, err = self.suite()
        self.assertEqual(code, 0, err)
        self.assertIn('1 of 2 had been done before', err)
        self.assertEqual(kept.stat().st_mtime_ns, before[0])
        self.assertNotEqual(changed.stat().st_mtime_ns, before[1])


if __name__ == '__main__':
    unittest.main(verbosity=2)

"""What the tests of workflows share: a folder, small recordings of the studio, runs of a script."""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PACKAGE = pathlib.Path(__file__).resolve().parent.parent.parent
DEVEL = pathlib.Path(os.environ['MOCAP_DEVEL'])
SMALL = ('width=200', 'height=150', 'fps=15')


class WorkflowTest(unittest.TestCase):
    """Recordings are rendered once for all cases of a class."""

    @classmethod
    def setUpClass(cls):
        cls.temporary = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.temporary.name)

    @classmethod
    def tearDownClass(cls):
        cls.temporary.cleanup()

    @staticmethod
    def program(name):
        return str(DEVEL / 'lib' / 'markerless_mocap' / name)

    @classmethod
    def render(cls, path, *options, motion='wave_and_walk', rig='ring7_overhead'):
        path.parent.mkdir(exist_ok=True)
        subprocess.run([cls.program('render_capture'), str(path), '--quiet', '--motion', motion, '--rig',
                        rig, *[part for one in SMALL + options for part in ('--set', one)]], check=True)

    @classmethod
    def start(cls, script, *words, environment=None):
        environment = {**(environment or os.environ), 'CMAKE_PREFIX_PATH': str(DEVEL)}
        return subprocess.Popen([sys.executable, str(PACKAGE / 'scripts' / script), *map(str, words)], text=True,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, env=environment, cwd=cls.folder)

    @classmethod
    def run_script(cls, script, *words, environment=None):
        process = cls.start(script, *words, environment=environment)
        out, err = process.communicate()
        return process.returncode, out, err

    @staticmethod
    def rows(page):
        """Of the first table of a page, the texts of its cells."""
        data = re.search(r'id="data">(.*?)</script>', page.read_text(), re.S).group(1)
        table = next(part for part in json.loads(data)['parts'] if part['kind'] == 'table')
        return [[cell['text'] if isinstance(cell, dict) else cell for cell in row] for row in table['rows']]

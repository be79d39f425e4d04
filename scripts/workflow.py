"""Runs a workflow of workflows/ by Snakemake: keys by content, progress, one sentence for a failure, and
pages of templates/. evaluate_suite and captures are made of this.

A step is done again if a file it needs is newer than its results. Such a file is the step's key: the
hash of all that the step depends on, written only when it changes. So the time of a recording, of a
program or of a file of options is never asked for."""
import contextlib
import fcntl
import hashlib
import json
import os
import pathlib
import signal
import subprocess
import sys
import threading
import time

PACKAGE = pathlib.Path(__file__).resolve().parent.parent


class Fault(Exception):
    """One sentence for the user."""


def find_program(name):
    prefixes = os.environ.get('CMAKE_PREFIX_PATH', '').split(':')
    for prefix in prefixes + [str(PACKAGE / 'devel')]:
        path = pathlib.Path(prefix) / 'lib' / 'markerless_mocap' / name
        if prefix and os.access(path, os.X_OK):
            return str(path.resolve())
    raise Fault(f'{name} is not built or not found: build the package and source its setup.sh')


def with_workspace():
    """Starts anew in the environment of the package's own build if no workspace is sourced."""
    setup = PACKAGE / 'devel' / 'setup.sh'
    if 'CMAKE_PREFIX_PATH' in os.environ or not setup.is_file():
        return
    os.execv('/bin/sh', ['/bin/sh', '-c', '. "$0" && exec "$@"', str(setup),
                         '/usr/bin/python3', *sys.argv])


def digest(*parts):
    text = json.dumps(parts, sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()


def file_digest(path):
    return hashlib.sha256(pathlib.Path(path).read_bytes()).hexdigest()


def write_if_changed(path, text):
    """A file whose time tells when its content changed."""
    if path.is_file() and path.read_text() == text:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    beside = path.with_name(path.name + '.new')
    beside.write_text(text)
    beside.replace(path)


def page_html(content):
    """A page of templates/, as the tools write them."""
    read = lambda name: (PACKAGE / 'templates' / name).read_text()
    data = json.dumps(content, ensure_ascii=False).replace('<', '\\u003c')
    page = read('page.html')
    for mark, text in (('style', read('page.css')), ('library', ''), ('script', read('parts.js')), ('data', data)):
        page = page.replace(f'<!--{mark}-->', text)
    return page


def clock(seconds):
    return '%d:%02d' % divmod(int(seconds), 60)


class Progress:
    """What runs now, for how long, and how long the rest may take."""

    def __init__(self):
        self.total, self.done = 0, 0
        self.running = {}  # what, begin
        self.begin = time.monotonic()
        self.terminal = sys.stderr.isatty()

    def line(self, what, seconds):
        left = ''
        if self.done:
            spent = time.monotonic() - self.begin
            left = ', about %s left' % clock(spent / self.done * (self.total - self.done))
        return f'[{self.done}/{self.total}] {what} {clock(seconds)}{left}'

    def show(self):
        if self.terminal and self.running:
            jobs = list(self.running.values())
            what = jobs[0][0] + (f' and {len(jobs) - 1} more' if len(jobs) > 1 else '')
            sys.stderr.write('\r\033[K' + self.line(what, time.monotonic() - jobs[0][1]))
            sys.stderr.flush()

    def say(self, what, seconds):
        sys.stderr.write(('\r\033[K' if self.terminal else '') + self.line(what, seconds) + '\n')


def sentence_of(logs):
    """What a program said last about why it failed: '<program>: <sentence>'."""
    for log in map(pathlib.Path, logs):
        lines = log.read_text(errors='replace').splitlines() if log.is_file() else []
        said = [line for line in lines if line.split(': ')[0].replace('_', '').isalnum() and ': ' in line]
        if lines:
            return said[-1] if said else f'{lines[-1]} ({log})'
    return 'the program was killed or could not be started' + (f', see {logs[0]}' if logs else '')


@contextlib.contextmanager
def only_run(out):
    """Two runs must not write into one folder. The lock ends with the process, however it ends."""
    with open(out / '.lock', 'w') as file:
        try:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise Fault(f'another run is writing into {out}')
        yield


def forward_interruption(process):
    """SIGTERM and SIGHUP are interruptions, too. All programs of the run get them, and end cleanly."""
    def interrupt(*_):
        raise KeyboardInterrupt
    for number in (signal.SIGTERM, signal.SIGHUP):
        if signal.getsignal(number) != signal.SIG_IGN:
            signal.signal(number, interrupt)
    signal.signal(signal.SIGINT, interrupt)
    return lambda: os.killpg(process.pid, signal.SIGINT)


def run_workflow(name, out, plan, cores, profile=None, name_step=None, ended=None):
    """Runs workflows/<name>/Snakefile in the folder `out`; a step that fails does not stop the others.

    plan: what the Snakefile reads from plan.json. profile: a folder with Snakemake's own options, such
    as workflows/slurm. name_step(rule, wildcards): what the user reads. ended(rule, wildcards): called
    after each step, returns a text to add or None. Returns {(rule, wildcards as tuple): sentence} of
    the steps that failed."""
    write_if_changed(out / 'plan.json', json.dumps(plan, indent=1))
    command = ['/usr/bin/python3', '-m', 'snakemake', '--snakefile', PACKAGE / 'workflows' / name / 'Snakefile',
               '--directory', out, '--cores', cores, '--keep-going', '--rerun-incomplete',
               '--rerun-triggers', 'mtime', '--nolock', '--scheduler', 'greedy',
               '--log-handler-script', PACKAGE / 'workflows' / 'events.py']
    if profile:
        command += ['--profile', profile]
    log = out / 'snakemake.log'
    with open(log, 'w') as file:
        process = subprocess.Popen([str(part) for part in command], stdout=subprocess.PIPE, stderr=file,
                                   text=True, start_new_session=True,
                                   # A shell's background jobs ignore it, and so would all programs.
                                   preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_DFL))
    stop = forward_interruption(process)
    progress = Progress()
    failed = {}

    def ticking():
        while process.poll() is None:
            progress.show()
            time.sleep(0.2)
    threading.Thread(target=ticking, daemon=True).start()
    try:
        for text in process.stdout:
            follow(text, progress, failed, out, name_step, ended)
        code = process.wait()
    except BaseException:
        stop()
        process.stdout.close()
        process.wait()
        raise
    if code and not failed:
        raise Fault(f'Snakemake ended with {code}: {last_line(log)}, see {log}')
    return failed


def last_line(path):
    lines = [line.strip() for line in path.read_text().splitlines() if line.strip()]
    return lines[-1] if lines else 'it said nothing'


def follow(text, progress, failed, out, name_step, ended):
    try:
        event = json.loads(text)
    except ValueError:
        return  # a line that is no event of ours
    if event['event'] == 'total':
        progress.total = event['total']
        return
    rule, wildcards = event['rule'], event['wildcards']
    what = name_step(rule, wildcards)
    if not what:  # the last rule, which only asks for all others
        return
    if event['event'] == 'begin':
        progress.running[event['job']] = (what, time.monotonic())
        return
    _, begin = progress.running.pop(event['job'], (what, time.monotonic()))
    progress.done += 1
    if event['event'] == 'fail':
        sentence = sentence_of(out / log for log in event['log'])
        failed[rule, tuple(wildcards.values())] = sentence
        progress.say(f'{what}: {sentence}', time.monotonic() - begin)
    added = ended(rule, wildcards)
    if event['event'] == 'end':
        progress.say(what + (f' {added}' if added else ''), time.monotonic() - begin)

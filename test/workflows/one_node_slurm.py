"""A Slurm of one node in a folder of its own: its keys, ports, logs and state lie there, and nothing of
it is left when it ends. Needs munged, slurmctld, slurmd and sbatch, and the rights of root."""
import contextlib
import os
import pathlib
import secrets
import shutil
import socket
import subprocess
import time

PROGRAMS = ('munged', 'slurmctld', 'slurmd', 'sbatch', 'scontrol', 'scancel')


def what_is_missing():
    """One sentence, or nothing."""
    missing = [name for name in PROGRAMS if not shutil.which(name)]
    if missing:
        return f'Slurm is missing: there is no {missing[0]} (Debian: slurmctld, slurmd, slurm-client, munge)'
    return None if os.geteuid() == 0 else 'Slurm of one node needs the rights of root'


def free_ports(number):
    with contextlib.ExitStack() as stack:
        sockets = [stack.enter_context(socket.socket()) for _ in range(number)]
        for one in sockets:
            one.bind(('127.0.0.1', 0))
        return [one.getsockname()[1] for one in sockets]


def write_configuration(folder):
    controller, node = free_ports(2)
    host = socket.gethostname()
    (folder / 'slurm.conf').write_text(f'''
ClusterName=one_node
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket
CredType=cred/munge
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
SchedulerParameters=batch_sched_delay=0
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 Port={node} CPUs={os.cpu_count()} RealMemory=8000
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
''')


@contextlib.contextmanager
def one_node_slurm(folder):
    """Yields the environment in which sbatch reaches it."""
    folder = pathlib.Path(folder).resolve()
    for name in ('state', 'spool'):
        (folder / name).mkdir(parents=True)
    folder.chmod(0o755)
    key = folder / 'munge.key'
    key.write_bytes(secrets.token_bytes(128))
    key.chmod(0o400)
    write_configuration(folder)
    environment = {**os.environ, 'SLURM_CONF': str(folder / 'slurm.conf')}
    daemons = []

    def start(*command):
        with open(folder / f'{command[0]}.out', 'w') as out:
            daemons.append(subprocess.Popen([str(word) for word in command], env=environment, stdout=out,
                                            stderr=subprocess.STDOUT))
    try:
        start('munged', '--foreground', '--force', '--key-file', key, '--socket', folder / 'munge.socket',
              '--pid-file', folder / 'munged.pid', '--seed-file', folder / 'munged.seed',
              '--log-file', folder / 'munged.log')
        wait_for(lambda: (folder / 'munge.socket').exists(), 'munged', folder)
        start('slurmctld', '-D')
        start('slurmd', '-D')
        wait_for(lambda: 'idle' in subprocess.run(['sinfo', '-h', '-o', '%T'], env=environment, text=True,
                                                  capture_output=True).stdout, 'slurmd', folder)
        yield environment
    finally:
        for daemon in reversed(daemons):
            daemon.terminate()
        for daemon in reversed(daemons):
            daemon.wait(timeout=20)


def wait_for(ready, name, folder):
    for _ in range(200):
        if ready():
            return
        time.sleep(0.1)
    logs = ''.join(f'{path.name}:\n{path.read_text()[-2000:]}\n' for path in sorted(folder.glob('*.log')))
    raise RuntimeError(f'{name} does not start\n{logs}')

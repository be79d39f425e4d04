"""What is to be done with each recording of captures: its options, its parts, and the keys of its steps."""
import hashlib
import os
import pathlib
import re

import yaml

from workflow import Fault, digest, file_digest, find_program, write_if_changed

PROGRAMS = ('import_recording', 'check_recording', 'mocap_offline', 'join_results', 'export_motion')
FORMATS = ('bvh', 'glb', 'trc', 'c3d', 'mot', 'csv')
SECTIONS = {'config': (dict, str), 'check_recording': dict, 'mocap_offline': dict, 'export_motion': dict,
            'import_recording': dict, 'formats': list, 'cut': (dict, bool), 'cores': int, 'memory_mb': int}
CUT = {'part_minutes': 10.0, 'overlap_s': 10.0, 'max_distance_mm': 5.0}
OURS = {'prepare', 'prepared', 'json', 'report', 'start', 'duration', 'threads', 'config', 'quiet', 'save-body',
        'self-calibrate', 'output', 'repeat', 'live'}  # the workflow sets them, or they make no sense in it
MEMORY_MB = 1500  # of one step; docs/many_recordings.md
WHOLE_BYTES = 64 << 20  # files up to here are hashed whole
END_BYTES = 1 << 20
IMAGES = ('sensor_msgs/Image', 'sensor_msgs/CompressedImage')


def load_options(path):
    if path is None:
        return {}
    try:
        options = yaml.safe_load(path.read_text()) or {}
    except OSError:
        raise Fault(f'cannot read the options {path}')
    except yaml.YAMLError as error:
        raise Fault(f'{path} is no YAML: {" ".join(str(error).split())}')
    if not isinstance(options, dict):
        raise Fault(f'{path} must be a map of options')
    own = options.get('recordings', {})
    if not isinstance(own, dict):
        raise Fault(f'{path}: recordings must be a map by name')
    check_sections({key: value for key, value in options.items() if key != 'recordings'}, str(path))
    for name, sections in own.items():
        check_sections(sections, f'{path}: recordings/{name}')
    return options


def check_sections(sections, where):
    if not isinstance(sections, dict):
        raise Fault(f'{where} must be a map of options')
    for key, value in sections.items():
        if key not in SECTIONS:
            raise Fault(f'{where}: there is no option {key}, allowed are {", ".join(SECTIONS)}')
        if not isinstance(value, SECTIONS[key]) or (isinstance(value, bool) and value and key == 'cut'):
            raise Fault(f'{where}: {key} has a value of the wrong kind')
    for wrong in set(sections.get('formats', [])) - set(FORMATS):
        raise Fault(f'{where}: there is no format {wrong}, allowed are {", ".join(FORMATS)}')
    cut = sections.get('cut') or {}
    for key, value in cut.items():
        if key not in CUT or not isinstance(value, (int, float)) or value <= 0:
            raise Fault(f'{where}: cut has {", ".join(CUT)}, each a positive number')
    for program in ('check_recording', 'mocap_offline', 'export_motion'):
        for key in set(sections.get(program, {})) & OURS:
            raise Fault(f'{where}: {program}/{key} cannot be given here')
    for key in ('cores', 'memory_mb'):
        if sections.get(key, 1) < 1:
            raise Fault(f'{where}: {key} must be positive')


def options_of(options, name):
    """The options of one recording: those of all, and its own over them."""
    merged = {key: value for key, value in options.items() if key != 'recordings'}
    for key, value in options.get('recordings', {}).get(name, {}).items():
        both = isinstance(value, dict) and isinstance(merged.get(key), dict)
        merged[key] = {**merged[key], **value} if both else value
    return merged


class Words:
    """Arguments of a program from a map of its options. Files are found beside the file of options, and
    their contents belong to what the result depends on."""

    def __init__(self, folder):
        self.folder, self.files = folder, {}

    def of(self, options):
        words = []
        for key, value in options.items():
            values = value if isinstance(value, list) else [value]
            if value is True:
                words.append(f'--{key}')
            elif value is not False:
                words += [f'--{key}', *(self.word(one) for one in values)]
        return words

    def word(self, value):
        path = self.folder / str(value)
        if not isinstance(value, str) or not path.exists():
            return str(value)
        self.files[str(path.resolve())] = recording_digest(path)
        return str(path.resolve())


def recording_digest(path):
    """A file's hash; a large one's size, time, beginning and end stand for it. The end of a bag holds its
    index: all topics, and where and when each piece was written. A folder: all of its files."""
    if path.is_dir():
        files = sorted(one for one in path.rglob('*') if one.is_file())
        return digest([[str(one.relative_to(path)), recording_digest(one)] for one in files])
    with open(path, 'rb') as file:
        status = os.fstat(file.fileno())
        if status.st_size <= WHOLE_BYTES:
            return hashlib.sha256(file.read()).hexdigest()
        ends = file.read(END_BYTES)
        file.seek(-END_BYTES, os.SEEK_END)
        return digest(status.st_size, status.st_mtime_ns, hashlib.sha256(ends + file.read()).hexdigest())


def find_recordings(arguments, imports, out):
    """Paths by name. A folder is a recording itself if it is imported and has no bags."""
    found = {}

    def add(path):
        name = re.sub(r'[^A-Za-z0-9_.-]', '_', path.stem if path.is_file() else path.name)
        if found.setdefault(name, path) != path:
            raise Fault(f'{path} and {found[name]} would have the same name {name}')

    def add_argument(argument, listed=False):
        path = pathlib.Path(argument)
        if path.suffix == '.txt' and path.is_file() and not listed:
            for line in filter(None, map(str.strip, path.read_text().splitlines())):
                add_argument(path.parent / line, True)
        elif path.is_dir():
            bags = sorted(path.glob('*.bag'))
            folders = sorted(one for one in path.iterdir() if one.is_dir() and one.resolve() != out.resolve())
            for one in bags + (folders if imports else []):
                add(one.resolve())
            if not bags and not (imports and folders):
                raise Fault(f'the folder {path} has no bag' +
                            ('' if imports else ', and no option import_recording says how to read videos'))
        elif path.is_file():
            add(path.resolve())
        else:
            raise Fault(f'there is no recording {path}')
    for argument in arguments:
        add_argument(argument)
    return found


def seconds_of(path):
    """Length of the images of a bag, from its index; 0 if it cannot be read."""
    import rosbag
    try:
        with rosbag.Bag(str(path), skip_index=True) as bag:
            images = {key for key, one in bag._connections.items() if one.datatype in IMAGES}
            chunks = [one for one in bag._chunks if images & set(one.connection_counts)]
    except Exception:  # of rosbag, of what a damaged file holds: mocap_offline will say it better
        return 0.0
    if not chunks:
        return 0.0
    return max(c.end_time.to_sec() for c in chunks) - min(c.start_time.to_sec() for c in chunks)


def parts_of(seconds, cut):
    """Start and duration of each part, s; the last one has no duration. Empty: it is not cut."""
    cut = {**CUT, **(cut or {})}
    number = round(seconds / (60 * cut['part_minutes']))
    if number < 2:
        return []
    length = seconds / number
    if length < 3 * cut['overlap_s']:
        raise Fault(f'cut: parts of {length:.0f} s are too short for an overlap of {cut["overlap_s"]:g} s; '
                    'they must be three times as long')
    starts = [max(0.0, i * length - cut['overlap_s']) if i else 0.0 for i in range(number)]
    ends = [(i + 1) * length + 0.5 for i in range(number - 1)]  # images of one time may come later
    return [[s, e - s] for s, e in zip(starts, ends)] + [[starts[-1], None]]


class Plan:
    """What the workflow must know of each recording; makes configurations and keys in the folder `out`.

    recordings: paths by name. options: of load_options(). folder: where files named in them are found."""

    def __init__(self, recordings, options, folder, out):
        self.out, self.folder, self.options = out, folder, options
        self.programs = {name: find_program(name) for name in PROGRAMS}
        self.digests = {name: file_digest(path) for name, path in self.programs.items()}
        self.content = {'programs': self.programs,
                        'recordings': {name: self.planned(name, path) for name, path in recordings.items()}}

    def planned(self, name, path):
        """What the workflow must know of one recording; writes its keys."""
        options = options_of(self.options, name)
        cut = options.get('cut', {})
        words = {program: Words(self.folder) for program in PROGRAMS}
        of = lambda program: words[program].of(options.get(program, {}))
        one = {'path': str(path), 'formats': options.get('formats', ['bvh', 'csv']),
               'cores': options.get('cores', min(2, os.cpu_count())),
               'memory_mb': options.get('memory_mb', MEMORY_MB),
               'overlap': {**CUT, **(cut or {})}['overlap_s'],
               'max_distance_mm': {**CUT, **(cut or {})}['max_distance_mm'], 'parts': []}
        config = self.write_config(name, options.get('config', {}))
        one['check'] = ['--config', config, *of('check_recording')]
        one['follow'] = ['--config', config, *of('mocap_offline')]
        one['export'] = of('export_motion')
        if path.is_dir():
            one['import'] = self.import_words(options, words['import_recording'], name, path)
        elif cut is not False:
            one['parts'] = parts_of(seconds_of(path), cut)
        self.write_keys(name, one, [recording_digest(path), file_digest(config)],
                        {program: one.files for program, one in words.items()})
        return one

    def write_config(self, name, config):
        if isinstance(config, str):
            try:
                config = yaml.safe_load((self.folder / config).read_text())
            except (OSError, yaml.YAMLError):
                raise Fault(f'cannot read the configuration {self.folder / config}')
        path = (self.out / name / 'config.yaml').resolve()
        write_if_changed(path, yaml.safe_dump(config or {}))
        return str(path)

    @staticmethod
    def import_words(options, words, name, path):
        kinds = options.get('import_recording', {})
        if len(kinds) != 1 or not isinstance(next(iter(kinds.values())), dict):
            raise Fault(f'{name}: import_recording must have one of films, videos and matrices, a map of options')
        kind, arguments = next(iter(kinds.items()))
        folder = [str(path)]
        if kind == 'matrices':  # its options are patterns of files in the folder
            folder = []
            arguments = {key: str(path / value) if key in ('matrices', 'images', 'masks') else value
                         for key, value in arguments.items()}
        return [kind, f'{name}/recording.bag', *folder, *words.of(arguments), '--quiet']

    def write_keys(self, name, one, known, files):
        """known: of recording and configuration. files: contents of files by the program that reads them."""
        imported = [known, one.get('import'), files['import_recording'], self.digests['import_recording']]
        keys = {'import': imported,
                'check': [imported, one['check'], files['check_recording'], self.digests['check_recording']],
                'follow': [imported, one['follow'], one['parts'], one['max_distance_mm'], files['mocap_offline'],
                           self.digests['mocap_offline'], self.digests['join_results']],
                'export': [one['export'], files['export_motion'], self.digests['export_motion']]}
        for step, parts in keys.items():
            write_if_changed(self.out / '.keys' / f'{name}.{step}', digest(parts))

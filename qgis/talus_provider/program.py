"""Finds and runs the program `talus`."""

import codecs
import functools
import json
import os
import pty
import re
import selectors
import shutil
import signal
import subprocess
from pathlib import Path

from qgis.core import QgsProcessingException

from processing.core.ProcessingConfig import ProcessingConfig

SETTING = "TALUS_PROGRAM"
SETTING_PLACE = "Settings > Options > Processing > Providers > Talus"
INSTALLED_IN = ("share", "qgis", "python", "plugins")
PLUGIN = Path(__file__).resolve().parent

DONE, STOPPED = 0, 3  # exit codes; others are errors
PROGRESS = re.compile(r"(\d+) of (\d+) rocks \(\d+ %\)")
PAINT = re.compile(r"\x1b\[[0-9;]*[A-Za-z]")


def is_program(path):
    return os.path.isfile(path) and os.access(path, os.X_OK)


def places():
    """Where the program may be without being on the PATH: beside the plugin or in an archive unpacked there, in the
    prefix into which both were installed, and where packages, users and archives put it."""
    home = Path.home()
    beside = (PLUGIN, PLUGIN / "bin", *archives(PLUGIN), PLUGIN.parent, *archives(PLUGIN.parent))
    installed = [PLUGIN.parents[3].parent / "bin"] if PLUGIN.parts[-5:-1] == INSTALLED_IN else []
    usual = (Path("/usr/local/bin"), Path("/usr/bin"), home / ".local/bin", home / "talus/bin", *archives(home))
    return list(dict.fromkeys([*beside, *installed, *usual]))


def archives(folder):
    """The folders of the program in archives that were unpacked in a folder."""
    return sorted(folder.glob("talus-*/bin"), reverse=True)


def find():
    """The path of the program; raises OSError with where it was sought."""
    chosen = ProcessingConfig.getSetting(SETTING)
    if chosen:
        if not is_program(chosen):
            raise OSError(f"{chosen} is no program, but {SETTING_PLACE} names it. Correct it or leave it empty.")
        return chosen
    on_path = shutil.which("talus")
    if on_path:
        return on_path
    for place in places():
        if is_program(place / "talus"):
            return str(place / "talus")
    raise OSError(
        f"The program talus was not found on the PATH ({os.environ.get('PATH', '')}), nor in "
        f"{', '.join(map(str, places()))}. Install it, with apt install ./talus_*.deb, or unpack its archive in "
        f"{PLUGIN.parent}; or give its place in {SETTING_PLACE}."
    )


def found():
    """The path of the program, for an algorithm that needs it."""
    try:
        return find()
    except OSError as error:
        raise QgsProcessingException(str(error)) from None


def schema():
    """The declaration of all settings; raises OSError or ValueError if the program does not print it."""
    path = find()
    return schema_of(path, os.stat(path).st_mtime_ns)


@functools.lru_cache(maxsize=1)
def schema_of(path, _changed):
    printed = subprocess.run([path, "schema"], capture_output=True, text=True, timeout=60)
    if printed.returncode != DONE:
        raise OSError(f"{path} printed no declaration of its settings: {printed.stderr.strip()}")
    return json.loads(printed.stdout)


def ask(arguments):
    """Runs the program to its end and returns what it prints; its errors become those of the algorithm."""
    path = found()
    try:
        answer = subprocess.run([path, *arguments], capture_output=True, text=True)
    except OSError as error:  # such as a line with more corners than fit on a command line
        raise QgsProcessingException(f"{path} could not be run: {error.strerror}") from None
    if answer.returncode != DONE:
        raise QgsProcessingException(answer.stderr.strip() or f"talus ended with code {answer.returncode}")
    return answer.stdout


def run(arguments, feedback):
    """Runs the program and returns DONE or STOPPED. Cancel interrupts it, so that it keeps what is done. Its standard
    error is a terminal of ours, because on a terminal it reports its progress ten times a second."""
    path = found()
    feedback.pushCommandInfo(" ".join([path, *arguments]))
    ours, its = pty.openpty()
    process = subprocess.Popen([path, *arguments], stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=its)
    os.close(its)
    errors = []
    try:
        with selectors.DefaultSelector() as selector:
            selector.register(process.stdout, selectors.EVENT_READ, Lines(feedback.pushInfo))
            selector.register(ours, selectors.EVENT_READ, Lines(lambda line: on_error_line(line, errors, feedback)))
            interrupted = False
            while selector.get_map():
                if feedback.isCanceled() and not interrupted:
                    process.send_signal(signal.SIGINT)
                    interrupted = True
                for key, _ in selector.select(timeout=0.1):
                    if not key.data.read(key.fd):
                        selector.unregister(key.fileobj)
    finally:
        if process.poll() is None and not feedback.isCanceled():  # left by an exception
            process.send_signal(signal.SIGINT)
        process.communicate()
        os.close(ours)
    code = process.returncode
    if code not in (DONE, STOPPED):
        raise QgsProcessingException("\n".join(errors) or f"talus ended with code {code}")
    for line in errors:
        feedback.pushWarning(line)
    return code


def on_error_line(line, errors, feedback):
    progress = PROGRESS.search(line)
    if progress:
        feedback.setProgress(100 * int(progress[1]) / int(progress[2]))
    else:
        errors.append(line)


class Lines:
    """Divides what is read into lines, without what paints a terminal."""

    def __init__(self, take):
        self.take = take
        self.rest = ""
        self.decoder = codecs.getincrementaldecoder("utf-8")("replace")

    def read(self, descriptor):
        try:
            read = os.read(descriptor, 65536)
        except OSError:  # EIO: the terminal was closed on the other side
            read = b""
        *lines, self.rest = re.split(r"[\r\n]", self.rest + self.decoder.decode(read, final=not read))
        if not read:
            lines.append(self.rest)
        for line in lines:
            bare = PAINT.sub("", line).rstrip()
            if bare:
                self.take(bare)
        return bool(read)

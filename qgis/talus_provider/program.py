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

from qgis.core import QgsProcessingException

from processing.core.ProcessingConfig import ProcessingConfig

SETTING = "TALUS_PROGRAM"
MISSING = (
    "The program talus was not found. Install Talus, or give its place in Settings > Options > Processing > "
    "Providers > Talus."
)

DONE, STOPPED = 0, 3  # exit codes; others are errors
PROGRESS = re.compile(r"(\d+) of (\d+) rocks \(\d+ %\)")
PAINT = re.compile(r"\x1b\[[0-9;]*[A-Za-z]")


def find():
    """The path of the program, or None."""
    chosen = ProcessingConfig.getSetting(SETTING)
    return chosen if chosen else shutil.which("talus")


def schema():
    """The declaration of all settings; raises OSError or ValueError if the program does not print it."""
    path = find()
    if path is None:
        raise OSError(MISSING)
    return schema_of(path, os.stat(path).st_mtime_ns)


@functools.lru_cache(maxsize=1)
def schema_of(path, _changed):
    printed = subprocess.run([path, "schema"], capture_output=True, text=True, timeout=60)
    if printed.returncode != DONE:
        raise OSError(f"{path} printed no declaration of its settings: {printed.stderr.strip()}")
    return json.loads(printed.stdout)


def ask(arguments):
    """Runs the program to its end and returns what it prints; its errors become those of the algorithm."""
    path = find()
    if path is None:
        raise QgsProcessingException(MISSING)
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
    path = find()
    if path is None:
        raise QgsProcessingException(MISSING)
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

# SPDX-License-Identifier: BSD-3-Clause
"""Work in a child process that may be stopped or die at any moment without leaving half a result behind."""
import os
import shutil
import signal
import sys
import time

STOPPED = 130
GRACE = 5.0
SCRATCH = ".unfinished-"


def guarded(work, output):
    """Run work(tell) in a child, which calls tell(stage) as it goes; ends this process with the child's exit code.

    Python handles signals only between its own steps, and a stage may take minutes: so a parent waits here, passes
    Ctrl-C on, gives the child a few seconds to stop by itself, and clears away what it leaves.
    """
    listen, speak = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(listen)
        code = 1
        try:
            work(lambda stage: os.write(speak, stage.encode() + b"\n"))
            code = 0
        except SystemExit as end:
            code = end.code if isinstance(end.code, int) else 1
        except BaseException as error:  # noqa: B902 (a fault of ours must not look like a success)
            with open(2, "w", closefd=False) as terminal:
                print(f"image_to_mesh: error: a fault of this program: {type(error).__name__}: {error}", file=terminal)
        finally:
            sys.stdout.flush()
            os._exit(code)  # without VTK's own end, which may take long
    os.close(speak)
    sys.exit(wait(child, listen, output))


def wait(child, listen, output):
    asked = []

    def stop(number, _):
        asked.append(time.monotonic())
        try:
            os.kill(child, signal.SIGINT if len(asked) == 1 else signal.SIGKILL)
        except ProcessLookupError:
            pass
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, stop)
    while True:
        done, status = os.waitpid(child, os.WNOHANG)
        if done:
            break
        if asked and time.monotonic() - asked[0] > GRACE:
            os.kill(child, signal.SIGKILL)
        time.sleep(0.05)
    if os.path.isdir(output):
        for name in os.listdir(output):
            if name.startswith(f"{SCRATCH}{child}-"):
                shutil.rmtree(os.path.join(output, name), ignore_errors=True)
    if os.WIFEXITED(status):
        return os.WEXITSTATUS(status)
    stages = os.read(listen, 1 << 16).decode().split("\n")
    stage = stages[-2] if len(stages) > 1 else "start"
    what = "stopped on request" if asked else f"ended by signal {os.WTERMSIG(status)}" + (
        " (out of memory? use a coarser image or a larger --min-size)" if os.WTERMSIG(status) == signal.SIGKILL else "")
    print(f"image_to_mesh: error: {stage}: {what}; nothing was written", file=sys.stderr, flush=True)
    return STOPPED if asked else 1

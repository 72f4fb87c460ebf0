"""Work for processes: functions that a worker can load."""

import os
import signal
import time


def double(task):
    """Twice the task, the later tasks sooner."""
    time.sleep(0.05 if task % 2 else 0.0)
    return 2 * task


def double_or_die(task):
    """Twice the task; 3 kills the process, as a system out of memory does."""
    if task == 3:
        os.kill(os.getpid(), signal.SIGKILL)
    return 2 * task


def process(task):
    """The process that does it."""
    time.sleep(0.02)
    return os.getpid()


def sleep(task):
    """Sleeps for so many seconds."""
    time.sleep(task)
    return task

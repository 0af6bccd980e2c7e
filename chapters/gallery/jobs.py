"""jobs.py - what draws pictures: runs programs beside each other, as many as there are processors, and says how far it is."""
import os
import signal
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor, as_completed

_running = set()


def wanted(variable, by_default, allowed):
    """The words of a variable in the environment, with commas between, which may be these."""
    words = (os.environ.get(variable) or by_default).replace(",", " ").split()
    for word in words or ["nothing"]:
        if word not in allowed:
            print(f"{variable}={word}: expected {', '.join(allowed)}", file=sys.stderr)
            sys.exit(2)
    return words


def is_newer(path, *others):
    return path.exists() and all(other.exists() and path.stat().st_mtime_ns > other.stat().st_mtime_ns for other in others)


def end_with_programs():
    """From now on a signal to end also ends what has been started. SystemExit is raised, so that 'with' tidies up."""
    def end(*_):
        for process in list(_running):
            process.terminate()
        sys.exit(1)
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, end)


def run(command, folder=None):
    """Runs a program: its exit status, and all that it printed, in bytes."""
    with subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT) as process:
        _running.add(process)
        said = process.communicate()[0]
        _running.discard(process)
    return process.returncode, said


def beside_each_other(what, work, jobs, count=lambda job: 1):
    """Calls work(job) for each job, and yields (job, result) as soon as there is one. On a terminal a line about
    'what' shows the progress after a second; a log gets a line after two seconds, and then one every ten. A job counts
    as 'count(job)' of what is done."""
    began, said = time.monotonic(), None
    terminal = sys.stderr.isatty()
    pool = ThreadPoolExecutor(os.cpu_count())
    try:
        futures = {pool.submit(work, job): job for job in jobs}
        total, done = sum(map(count, jobs)), 0
        for future in as_completed(futures):
            done += count(futures[future])
            yield futures[future], future.result()
            now = time.monotonic() - began
            first, then = (1, 0.5) if terminal else (2, 10)
            if now >= first if said is None else now - said >= then:
                said = now
                line = f"  {what:9} {100 * done // total} % ({done} of {total}), " \
                       f"about {duration(now * (total - done) / done)} left"
                print(f"\r{line}\033[K" if terminal else line, end="" if terminal else "\n", file=sys.stderr, flush=True)
    finally:
        pool.shutdown(cancel_futures=True)
        if terminal and said is not None:
            print("\r\033[K", end="", file=sys.stderr, flush=True)


def duration(seconds):
    """In words: 34 ms, 5.6 s, 3 min 20 s, 2 h 5 min."""
    if seconds < 59.95:
        return f"{seconds:.3g} s" if seconds >= 0.9995 else f"{1000 * seconds:.3g} ms"
    hours = seconds >= 3599.5
    large, rest = divmod(round(seconds / 60) if hours else round(seconds), 60)
    return f"{large} {'h' if hours else 'min'}" + (f" {rest} {'min' if hours else 's'}" if rest else "")

"""run_tests.py - runs test programs, as many at a time as there are processors, and adds up what they say.

    run_tests.py LOG-FOLDER PROGRAM...

A program may be followed by an argument, after a blank: 'build/tests/matrix 05-quadratic'; or it is a transcript, a
.txt (transcript.py). T=word in the environment: only those with a name, or the name of a test in them, that has it.

The last line of a test is 'NAME: N passed, N failed'. A test that ends without it, or exits non-zero though nothing
failed, counts as one failure, and all that it printed is shown. Of a test that passes some lines are shown: '+ words';
'+ N things' as a sum over all tests, at the end; and 'skipped: what, and why', also at the end. LOG-FOLDER keeps
everything, and in 'seconds' the seconds that each test took: of a processor, which is nearly the same on a busy
machine, and by the clock.

Scripts (.sh) may build in the tree, so they take turns. All else runs beside them, and so do scripts that say in a line
of their own '# Only reads the tree.' or '# Builds only below its answers.': the build of a folder of answers that
nobody else has. Those that took longest in the last run begin first: at the end no processor waits.
"""
import os
import re
import signal
import sys
import tempfile
import time
from pathlib import Path

WORTH_TELLING = 20  # seconds
TRANSCRIPT = "python3 -B tests/house/runner/transcript.py "
TEST_NAME = re.compile(r"^(?:TEST(?:_LINE)?\(|\s*check ['\"]|\$ ).*", re.MULTILINE)
BESIDE_OTHERS = re.compile(rb"^# (Only reads the tree|Builds only below its answers)\.$", re.MULTILINE)


class Test:
    def __init__(self, program, seconds):
        self.program = program
        file = program.split(" ")[0]
        script = file.endswith(".sh")
        self.takes_turns = script and not BESIDE_OTHERS.search(Path(file).read_bytes())
        self.expected = seconds.get(program, (10 if script else 1, 0))[0]
        self.command = TRANSCRIPT + program if program.endswith(".txt") else program
        # Its output goes into a file without a name: nothing in the tree changes while tests run.
        self.log = tempfile.TemporaryFile()

    def has(self, word):
        """In its name, or in the name of a test, in which blanks and underscores are the same."""
        last = self.program.split(" ")[-1]
        sources = [Path(name) for name in (last, f"{last.removeprefix('build/')}.c", f"tests/{last}.c")
                   if name.endswith((".c", ".sh", ".txt"))]
        names = [self.program] + [name for source in sources if source.is_file()
                                  for name in TEST_NAME.findall(source.read_text("utf-8"))]
        return any(word in name or word.replace("_", " ") in name.replace("_", " ") for name in names)

    def begin(self):
        """In a process group of its own, which ends as a whole."""
        self.began = time.monotonic()
        # Check's own limit, 4 s by the clock, is too short for a busy machine.
        environment = os.environ if self.program.endswith(".sh") else {**os.environ, "CK_DEFAULT_TIMEOUT": "60"}
        self.process = os.posix_spawn("/bin/sh", ["sh", "-c", 'exec "$@"', "sh", *self.command.split(" ")], environment,
                                      file_actions=[(os.POSIX_SPAWN_DUP2, self.log.fileno(), to) for to in (1, 2)],
                                      setpgroup=0)

    def end(self, status, used):
        self.seconds, self.of_processor = time.monotonic() - self.began, used.ru_utime + used.ru_stime
        self.log.seek(0)
        self.said = self.log.read()
        self.lines = self.said.decode("utf-8", "replace").splitlines()
        last = self.lines[-1] if self.lines else ""
        found = re.search(r": (\d+) passed, (\d+) failed$", last)
        self.passed, self.failed = map(int, found.groups()) if found else (0, 1)
        if found and (status == 0 or self.failed):
            self.sum = last
        else:
            self.passed, self.failed = 0, 1
            self.sum = f"{self.program}: ended " + (f"with exit status {status}" if status >= 0 else f"by signal {-status}")


def run_all(tests):
    """Yields each test that has ended. Those that take turns begin first, because they take longest together."""
    waiting, running = list(tests), {}

    def end_all(number, _):
        for process in running:
            os.killpg(process, signal.SIGTERM)
        os._exit(128 + number)
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, end_all)
    while waiting or running:
        while waiting and len(running) < max(2, os.cpu_count()):
            turn_is_taken = any(test.takes_turns for test in running.values())
            ready = [test for test in waiting if not (test.takes_turns and turn_is_taken)]
            if not ready:
                break
            test = max(ready, key=lambda test: (test.takes_turns, test.expected))
            waiting.remove(test)
            test.begin()
            running[test.process] = test
        process, status, used = os.wait4(-1, 0)
        if process in running:
            test = running.pop(process)
            test.end(os.waitstatus_to_exitcode(status), used)
            yield test


def show(test, sums, skipped):
    """Prints what matters of a test that has ended; adds to the sums, a number for each wording, and to what was
    skipped."""
    for line in test.lines:
        counted = re.match(r"\+ (\d+) (.*)", line)
        if line.startswith("skipped:"):
            skipped[line.removeprefix("skipped:").strip()] = True
        elif counted:
            sums[counted[2]] = sums.get(counted[2], 0) + int(counted[1])
        elif line.startswith("+ "):
            print(line[2:])
    if test.failed:
        print("".join(f"    {line}\n" for line in [*test.lines, f"again: {test.command}"]), end="")
    print(test.sum + (f"   ({test.seconds:.0f} s)" if test.seconds >= WORTH_TELLING else ""), flush=True)


def main():
    folder, *programs = sys.argv[1:]
    folder = Path(folder)
    folder.mkdir(exist_ok=True)
    kept = folder / "seconds"
    seconds = {}
    for line in kept.read_text(encoding="utf-8").splitlines() if kept.exists() else []:
        of_processor, by_clock, program = line.split(" ", 2)
        seconds[program] = float(of_processor), int(by_clock)
    tests = [Test(program, seconds) for program in programs]
    tests = [test for test in tests if test.has(os.environ.get("T", ""))]
    sums, skipped = {}, {}
    terminal = sys.stderr.isatty()
    for ended, test in enumerate(run_all(tests), 1):
        if terminal:
            print("\r\033[K", end="", file=sys.stderr)
        show(test, sums, skipped)
        if terminal and ended < len(tests):
            print(f"\r  tests     {ended} of {len(tests)}\033[K", end="", file=sys.stderr, flush=True)
    for test in tests:
        (folder / re.sub("[/ ]", "_", test.program)).write_bytes(test.said)
        seconds[test.program] = test.of_processor, int(test.seconds)
    kept.write_text("".join(f"{of_processor:.2f} {by_clock} {program}\n"
                            for program, (of_processor, by_clock) in seconds.items()), encoding="utf-8")
    if sums:
        print("In all: " + ", ".join(f"{number} {words}" for words, number in sums.items()))
    if skipped:
        print("Not tested here:\n" + "".join(f"  {what}\n" for what in skipped), end="")
    passed, failed = (sum(getattr(test, which) for test in tests) for which in ("passed", "failed"))
    print(f"{passed} passed, {failed} failed")
    return 1 if failed or not passed else 0


sys.exit(main())

"""sentences.py - for the tests that are python: one sentence, one verdict; as tests/library.sh."""
passed = failed = 0


def check(sentence: str, holds, seen: object = "") -> None:
    """holds: what is asserted; seen: what was there instead."""
    global passed, failed
    if holds:
        passed += 1
    else:
        failed += 1
        print(f"not ok: {sentence}" + (f"\n    saw {str(seen)[:600]}" if seen != "" else ""))


def skip(why: str) -> None:
    print(f"skipped: {why}")


def finish(name: str) -> int:
    """The exit status; that nothing was tested is a failure, too."""
    print(f"{name}: {passed} passed, {failed} failed")
    return 1 if failed or not passed else 0

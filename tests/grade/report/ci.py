"""ci.py - junit.xml and grades.tap, for machines that show tests.

A wrong or unanswered function fails; a crash, an endless loop or a file that does not compile is an
error; a file that was not handed in is skipped. The inputs and results are in the failure,
never in <system-out>, because GitLab obeys tags that it finds there. TAP is version 13, because
Perl's 'prove' reads no newer one.
"""
import json
import re
import xml.etree.ElementTree as ElementTree

from grade.visible import number
from .points import UNSAFE, any_unsafe, clean_class, points


def comment_text(point: dict) -> str:
    return "\n".join(point["lines"]) or point["message"]


def add_case(suite: ElementTree.Element, submission: str, point: dict, used: set) -> None:
    # Readers drop a second test of one name, so the submission is in it.
    name = f"{submission}: {point['name']}"
    while name in used:
        name += " again"
    used.add(name)
    case = ElementTree.SubElement(
        suite,
        "testcase",
        {"classname": f"{submission}.{point['stem'] or 'submission'}", "name": name, "time": "0"},
    )
    if point["outcome"] == "skipped":
        ElementTree.SubElement(case, "skipped", message=point["message"])
    elif point["outcome"] != "passed":
        trouble = ElementTree.SubElement(
            case, point["outcome"], message=point["message"], type=point["state"]
        )
        trouble.text = comment_text(point)


def counts(cases: list) -> dict:
    outcomes = [point["outcome"] for point in cases]
    return {
        "tests": str(len(outcomes)),
        "failures": str(outcomes.count("failure")),
        "errors": str(outcomes.count("error")),
        "skipped": str(outcomes.count("skipped")),
    }


def junit_xml(records: list) -> bytes:
    records = clean_class(records)
    told = [points(record) for record in records]
    unsafe = any_unsafe(records)
    root = ElementTree.Element(
        "testsuites",
        {
            "name": UNSAFE if unsafe else "grades",
            **counts(sum(told, [])),
            "time": f"{sum(record['seconds'] for record in records):.3f}",
        },
    )
    used = set()
    for record, cases in zip(records, told):
        suite = ElementTree.SubElement(
            root,
            "testsuite",
            {"name": record["submission"], **counts(cases), "time": f"{record['seconds']:.3f}"},
        )
        properties = ElementTree.SubElement(suite, "properties")
        for name, value in (
            ("status", record["status"]),
            ("score", number(record["score"])),
            ("max", number(record["max"])),
            ("seed", str(record["seed"])),
            ("sandbox", UNSAFE if record["unsafe"] else record["sandbox"]),
        ):
            ElementTree.SubElement(properties, "property", name=name, value=value)
        for point in cases:
            add_case(suite, record["submission"], point, used)
    ElementTree.indent(root, " ")
    return ElementTree.tostring(root, encoding="utf-8", xml_declaration=True) + b"\n"


def tap_text(text: str) -> str:
    return text.replace("\\", "\\\\").replace("#", "\\#")


def quoted(text: str) -> str:
    """A YAML string in double quotes: JSON's is one."""
    return json.dumps(text, ensure_ascii=False)


def list_item(text: str) -> str:
    """Perl's reader takes a first word with a colon after it for a key, even in quotes."""
    return "    - " + re.sub(r"^(\S*\s*):(?=\s)", r"\1\\x3a", quoted(text))


def grades_tap(records: list) -> str:
    records = clean_class(records)
    told = [(record, point) for record in records for point in points(record)]
    lines = ["TAP version 13", f"1..{len(told)}"]
    if any_unsafe(records):
        lines.append(f"# {UNSAFE}")
    for place, (record, point) in enumerate(told, 1):
        well = point["outcome"] in ("passed", "skipped")
        line = f"{'ok' if well else 'not ok'} {place} - " + tap_text(
            f"{record['submission']}: {point['name']}"
        )
        if point["outcome"] == "skipped":
            line += " # SKIP " + tap_text(point["message"])
        lines.append(line)
        if not well:
            lines += [
                "  ---",
                f"  message: {quoted(point['message'])}",
                f"  severity: {'fail' if point['outcome'] == 'failure' else 'error'}",
                "  comment:",
            ]
            lines += [list_item(line) for line in comment_text(point).split("\n")]
            lines.append("  ...")
    return "\n".join(lines) + "\n"

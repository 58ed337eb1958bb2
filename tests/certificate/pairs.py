# SPDX-License-Identifier: GPL-3.0-or-later
"""What the tests of certificates share: running the program and every checker; answers about many pairs, each with its proof. The
programs come in the environment; FATHOM_CHECK_PROVED, extracted from the Coq development, may be absent."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile

FATHOM = os.environ["FATHOM_EXECUTABLE"]
ROOT = pathlib.Path(os.environ["FATHOM_ROOT"])
CHECKERS = {
    "fathom-check": [os.environ["FATHOM_CHECK"]],
    "check.py": [sys.executable, "-B", str(ROOT / "verify" / "check" / "check.py")],
}
if os.path.exists(os.environ.get("FATHOM_CHECK_PROVED", "")):
    CHECKERS["fathom-check-proved"] = [os.environ["FATHOM_CHECK_PROVED"]]


def run(*arguments, stdin=""):
    done = subprocess.run(list(map(str, arguments)), input=stdin, capture_output=True, text=True, timeout=600, check=False)
    assert done.returncode == 0, f"{arguments[0]} ended with {done.returncode}: {done.stdout[-500:]}{done.stderr[-500:]}"
    return done.stdout


def families(*kind):
    """The names of all families, or of those of a kind, an option of fathom cases; in order."""
    return [line.split()[0] for line in run(FATHOM, "cases", "--list", *kind).splitlines() if line.strip()]


def family(result):
    return result["id"].rsplit("-n", 1)[0]


def is_of_two_bodies(certificate):
    """Whether it is of the kind that the proved checker does not read: verify/check/FORMAT.md, section 15."""
    return certificate.startswith("fathom-certificate 5\n") and "\nclaim solid\n" not in certificate


def accepted_answers(test, cases):
    """The answers about the cases, which all checkers accept that read their certificates."""
    lines = run(FATHOM, "depth", "--json", "--embed-certificate", "-", stdin=cases)
    results = [json.loads(line) for line in lines.splitlines()]
    test.assertEqual(len(results), len(cases.splitlines()))
    with tempfile.TemporaryDirectory() as folder:
        answers, certificates = pathlib.Path(folder, "answers.jsonl"), pathlib.Path(folder, "certificates")
        answers.write_text(lines)
        wanted = run(*CHECKERS["fathom-check"], "--results", answers).splitlines()  # compares each with its certificate, field by field
        test.assertEqual(len(wanted), len(results))
        for result, line in zip(results, wanted):
            test.assertTrue(line.startswith(f"s VERIFIED {result['status']} ") and line.endswith(" " + result["id"]), line)
        for checker, command in CHECKERS.items():
            read = [(result["certificate"], line) for result, line in zip(results, wanted)
                    if checker != "fathom-check-proved" or not is_of_two_bodies(result["certificate"])]
            certificates.write_text("".join(certificate for certificate, _ in read))
            with test.subTest(checker=checker):
                test.assertEqual(run(*command, certificates).splitlines(), [line for _, line in read])
    return results

# SPDX-License-Identifier: GPL-3.0-or-later
"""Answers about many pairs, each with its proof, for every checker."""
import json
import pathlib
import tempfile

from checkers_test import CHECKERS, FATHOM, run


def families(kind):
    """The names of all families of that kind, an option of fathom cases."""
    return {line.split()[0] for line in run(FATHOM, "cases", "--list", kind).splitlines() if line.strip()}


def family(result):
    return result["id"].rsplit("-n", 1)[0]


def accepted_answers(test, cases):
    """The answers about the cases, which all checkers accept."""
    lines = run(FATHOM, "depth", "--json", "--embed-certificate", "-", stdin=cases)
    results = [json.loads(line) for line in lines.splitlines()]
    test.assertEqual(len(results), len(cases.splitlines()))
    with tempfile.TemporaryDirectory() as folder:
        answers, certificates = pathlib.Path(folder, "answers.jsonl"), pathlib.Path(folder, "certificates")
        answers.write_text(lines)
        certificates.write_text("".join(result["certificate"] for result in results))
        wanted = run(*CHECKERS["fathom-check"], "--results", answers).splitlines()  # compares each with its certificate, field by field
        test.assertEqual(len(wanted), len(results))
        for result, line in zip(results, wanted):
            test.assertTrue(line.startswith(f"s VERIFIED {result['status']} ") and line.endswith(" " + result["id"]), line)
        for checker, command in CHECKERS.items():
            with test.subTest(checker=checker):
                test.assertEqual(run(*command, certificates).splitlines(), wanted)
    return results

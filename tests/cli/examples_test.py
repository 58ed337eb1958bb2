# SPDX-License-Identifier: GPL-3.0-or-later
"""Every example of every help page runs, on the files that ship in examples/data."""
import os
import re
import shutil
import subprocess
import unittest
import unittest.mock

from harness import EXECUTABLE, PATIENCE, ROOT, CliTest
from pages import page_names, section

# Verdicts are what certify is for: an example with one that failed has done its work.
JUDGES = re.compile(r"\bfathom certify\b(?!.*--expect-fail)")


def examples(text):
    """The lines for a shell, each with its meaning beside it or below."""
    return [line.split("  ")[1].strip() if "  " in line[2:] else line.strip() for line in section(text, "Examples")
            if re.match(r"  \S", line)]


class Examples(CliTest):
    def setUp(self):
        super().setUp()
        wide = unittest.mock.patch.dict(os.environ, COLUMNS="120")  # so that no example is broken
        wide.start()
        self.addCleanup(wide.stop)
        self.place = self.folder / "data"
        shutil.copytree(ROOT / "examples" / "data", self.place)
        programs = self.folder / "bin"
        programs.mkdir()
        (programs / "fathom").symlink_to(EXECUTABLE)
        self.environment = {**os.environ, "PATH": f"{programs}:{os.environ['PATH']}", "OMPI_ALLOW_RUN_AS_ROOT": "1",
                            "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1"}
        self.adapters = [line.split()[0] for line in self.answer("certify", "--list-adapters").splitlines() if "not built" not in line]

    def cannot_run(self, line):
        """Whether the line needs what is not everywhere: another program, or a library's adapter."""
        adapter = re.search(r"--adapter (\S+)", line)
        if adapter and adapter[1] not in self.adapters:
            return True
        if line.startswith("mpirun") and not os.path.exists(os.path.join(os.path.dirname(EXECUTABLE), "fathom-mpi")):
            return True
        words = [part.split()[0] for part in line.split(" | ")]
        return any(shutil.which(word, path=self.environment["PATH"]) is None for word in words if word not in ("eval",))

    def test_all(self):
        # In the order of the table, those of `golden` first: others read the data that they make.
        names = page_names(self)
        ran = 0
        for name in sorted(names, key=lambda name: not name.startswith("golden")):
            lines = examples(self.answer(*name.split(), "--help") if name else self.answer("--help"))
            self.assertTrue(lines, name)
            for line in lines:
                self.assertIn("fathom", line)
                if self.cannot_run(line):
                    continue
                with self.subTest(page=name, example=line):
                    done = subprocess.run(["bash", "-o", "pipefail", "-c", line], cwd=self.place, env=self.environment, timeout=PATIENCE,
                                          stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
                    self.assertIn(done.returncode, (0, 1) if JUDGES.search(line) else (0,), done.stderr.decode())
                    ran += 1
        self.assertGreater(ran, 50)

    def test_a_broken_line_still_runs(self):
        """Narrow help breaks examples behind backslashes, where no quotation is open."""
        self.environment["COLUMNS"] = "40"
        text = subprocess.run([EXECUTABLE, "depth", "--help"], env=self.environment, capture_output=True, check=True).stdout.decode()
        broken = re.findall(r"^  (fathom .* \\\n(?:      .* \\\n)*      .*)$", text, re.MULTILINE)
        self.assertIn("fathom depth --pose-b \\\n      'xyz=0,0,1.5 rpy=0,0,45deg' \\\n      a.off b.off", broken)
        for line in broken:
            done = subprocess.run(["bash", "-c", line], cwd=self.place, env=self.environment, capture_output=True)
            self.assertEqual(done.returncode, 0, line)


if __name__ == "__main__":
    unittest.main()

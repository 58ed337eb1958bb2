# SPDX-License-Identifier: GPL-3.0-or-later
"""mpirun -np N fathom golden generate: the bytes of one process; a slow rank, a failing one, a killed one."""
import os
import pathlib
import shutil
import signal
import subprocess
import time
import unittest

from golden_release import ENDS, GoldenTest
from harness import EXECUTABLE, PATIENCE, ROOT

MPIRUN = shutil.which("mpirun")
PROGRAM = pathlib.Path(EXECUTABLE).with_name("fathom-mpi")


def descendants(process):
    """Running processes below this one, as (id, name)."""
    found = []
    for path in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            head, tail = path.read_text().rsplit(")", 1)
        except OSError:
            continue  # it has ended
        number, name = head.split(" (", 1)
        found.append((int(number), int(tail.split()[1]), name))
    below = {process}
    for _ in range(4):
        below |= {number for number, parent, _ in found if parent in below}
    return [(number, name) for number, _, name in found if number in below]


@unittest.skipUnless(MPIRUN and PROGRAM.exists(), "Open MPI or Boost.MPI is not here (openmpi-bin, libopenmpi-dev, libboost-mpi-dev)")
class Mpi(GoldenTest):
    def command(self, ranks, folder, *more):
        return [MPIRUN, "--allow-run-as-root", "--oversubscribe", "-np", str(ranks), EXECUTABLE, "golden", "generate", "--level", "L0",
                "--seed", "1", "--out", str(folder), *more]

    def run_ranks(self, ranks, folder, *more):
        done = subprocess.run(self.command(ranks, folder, *more), capture_output=True, text=True, timeout=PATIENCE)
        return done.returncode, done.stdout, done.stderr

    def test_same_bytes(self):
        for ranks in (2, 4):
            folder = self.folder / str(ranks)
            code, out, err = self.run_ranks(ranks, folder)
            count = len(self.shards)
            expected = f"{folder}: {count} of {count} shards made by {ranks} processes; the release is complete\n"
            self.assertEqual((code, out), (0, expected), err)
            self.same_as_release(folder)

    def test_the_line_in_the_docs(self):
        """As it is written there, from a folder like the project's, but of the level that is quick to make."""
        page = (ROOT / "docs" / "golden.md").read_text().replace("\\\n> ", "")
        lines = [line[2:] for line in page.splitlines() if line.startswith("$ mpirun ") and "--level L1 " in line]
        self.assertEqual(len(lines), 1)
        self.assertIn("--level L1 --seed 1 --out golden", lines[0])
        (self.folder / "build").mkdir()
        (self.folder / "build" / "release").symlink_to(pathlib.Path(EXECUTABLE).parent)
        done = subprocess.run(lines[0].replace("--level L1", "--level L0"), shell=True, cwd=self.folder, capture_output=True, text=True,
                              timeout=PATIENCE)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("made by 4 processes; the release is complete", done.stdout)
        self.same_as_release(self.folder / "golden")

    def test_goes_on(self):
        folder = self.folder / "part"
        self.assertEqual(self.generate(folder, "--shard", f"1/{len(self.shards)}")[0], 0)
        code, out, err = self.run_ranks(2, folder)
        self.assertEqual(code, 0, err)
        self.assertIn(f"{len(self.shards) - 1} of {len(self.shards)} shards made by 2 processes", out)
        self.same_as_release(folder)

    def with_rank(self, folder, action):
        """Starts three ranks, calls action with the id of one of them; the exit code, None if none was seen."""
        with subprocess.Popen(self.command(3, folder, "--jobs", "1"), stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            ours = []
            while process.poll() is None and len(ours) < 3:
                ours = [number for number, name in descendants(process.pid) if name.startswith("fathom-golden")]
            time.sleep(0.3)
            if len(ours) == 3 and process.poll() is None:
                action(max(ours))
            process.communicate(timeout=PATIENCE)
            return process.returncode

    def test_slow_rank(self):
        def hold(number):
            try:
                os.kill(number, signal.SIGSTOP)
                time.sleep(2)
                os.kill(number, signal.SIGCONT)
            except ProcessLookupError:
                pass  # it was faster

        folder = self.folder / "slow"
        self.assertEqual(self.with_rank(folder, hold), 0)
        self.same_as_release(folder)

    def test_killed_rank(self):
        """The run ends, and the next one completes it."""
        def kill(number):
            try:
                os.kill(number, signal.SIGKILL)
            except ProcessLookupError:
                pass

        folder = self.folder / "killed"
        self.with_rank(folder, kill)
        code, _, err = self.run_ranks(2, folder)
        self.assertEqual(code, 0, err)
        self.same_as_release(folder)

    def test_failing_rank(self):
        """A shard that cannot be written, by whichever rank it comes to: the run ends with its reason, and what is whole is kept."""
        folder = self.folder / "failing"
        obstacle = folder / (self.shards[-1] + ENDS[1])
        obstacle.mkdir(parents=True)
        code, out, err = self.run_ranks(3, folder)
        self.assertEqual((code, out), (3, ""))
        self.assertIn(f"cannot write {obstacle}: Is a directory", err)
        obstacle.rmdir()
        self.assertEqual(self.run_ranks(2, folder)[0], 0)
        self.same_as_release(folder)

    def test_folder_of_others(self):
        folder = self.folder / "mine"
        folder.mkdir()
        (folder / "letter.txt").write_text("dear")
        code, out, err = self.run_ranks(2, folder)
        self.assertEqual((code, out), (2, ""))
        self.assertEqual(err.count("holds 'letter.txt'"), 1)

    def test_one_process_needs_no_mpi(self):
        folder = self.folder / "one"
        self.assertEqual(self.run_ranks(1, folder)[0], 0)
        self.same_as_release(folder)


@unittest.skipUnless(MPIRUN and PROGRAM.exists(), "Open MPI or Boost.MPI is not here (openmpi-bin, libopenmpi-dev, libboost-mpi-dev)")
class Shapes(GoldenTest):
    LEVEL = "P0"

    def test_same_bytes(self):
        folder = self.folder / "shapes"
        done = subprocess.run([MPIRUN, "--allow-run-as-root", "--oversubscribe", "-np", "2", EXECUTABLE, "golden", "generate", "--level",
                               "P0", "--seed", "1", "--out", folder], capture_output=True, text=True, timeout=PATIENCE)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.same_as_release(folder)


class Absent(GoldenTest):
    def test_without_the_program(self):
        lonely = self.folder / "fathom"
        shutil.copy(EXECUTABLE, lonely)
        done = subprocess.run([lonely, "golden", "generate", "--level", "L0", "--out", self.folder / "out"], capture_output=True, text=True,
                              env={**os.environ, "OMPI_COMM_WORLD_SIZE": "2", "PATH": "/nowhere"})
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("fathom-mpi is not here", done.stderr)


if __name__ == "__main__":
    unittest.main()

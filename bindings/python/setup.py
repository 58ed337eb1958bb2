# SPDX-License-Identifier: GPL-3.0-or-later
"""pip install --no-build-isolation ./bindings/python    builds the Python module by CMake, in build/python.

It needs what fathom needs (cmake/packages.txt, depth and build), and Debian's pybind11-dev, python3-dev and python3-numpy.
FATHOM_BUILD=FOLDER takes the module from a build folder that has been configured, as the Debian package does."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parents[2]
CONFIGURED = os.environ.get("FATHOM_BUILD")
BUILD = pathlib.Path(CONFIGURED or ROOT / "build" / "python")


class CMakeBuild(build_ext):
    def build_extension(self, ext):
        if not CONFIGURED:
            # By the preset of ./fathom and ./check, in a folder as deep as theirs: ccache knows what they compiled.
            subprocess.run(["cmake", "--preset", "release", "-S", ROOT, "-B", BUILD, "-DFATHOM_TESTS=OFF", "-DFATHOM_PYTHON=ON",
                            f"-DPython_EXECUTABLE={sys.executable}"], check=True)
        subprocess.run(["cmake", "--build", BUILD, "--target", "fathom_python", "-j", "2"], check=True)
        [built] = (BUILD / "python" / "fathom").glob("_fathom.*.so")
        target = pathlib.Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(built, target)


version = re.search(r"project\(fathom VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
setup(version=version, ext_modules=[Extension("fathom._fathom", [])], cmdclass={"build_ext": CMakeBuild},
      options={"build": {"build_base": str(BUILD / "setuptools")}})

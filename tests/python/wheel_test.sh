#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# wheel_test.sh PROJECT BUILD FOLDER: the wheel of a build folder's module, installed from the file in a bare environment, where PATH has no
# compiler, answers a depth and a verdict, with no library but its own and those of every Linux. numpy, which pip would fetch, is Debian's.
set -eu
project=$1 build=$2 folder=$3
rm -rf "$folder"
mkdir -p "$folder"
FATHOM_BUILD=$build "$project/packaging/wheel.py" "$folder/wheels" >"$folder/log" 2>&1 || { tail -50 "$folder/log"; exit 1; }
/usr/bin/python3 -m venv "$folder/venv"
cd "$folder"
export PATH=$folder/venv/bin PYTHONDONTWRITEBYTECODE=1
unset PYTHONPATH
pip -q --disable-pip-version-check install --no-index --no-deps wheels/fathom_depth-*.whl >log 2>&1 || { while read -r line; do echo "$line"; done <log; exit 1; }
packages=$(python3 -c 'import sysconfig; print(sysconfig.get_path("platlib"))')
python3 - "$packages" <<'PYTHON'
import pathlib, re, sys

site = pathlib.Path(sys.argv[1])
(site / "numpy").symlink_to("/usr/lib/python3/dist-packages/numpy")
import numpy.linalg  # whose libraries are Debian's


def mapped():
    return set(re.findall(r"(/\S+\.so\S*)$", pathlib.Path("/proc/self/maps").read_text(), re.MULTILINE))


before = mapped()
import fathom

cube = fathom.box((1, 1, 1))
assert fathom.depth(cube, fathom.sphere(1)).depth == 2.0
assert fathom.judge(cube, cube, overlap=True, depth=2.25, direction=(1, 0, 0)).verdict == "too-deep"
foreign = {file for file in mapped() - before if not file.startswith(str(site))}
unexpected = [file for file in foreign if not re.search(r"/lib(c|m|stdc\+\+|gcc_s|dl|rt|pthread)\.so|/lib-dynload/", file)]
assert not unexpected, f"these libraries are the system's: {unexpected}"
own = {pathlib.Path(file).name for file in mapped() if "/fathom_depth.libs/" in file}
assert any(name.startswith("libgmp-fathom.so") for name in own), own
[info] = site.glob("fathom_depth-*.dist-info")
assert (info / "licenses" / "GPL-3.0-or-later.txt").exists() and (info / "licenses" / "libgmp10.txt").exists()
PYTHON
/usr/bin/rm -rf "$folder"

#!/usr/bin/python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""usage: wheel.py OUT    makes the wheel fathom-depth in the folder OUT: the Python module with all its libraries.

pip builds the module (bindings/python/setup.py), for the Python that runs this. The libraries that it is linked with are copied beside it,
but for those that every Linux of the tag's glibc has; they get names of their own, so that no library of another package is taken for
one of them. The tag manylinux_2_34 holds for what is inside: PEP 600 and auditwheel's policy say which libraries and which versions of
symbols may be wanted. Where more is wanted there is no wheel. It needs Debian's patchelf and binutils."""
import base64
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
TAG = "manylinux_2_34_x86_64"
LIMITS = {"GLIBC": (2, 34), "GLIBCXX": (3, 4, 29), "CXXABI": (1, 3, 13), "GCC": (7, 0, 0)}
EVERYWHERE = {"libc.so.6", "libm.so.6", "libdl.so.2", "librt.so.1", "libpthread.so.0", "libstdc++.so.6", "libgcc_s.so.1",
              "ld-linux-x86-64.so.2"}
OWN_NAME = re.compile(r"^(lib[^.]*)(\.so.*)$")


def run(*words, **options):
    return subprocess.run([str(word) for word in words], check=True, stdout=subprocess.PIPE, text=True, **options).stdout


def needed(file):
    return set(re.findall(r"NEEDED\s+(\S+)", run("objdump", "-p", file)))


def linked(file):
    """Returns the libraries that the loader finds for a file, by name, without those that are everywhere."""
    found = dict(re.findall(r"(\S+) => (/\S+)", run("ldd", file)))
    return {name: pathlib.Path(path) for name, path in found.items() if name not in EVERYWHERE}


def bundle(module, folder):
    """Copies what a module is linked with into a folder, and lets it and them find each other there. Returns them all."""
    names = {name: OWN_NAME.sub(r"\1-fathom\2", name) for name in linked(module)}
    folder.mkdir()
    files = [(module, f"$ORIGIN/../{folder.name}")]
    for name, path in linked(module).items():
        file = folder / names[name]
        shutil.copyfile(path.resolve(), file)
        run("patchelf", "--set-soname", file.name, file)
        files.append((file, "$ORIGIN"))
    for file, path in files:
        for name in sorted(needed(file) & names.keys()):
            run("patchelf", "--replace-needed", name, names[name], file)
        run("patchelf", "--set-rpath", path, file)
    return [file for file, _ in files]


def broken_limits(file):
    """Returns what a file wants that the tag does not promise, as sentences."""
    for kind, version in sorted(set(re.findall(r"\b(GLIBC|GLIBCXX|CXXABI|GCC)_([0-9.]+)", run("objdump", "-p", file)))):
        if tuple(map(int, version.split("."))) > LIMITS[kind]:
            yield f"{file.name} wants {kind}_{version}, which {TAG} does not promise"


def add_licences(info, libraries):
    """Ours, and what Debian says of the copyright of each library."""
    shutil.copytree(ROOT / "LICENSES", info / "licenses")
    for path in libraries.values():
        [package] = {line.split(":")[0] for line in run("dpkg", "-S", f"*/{path.resolve().name}").splitlines() if "fathom" not in line}
        shutil.copyfile(f"/usr/share/doc/{package}/copyright", info / "licenses" / f"{package}.txt")


def record_line(tree, file):
    digest = base64.urlsafe_b64encode(hashlib.sha256(file.read_bytes()).digest()).rstrip(b"=").decode()
    return f"{file.relative_to(tree)},sha256={digest},{file.stat().st_size}\n"


def packed(tree, info, wheel):
    """Writes the record of a wheel and the wheel, the same bytes for the same files."""
    files = sorted(file for file in tree.rglob("*") if file.is_file() and file.name != "RECORD")
    record = info / "RECORD"
    record.write_text("".join(record_line(tree, file) for file in files) + f"{record.relative_to(tree)},,\n")
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for file in [*files, record]:
            entry = zipfile.ZipInfo(str(file.relative_to(tree)))
            entry.compress_type, entry.external_attr = zipfile.ZIP_DEFLATED, (0o100755 if ".so" in file.name else 0o100644) << 16
            archive.writestr(entry, file.read_bytes())


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__.split("\n")[0])
    out = pathlib.Path(sys.argv[1])
    out.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as work:
        run(sys.executable, "-m", "pip", "-q", "wheel", "--no-build-isolation", "--no-deps", "--no-index", "-w", work, ROOT / "bindings/python")
        [plain] = pathlib.Path(work).glob("*.whl")
        tree = pathlib.Path(work) / "tree"
        zipfile.ZipFile(plain).extractall(tree)
        [info], [module] = tree.glob("*.dist-info"), tree.glob("fathom/*.so")
        run("strip", "--strip-unneeded", module)
        libraries = linked(module)
        files = bundle(module, tree / "fathom_depth.libs")
        broken = [sentence for file in files for sentence in broken_limits(file)]
        if broken:
            sys.exit("wheel.py: " + "; ".join(broken))
        add_licences(info, libraries)
        told = info / "WHEEL"
        told.write_text(re.sub(r"(?m)^(Tag: .*-)linux_x86_64$", rf"\1{TAG}", told.read_text()))
        wheel = out / plain.name.replace("linux_x86_64", TAG)
        packed(tree, info, wheel)
    print(wheel)


if __name__ == "__main__":
    main()

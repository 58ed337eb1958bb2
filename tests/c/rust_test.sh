#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the binding in Rust with its tests, and runs them: rust_test.sh RUSTC FOLDER_OF_THE_BINDING FOLDER_OF_THE_LIBRARY WORK
set -eu
mkdir -p "$4"
"$1" --edition 2021 --test -D warnings -L "native=$3" -o "$4/fathom_rust" "$2/fathom.rs"
LD_LIBRARY_PATH=$3 "$4/fathom_rust"

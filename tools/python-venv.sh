#!/bin/sh
# Makes the virtual environment $1 with what the requirements $2 name, $3 of it, from PyPI; does nothing if it has
# them. pip may take $4 seconds. PYTHON names another python3. Fails with one line on standard error.
set -eu

venv=$1
requirements=$2
size=${3:-330 MB}
python=${PYTHON:-python3}

fail() { echo "hificamsim: the Python package is not tested: $*" >&2; rm -rf "$venv"; exit 1; }

cmp -s "$requirements" "$venv/requirements.txt" && exit 0
"$python" -c 'import sys, venv, ensurepip; sys.exit(sys.version_info < (3, 10))' 2>/dev/null ||
    fail "missing: Python 3.10 or later with venv (apt-get install python3-venv)"
[ "${OFFLINE:-}" = "" ] || fail "missing: its libraries from PyPI ($size)"
echo "hificamsim: fetching the libraries of the Python package's tests from PyPI, $size" >&2
rm -rf "$venv"
"$python" -m venv "$venv" >"$venv.log" 2>&1 </dev/null || fail "$(tail -n 1 "$venv.log")"
timeout "${4:-600}" "$venv/bin/python" -m pip install --quiet --disable-pip-version-check -r "$requirements" \
    >"$venv.log" 2>&1 </dev/null || fail "pip cannot fetch them ($(grep -v '^ *$' "$venv.log" | tail -n 1))"
cp "$requirements" "$venv/requirements.txt"

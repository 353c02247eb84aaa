#!/bin/sh
# Makes the virtual environment $1 with the packages of the requirements $2, $3 MB from PyPI, for the tests of $4. Each file
# has to have its SHA-256 in the .lock next to the requirements (tools/lock-wheels writes it). Does nothing if the packages are
# there. Further arguments go to pip, which may take PIP_SECONDS (600). PYTHON names another python3. Fails with one line on
# standard error.
set -eu

venv=$1
locked=${2%.txt}.lock
size=$3
tested=$4
shift 4
python=${PYTHON:-python3}

fail() { echo "hificamsim: no tests of $tested: $*" >&2; rm -rf "$venv"; exit 1; }

cmp -s "$locked" "$venv/locked" && exit 0
"$python" -c 'import sys, venv, ensurepip; sys.exit(sys.version_info < (3, 10))' 2>/dev/null ||
    fail "missing: Python 3.10 or later with venv (apt-get install python3-venv)"
[ "${OFFLINE:-}" = "" ] || fail "missing: what they need from PyPI ($size MB)"
echo "hificamsim: fetching what the tests of $tested need from PyPI, $size MB" >&2
rm -rf "$venv"
"$python" -m venv "$venv" >"$venv.log" 2>&1 </dev/null || fail "$(tail -n 1 "$venv.log")"
timeout "${PIP_SECONDS:-600}" "$venv/bin/python" -m pip install --quiet --disable-pip-version-check --no-compile "$@" \
    --require-hashes -r "$locked" >"$venv.log" 2>&1 </dev/null ||
    fail "pip cannot fetch them ($(grep -v '^ *$' "$venv.log" | tail -n 1))"
cp "$locked" "$venv/locked"

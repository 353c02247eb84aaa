#!/bin/sh
# Puts bin/ and jars/ of the PySpark distribution, version $2, into the folder $1: what a Spark cluster needs, Python aside.
# Fails with one line on standard error. PyPI has it as a source archive only, 300 MB, which pip fetches and tar unpacks.
set -eu

target=$1
version=$2
work=$target.part

fail() { echo "hificamsim: no Spark to test with: $*" >&2; rm -rf "$work"; exit 1; }

python3 -m pip --version >/dev/null 2>&1 || fail "pip is missing (apt-get install python3-pip), or set SPARK_HOME"
echo "hificamsim: fetching PySpark $version from PyPI to test with, 300 MB" >&2
rm -rf "$work"
mkdir -p "$work"
timeout 400 python3 -m pip download --quiet --no-deps --no-binary pyspark --dest "$work" "pyspark==$version" \
    >"$work/log" 2>&1 </dev/null || fail "pip cannot fetch pyspark $version ($(grep -v '^ *$' "$work/log" | tail -n 1))"
tar -xzf "$work"/pyspark-*.tar.gz -C "$work" --strip-components=2 "pyspark-$version/deps/jars" "pyspark-$version/deps/bin" ||
    fail "the archive of pyspark $version has another layout"
rm "$work"/pyspark-*.tar.gz "$work/log"
rm -rf "$target"
mv "$work" "$target"

# Sourced by ./hificamsim where --format parquet is asked for or read: fetches and builds what that needs, sets the variable at the end.
# shellcheck shell=sh

parquet=${root:?}/parquet/build/install/parquet
if ! [ -e "$parquet" ] && ! [ -d "$(gradle_files)/caches/modules-2/files-2.1/org.apache.parquet" ]; then
    [ "$installing" = yes ] || die 'missing: Parquet from Maven Central (11 MB), for --format parquet'
    say 'fetching Parquet from Maven Central (11 MB), for --format parquet'
fi
build_if_stale "$parquet" :parquet:libraries
# shellcheck disable=SC2034 # for the launcher
parquet_libraries=$parquet/*

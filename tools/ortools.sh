# Sourced by ./hificamsim where `place --method exact` is asked for: fetches and builds what that needs, sets the variable at the end.
# shellcheck shell=sh

ortools=${root:?}/ortools/build/install/ortools
if ! [ -e "$ortools" ] && ! [ -d "$(gradle_files)/caches/modules-2/files-2.1/com.google.ortools" ]; then
    [ "$installing" = yes ] || die 'missing: OR-Tools from Maven Central (33 MB), for place --method exact'
    say 'fetching OR-Tools from Maven Central (33 MB), for place --method exact'
fi
build_if_stale "$ortools" :ortools:libraries
# shellcheck disable=SC2034 # for the launcher
ortools_libraries=$ortools/*

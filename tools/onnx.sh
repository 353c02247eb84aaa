# Sourced by ./hificamsim where a policy onnx:FILE is named: fetches and builds what that needs, sets the variable at the end.
# shellcheck shell=sh

onnx=${root:?}/onnx/build/install/onnx
if ! [ -e "$onnx" ] && ! [ -d "$(gradle_files)/caches/modules-2/files-2.1/com.microsoft.onnxruntime" ]; then
    [ "$installing" = yes ] || die 'missing: ONNX Runtime from Maven Central (93 MB), for --policy onnx:FILE'
    say 'fetching ONNX Runtime from Maven Central (93 MB), for --policy onnx:FILE'
fi
build_if_stale "$onnx" :onnx:libraries
# shellcheck disable=SC2034 # for the launcher
onnx_libraries=$onnx/*

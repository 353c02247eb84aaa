# Sourced by ./hificamsim: adds optional parts of the command line, which are fetched and built on first use.
# shellcheck shell=sh

# Adds the jars of the part $1 to `libraries`.
part() {
    case $1 in
        spark)
            # shellcheck source=tools/spark.sh
            . "${root:?}/tools/spark.sh"
            libraries=$spark_libraries
            return
            ;;
        onnx) part_from_maven onnx com.microsoft.onnxruntime 'ONNX Runtime' 93 '--policy onnx:FILE' ;;
        ortools) part_from_maven ortools com.google.ortools OR-Tools 33 'place --method exact' ;;
        parquet) part_from_maven parquet org.apache.parquet Parquet 11 '--format parquet' ;;
        sqlite) part_from_maven sqlite org.xerial SQLite 14 'import FILE.sqlite' ;;
    esac
    libraries="$libraries:$root/$1/build/install/$1/*"
}

# Builds the module $1 for the option $5. It needs the libraries $3, of the Maven group $2 and of $4 MB.
part_from_maven() {
    installed=${root:?}/$1/build/install/$1
    if ! [ -e "$installed" ] && ! [ -d "$(gradle_files)/caches/modules-2/files-2.1/$2" ]; then
        [ "$installing" = yes ] || die "missing: $3 from Maven Central ($4 MB), for $5"
        say "fetching $3 from Maven Central ($4 MB), for $5"
    fi
    build_if_stale "$installed" ":$1:libraries"
}

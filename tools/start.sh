# Sourced by ./hificamsim, and by bin/hificamsim of a release: refuses too few files at once, and defines `start`, which
# starts Java with the arguments of the command line. `start` needs `root`, the folder with scenarios/; `lib`, that of the jars;
# `home`, that of Java; `archive`, of classes, if it is there; and `part NAME`, which adds the jars of spark, onnx, ortools,
# parquet or sqlite to `libraries`.
# shellcheck shell=sh

# Java opens each jar, and says nothing that one could read when it may not.
files=$(ulimit -n)
[ "$files" = unlimited ] || [ "$files" -ge 128 ] || {
    echo "error: at most $files files may be open (ulimit -n), expected 128 or more" >&2
    exit 2
}

# Whether one of the words is an entry of the benchmark whose policy is a trained network.
has_network() {
    for word; do
        ! grep -qs -e '"policy" *: *"onnx:' -- "$word" "$word/entry.json" || return 0
    done
    return 1
}

start() {
    : "${root:?}" "${lib:?}" "${home:?}" "${archive:?}"
    native= # Java 24 and later warn of libraries with parts in C, and of what these do with memory
    ! grep -qs '^JAVA_VERSION="\(2[4-9]\|[3-9][0-9]\)' "$home/release" ||
        native='--enable-native-access=ALL-UNNAMED --sun-misc-unsafe-memory-access=allow'
    terminal=$([ -t 2 ] && echo true || echo false)
    libraries="$lib/*"
    [ "${1:-}" != profile ] || libraries="$libraries:$lib/profile/*" # OpenCV and its like: nothing else pays for them
    young=
    case " $* " in *' --heterogeneous'*) ;; ' tradeoff '*) young='-XX:TieredStopAtLevel=1' ;; esac # a second, which the optimising compiler would take for itself
    # Else a machine with more memory would use more, for garbage alone.
    case ${1:-} in
        camsim | view) young='-XX:MaxNewSize=96m -Xlog:gc+ergo=off' ;;
        tradeoff) young="$young -XX:MaxNewSize=32m -Xlog:gc+ergo=off" ;;
    esac
    case " $* " in *' --engine spark '* | *' --engine=spark '*) part spark ;; esac
    case " $* " in *[\ =,]onnx[\ :,]*) part onnx ;; ' benchmark verify '*) ! has_network "$@" || part onnx ;; esac
    case "${1:-} $* " in 'place '*' --method exact '* | 'place '*' --method=exact '*) part ortools ;; esac
    case " $* " in *' --format parquet '* | *' --format=parquet '*) part parquet ;; esac
    case "${1:-} $* " in 'import '*' jupedsim '* | 'import '*.sqlite\ * | 'import '*.sqlite3\ * | 'import '*.db\ * | 'site '*.sqlite\ * | 'site '*.sqlite3\ * | 'site '*.db\ *) part sqlite ;; esac
    set -- -cp "$libraries${CLASSPATH:+:$CLASSPATH}" org.hificamsim.cli.Main "$@"
    # shellcheck disable=SC2086 # several options
    set -- ${HIFICAMSIM_OPTS:-} "$@"
    [ -z "${spark_options:-}" ] || set -- "@$spark_options" "-Dlog4j2.configurationFile=$spark_log" "$@"
    # One thread collects garbage: the inner loops leave none, and starting is faster. Methods are compiled after three
    # times as many calls as Java would: a short run takes a third less of the processor, one of 100,000 steps a fifth.
    # An archive of classes that does not fit (another JVM, a changed jar) is passed over, without a word on the screen.
    # It is mapped where it was made for: moving it to another address takes a tenth of a start.
    [ ! -f "$archive" ] || set -- "-XX:SharedArchiveFile=$archive" '-Xlog:cds*=off' -Xlog:class+path=off \
        -XX:+UnlockDiagnosticVMOptions -XX:ArchiveRelocationMode=0 "$@"
    collector=-XX:+UseSerialGC
    case ${HIFICAMSIM_OPTS:-} in *-XX:+Use*GC*) collector= ;; esac # Java takes one
    # Without performance data no other process can read the arguments of this one in a file.
    # shellcheck disable=SC2086 # several options or none
    exec "$home/bin/java" $collector -XX:-UsePerfData -XX:CompileThresholdScaling=3 $young $native "-Dhificamsim.root=$root" "-Dhificamsim.terminal=$terminal" "$@"
}

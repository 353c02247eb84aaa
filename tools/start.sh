# Sourced by ./hificamsim, and by bin/hificamsim of a release. Exits if too few files may be open, and defines `start`, which
# starts Java with the arguments of the command line. `start` needs `root`, the folder with scenarios/; `lib`, the folder of the
# jars; `home`, the folder of Java; `archive`, a file of classes that may be missing; and `part NAME`, which adds the jars of
# spark, onnx, ortools, parquet or sqlite to `libraries`.
# shellcheck shell=sh

# Java opens each jar, and its message is unreadable if the limit does not allow that.
files=$(ulimit -n)
[ "$files" = unlimited ] || [ "$files" -ge 128 ] || {
    echo "error: at most $files files may be open (ulimit -n), expected 128 or more" >&2
    exit 2
}

# Whether one of the arguments is an entry of the benchmark whose policy is a trained network.
has_network() {
    for word; do
        ! grep -qs -e '"policy" *: *"onnx:' -- "$word" "$word/entry.json" || return 0
    done
    return 1
}

start() {
    : "${root:?}" "${lib:?}" "${home:?}" "${archive:?}"
    native= # options that silence the warnings of Java 24 and later about native libraries and their use of memory
    ! grep -qs '^JAVA_VERSION="\(2[4-9]\|[3-9][0-9]\)' "$home/release" ||
        native='--enable-native-access=ALL-UNNAMED --sun-misc-unsafe-memory-access=allow'
    terminal=$([ -t 2 ] && echo true || echo false)
    libraries="$lib/*"
    [ "${1:-}" != profile ] || libraries="$libraries:$lib/profile/*" # OpenCV and other libraries that only profile needs
    young=
    case " $* " in *' --heterogeneous'*) ;; ' tradeoff '*) young='-XX:TieredStopAtLevel=1' ;; esac # saves a second of the optimising compiler
    # Without a limit, machines with more memory would use more of it, only for garbage.
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
    # One thread collects garbage, because inner loops allocate nothing and Java starts faster. Methods are compiled after
    # three times as many calls as by default, which saves a third of the processor time of a short run, and a fifth of a run
    # of 100,000 steps. An archive of classes that does not fit (another JVM, a changed jar) is silently ignored. It is mapped
    # at its own address, because moving it takes a tenth of a start.
    [ ! -f "$archive" ] || set -- "-XX:SharedArchiveFile=$archive" '-Xlog:cds*=off' -Xlog:class+path=off \
        -XX:+UnlockDiagnosticVMOptions -XX:ArchiveRelocationMode=0 "$@"
    collector=-XX:+UseSerialGC
    case ${HIFICAMSIM_OPTS:-} in *-XX:+Use*GC*) collector= ;; esac # Java accepts only one
    # Without performance data no other process can read the arguments of this one in a file.
    # shellcheck disable=SC2086 # several options or none
    exec "$home/bin/java" $collector -XX:-UsePerfData -XX:CompileThresholdScaling=3 $young $native "-Dhificamsim.root=$root" "-Dhificamsim.terminal=$terminal" "$@"
}

# Sourced by ./hificamsim and ./test with `root` set: finds or installs what the project needs, and builds.
# All messages go to standard error. docs/adr/0002-build.md has the reasons.
# shellcheck shell=sh
: "${root:?}"

gradle=/usr/share/gradle/bin/gradle # Debian's; the one on PATH may be another version
debian_opencv=/usr/share/java/opencv.jar # instead of Maven Central's, as in profiling/build.gradle
lib=$root/cli/build/install/hificamsim/lib
archive=${lib%/*}.jsa
installing=yes # "no" after --no-install: missing packages are listed, and nothing is installed or fetched

say() { echo "hificamsim: $*" >&2; }
die() { say "$@"; exit 1; }

# Java decodes names of files by the locale; C and POSIX (cron, batch systems) do not allow accents.
[ "$(locale charmap 2>/dev/null)" != ANSI_X3.4-1968 ] || export LC_ALL=C.UTF-8
case $root in *:*) die "this folder is $root, expected a path without a colon: Java's class path cannot hold one" ;; esac

# Prints the feature version (17, 25, ...) of the Java installation $1; 0 if there is none.
java_version() {
    version=
    if [ -r "$1/release" ]; then
        version=$(sed -n 's/^JAVA_VERSION="\([0-9]*\).*/\1/p' "$1/release")
    elif [ -x "$1/bin/java" ]; then
        version=$("$1/bin/java" -version 2>&1 | sed -n '1s/.*version "\([0-9]*\).*/\1/p')
    fi
    echo "${version:-0}"
}

# Prints the first Java installation with the program $1 and a version in $2..$3; looks in JAVA_HOME, PATH, the usual folder.
java_home() {
    on_path=$(command -v "$1") && on_path=$(dirname "$(dirname "$(readlink -f "$on_path")")")
    for home in "${JAVA_HOME:-}" "$on_path" /usr/lib/jvm/*-17-*; do
        [ -x "${home:-/none}/bin/$1" ] || continue
        version=$(java_version "$home")
        if [ "$version" -ge "$2" ] && [ "$version" -le "$3" ]; then
            echo "$home"
            return
        fi
    done
    return 1
}

run_home() { java_home java 17 999; }
build_home() { java_home javac 17 17; } # Gradle 4.4.1 does not run on later versions

# Installs missing Debian packages; if it may not, names them in one line.
install_missing() {
    missing=
    build_home >/dev/null || missing=openjdk-17-jdk-headless
    [ -x "$gradle" ] || missing="${missing:+$missing }gradle"
    [ -n "$missing" ] || return 0
    command -v apt-get >/dev/null || die "missing: JDK 17 and Debian's Gradle 4.4.1 ($missing)"
    may_install || die "missing: $missing; as root: apt-get install $missing"
    install "$missing" || die "could not install $missing"
}

# Installs the browser of the tests; without one, tests that need it are skipped with a message.
install_browser() {
    command -v chromium >/dev/null && command -v chromedriver >/dev/null && return
    if may_install && install 'chromium chromium-driver'; then return; fi
    say "missing: chromium and chromedriver, so pages are not tested; as root: apt-get install chromium chromium-driver"
}

# Installs Python with venv, for the tests of the Python package and of recordings; without it they are skipped with a message.
install_python() {
    python3 -c 'import venv, ensurepip' 2>/dev/null && return
    if may_install && install python3-venv; then return; fi
    say "missing: python3-venv, so the Python package and recordings by SUMO and JuPedSim are not tested; as root: apt-get install python3-venv"
}

may_install() {
    [ "$installing" = yes ] && command -v apt-get >/dev/null && { [ "$(id -u)" = 0 ] || sudo -n true 2>/dev/null; }
}

# Announces the size of the packages $1 and installs them; if that fails, prints the output of apt-get.
install() {
    as_root=
    [ "$(id -u)" = 0 ] || as_root='sudo -n'
    say "missing: $1; asking apt-get for it"
    log=$(mktemp)
    $as_root apt-get update >"$log" 2>&1 </dev/null || true # an unreachable source does not stop the others
    say "installing it, $(get "$1" --assume-no 2>&1 | sed -n 's/^Need to get \(.*\) of archives.*/\1/p') to fetch"
    if get "$1" --yes >>"$log" 2>&1; then
        rm -f "$log"
    else
        cat "$log" >&2
        rm -f "$log"
        return 1
    fi
}

# Calls apt-get install for the packages $1 with the option $2.
# shellcheck disable=SC2086 # several packages, several words
get() {
    $as_root env LC_ALL=C DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 \
        install --no-install-recommends "$2" $1 </dev/null
}

gradle_files() { echo "${GRADLE_USER_HOME:-${HOME:-$root}/.gradle}"; }

# Announces what Gradle will fetch from Maven Central; with --no-install, says that it is missing.
tell_libraries() {
    cache=$(gradle_files)/caches/modules-2/files-2.1
    wanted=
    [ -d "$cache/com.google.errorprone" ] || wanted='libraries from Maven Central (some 100 MB)'
    [ -d "$cache/org.openpnp" ] || [ -e "$debian_opencv" ] ||
        wanted="${wanted:+$wanted and }OpenCV from Maven Central (101 MB; libopencv-java takes its place)"
    [ -n "$wanted" ] || return 0
    [ "$installing" = yes ] || die "missing: $wanted"
    say "fetching $wanted"
}

# Runs Gradle in the project's root on the right JDK, without the lines that Debian's start script and downloads add.
run_gradle() (
    JAVA_HOME=$(build_home)
    GRADLE_USER_HOME=$(gradle_files)
    GRADLE_OPTS="-XX:TieredStopAtLevel=1 ${GRADLE_OPTS:-}" # Gradle mostly waits for the processes that it starts
    export JAVA_HOME GRADLE_USER_HOME GRADLE_OPTS
    [ "$installing" = yes ] || set -- --offline "$@"
    cd "$root" && "$gradle" --no-daemon "$@" </dev/null 2>&1
)
without_chatter() { grep --line-buffered -Ev '^(Download https?:|openjdk version |OpenJDK .*(Runtime|VM|warning))' || true; }

# Whether $1 must be built: it has no stamp $2, or a source or build file (or its directory) is newer than the stamp.
stale() {
    [ -e "$1" ] && [ -f "$2" ] || return 0
    [ -n "$(cd "$root" && find build.gradle settings.gradle gradle ./*/build.gradle ./*/src \
        -path './*/src/test' -prune -o -newer "$2" -print -quit)" ]
}

# Archives the classes of five short commands, which the JVM maps at the next start (docs/adr/0002-build.md).
# If this fails, the command line starts without the archive.
archive_classes() {
    scratch=$(mktemp -d) || return 0
    rm -f "$archive"
    printf '0 1 0 0\n1 1 1 0\n2 1 2 0\n' >"$scratch/people.txt"
    if java=$(run_home) && list_classes run "$root/scenarios/cluster-scripted.xml" --record --out "$scratch/run" &&
        list_classes compare "$root/scenarios/cluster-scripted.xml" --steps 50 --repeat 2 --out "$scratch/compare" &&
        list_classes tradeoff "$root/scenarios/studies/yard.xml" --steps 100 --repeat 4 --out "$scratch/tradeoff" &&
        list_classes import "$scratch/people.txt" --format ethucy --rate 2 --out "$scratch/import" &&
        list_classes camsim "$root/scenarios/tutorial-camsim.xml" -t 50 -o "$scratch/steps.csv" &&
        cat "$scratch"/*.classes | sed '/ source: /d; s/ id: [0-9]*$//' | awk '!seen[$0]++' >"$scratch/all" && # newer JVMs number classes
        "$java/bin/java" -Xshare:dump -Xlog:disable "-XX:SharedClassListFile=$scratch/all" "-XX:SharedArchiveFile=$archive.new" -cp "$lib/*"; then
        mv "$archive.new" "$archive" # never an incomplete one, which crashes the JVM
    fi >/dev/null 2>&1
    rm -rf "$scratch" "$archive.new"
}
list_classes() {
    "$java/bin/java" -XX:+UseSerialGC -Xlog:disable "-XX:DumpLoadedClassList=$scratch/$1.classes" "-Dhificamsim.root=$root" \
        -cp "$lib/*" org.hificamsim.cli.Main "$@"
}

# Builds $1 by the Gradle task $2 if it is stale. If several calls need it at once, one builds and the others wait.
build_if_stale() {
    product=${1:-$lib}
    goal=${2:-:cli:installDist}
    stamp=${product%/*}.stamp
    stale "$product" "$stamp" || return 0
    if ! [ -w "$root" ]; then
        [ -e "$product" ] || die "not built, and $root cannot be written"
        return 0
    fi
    install_missing
    tell_libraries
    mkdir -p "$root/.gradle" "$(dirname "$stamp")"
    (
        flock 9
        stale "$product" "$stamp" || exit 0
        if [ -f "$stamp" ]; then say "building what has changed"; else say "building; the first time takes a minute"; fi
        touch "$stamp.new" # has the time of the start, so that changes during the build are newer
        if ! log=$(run_gradle --quiet "$goal"); then
            printf '%s\n' "$log" | without_chatter >&2
            die "the build failed"
        fi
        [ "$product" != "$lib" ] || archive_classes
        mv "$stamp.new" "$stamp"
    ) 9>"$root/.gradle/hificamsim.lock"
}

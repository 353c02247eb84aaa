# Runs a program with at most $1 seconds of processor time and $2 kilobytes of memory, and files of at most 64 MB. A limit that
# a sandbox around this one has set lower stays. Where the system has namespaces for its users, the program has no network,
# sees no other process, and can write to its own folder alone; the inner namespace keeps it from undoing that.
ulimit -t "$1" 2>/dev/null || true
ulimit -v "$2" 2>/dev/null || true
ulimit -f 131072 2>/dev/null || true
shift 2
unshare -Urnpf --mount-proc unshare -Urm true 2>/dev/null || exec "$@"
# shellcheck disable=SC2016 # the inner shell expands it
exec unshare -Urnpf --mount-proc --kill-child sh -c '
    mount --bind "$PWD" "$PWD" 2>/dev/null && cd "$PWD"
    while read -r _ place _ flags _; do
        case $place in "$PWD" | /proc) continue ;; esac
        flags=$(printf %s "$flags" | sed "s/^rw/ro/; s/,\(size\|nr_inodes\|mode\|uid\|gid\)=[^,]*//g")
        mount -o "remount,bind,$flags" "$place" 2>/dev/null || true
    done </proc/self/mounts
    exec unshare -Urm "$@"' sh "$@"

# Runs a program with at most $1 seconds of processor time and $2 kilobytes of memory; where the system has namespaces
# for its users, without a network, and where it sees no other process.
ulimit -t "$1"
ulimit -v "$2"
shift 2
unshare -Urnpf --mount-proc true 2>/dev/null || exec "$@"
exec unshare -Urnpf --mount-proc --kill-child "$@"

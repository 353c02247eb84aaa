# Runs a program with at most $2 seconds of processor time, $3 kilobytes of memory, and files of at most 64 MB. A limit that
# a sandbox around this one has set lower stays. With $1 "limited" that is all. With "confined" the program has no network,
# sees no other process, writes to its own folder alone, and reads nothing but that folder, the system's programs and
# libraries, and the $4 files and folders that follow, in which none comes before the folder that it is in. Then come the number of
# folders to hide, and these: the program sees them empty. That needs namespaces for users, as Linux has them.
confinement=$1
ulimit -t "$2" 2>/dev/null || true
ulimit -v "$3" 2>/dev/null || true
ulimit -f 131072 2>/dev/null || true
shift 3

# The root is a folder in memory, into which is bound what the program may read; the inner namespace keeps the program from
# undoing that.
# shellcheck disable=SC2016 # the inner shell expands it
confined='
    root=$PWD/.root
    show() {
        [ -e "$1" ] && [ ! -e "$root$1" ] || return 0
        if [ -d "$1" ]; then mkdir -p "$root$1"; else mkdir -p "$root${1%/*}" && : >"$root$1"; fi
        mount --rbind "$1" "$root$1"
    }
    set -e
    mkdir -p "$root"
    mount -t tmpfs -o mode=755 none "$root"
    for place in /bin /sbin /lib /lib64; do
        if [ -L "$place" ]; then cp -P "$place" "$root"; else show "$place"; fi
    done
    for place in /usr /nix/store /etc/alternatives /etc/ld.so.cache /etc/localtime /etc/java* /proc /dev/null /dev/zero /dev/random /dev/urandom; do
        show "$place"
    done
    hide() {
        [ ! -d "$root$1" ] || mount -t tmpfs none "$root$1"
    }
    for action in show hide; do
        count=$1
        shift
        while [ "$count" -gt 0 ]; do
            "$action" "$1"
            shift
            count=$((count - 1))
        done
    done
    mkdir -p "$root$PWD"
    mount --bind "$PWD" "$root$PWD"
    while read -r _ place _ flags _; do
        place=$(printf %b "$place") # a space is written as its octal number
        case $place in "$root$PWD" | "$root/proc"*) continue ;; "$root"*) ;; *) continue ;; esac
        flags=$(printf %s "$flags" | sed "s/^rw/ro/; s/,\(size\|nr_inodes\|mode\|uid\|gid\|inode64\)[^,]*//g")
        mount -o "remount,bind,$flags" "$place" 2>/dev/null || true
    done </proc/self/mounts
    own=$PWD
    cd "$root"
    PATH=$PATH:/usr/sbin:/sbin pivot_root . . # not chroot, in which a program could not confine another one
    umount -l .
    exec unshare -Urm --wd="$own" "$@"'
[ "$confinement" = limited ] || exec unshare -Urnpf --mount-proc --kill-child sh -c "$confined" sh "$@"
shift "$(($1 + 1))"
shift "$(($1 + 1))"
exec "$@"

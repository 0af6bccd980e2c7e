#!/bin/sh
# fresh.sh - the README's two commands on machines on which nothing has been installed.
#
# For each suite of Debian: a bare system (debootstrap --variant=minbase) with git and make, a clone of the last
# commit in it, 'make setup all', 'make check'. FOR=lecturer: the commands of the lecturer's page instead, 'make setup
# FOR=lecturer', 'make slides', 'make animations'; FOR=book: 'make setup FOR=book', 'make book'; FOR=instructor: 'make
# setup FOR=instructor', and the ten submissions of the instructor's page are marked, as tests/grade/recipes/Containerfile does.
# Needs root, debootstrap and the network, 2 GB of disk and much time for each; for that reason no other test runs it.
# The output is kept in build/fresh/SUITE.log. MIRROR: where the packages are from; CACHE: a folder that keeps
# them for the next time.
# shellcheck disable=SC2317 # the functions are called by step
# Usage: tests/proof/by_hand/fresh.sh [bookworm trixie ...]
set -u
tree=$(cd "$(dirname "$0")/../../.." && pwd)
[ $# -gt 0 ] || set -- bookworm trixie
MIRROR=${MIRROR:-http://deb.debian.org/debian}
case ${FOR:-} in
'') goals='setup all,check' ;;
lecturer) goals='setup FOR=lecturer,slides,animations' ;;
book) goals='setup FOR=book,book' ;;
instructor) goals='setup FOR=instructor,build/grading/commands,grade SUBMISSIONS=build/example-class OUT=/root/marks' ;;
*)
    echo "FOR=$FOR: expected lecturer, book, instructor, or nothing" >&2
    exit 2
    ;;
esac

if [ "$(id -u)" -ne 0 ]; then
    echo "skipped: fresh machines, which only root can make"
    exit 0
fi
if ! command -v debootstrap >/dev/null || ! command -v unshare >/dev/null; then
    echo "skipped: fresh machines: debootstrap or unshare is missing (apt-get install debootstrap util-linux)"
    exit 0
fi

work=$(mktemp -d "${TMPDIR:-/var/tmp}/fresh.XXXXXX") || exit 1
logs=$tree/build/fresh
mkdir -p "$logs" || exit 1
# The mounts and processes are in their own namespaces, and end with the process that made them.
running=""
trap '[ -z "$running" ] || { kill -KILL "$running"; wait "$running"; } 2>/dev/null
    rm -rf --one-file-system "$work"' EXIT
trap 'exit 1' HUP INT TERM

# In such namespaces: alone COMMAND...
alone() {
    exec unshare --mount --pid --fork --kill-child --mount-proc --propagation private "$@" </dev/null
}
# And with another root: inside FOLDER COMMAND... By pivot_root, as nobody can make a sandbox in a chroot.
inside() {
    # shellcheck disable=SC2016 # the inner shell expands them
    alone sh -c '
        mount --bind "$1" "$1" && cd "$1" && mount -t proc proc proc && mount --rbind /dev dev &&
            mount --rbind /sys sys && mkdir .outside && pivot_root . .outside && cd / &&
            umount -l /.outside && rmdir /.outside || exit 125
        shift
        [ ! -s /root/authorities.pem ] || set -- NODE_EXTRA_CA_CERTS=/root/authorities.pem "$@"
        exec env -i HOME=/root PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin \
            http_proxy="${http_proxy:-}" https_proxy="${https_proxy:-}" "$@"' sh "$@"
}

# Does one step of a suite and shows its lines as they come: step WORDS COMMAND...
# In the background, so that the signal that ends this script is not kept waiting.
step() {
    echo "$suite: $1 ..."
    shift
    from=$(date +%s)
    rm -f "$work/lines"
    mkfifo "$work/lines"
    tee -a "$log" <"$work/lines" | sed -u "s/^/$suite | /" &
    "$@" >"$work/lines" 2>&1 &
    running=$!
    wait "$running"
    status=$?
    running=""
    took=$(($(date +%s) - from))
    return $status
}

# A bare system, with the packages that an earlier run has kept.
system() {
    kept=${CACHE:-$work/cache}/$suite
    mkdir -p "$kept"
    alone debootstrap --variant=minbase --cache-dir="$(cd "$kept" && pwd)" \
        --include=git,make "$suite" "$root" "$MIRROR"
}
# The network of this machine, and the settings of apt and npm for it; the certificates that its owner added.
AUTHORITIES=/usr/local/share/ca-certificates
network() {
    cp -L /etc/resolv.conf "$root/etc/resolv.conf"
    apt-config dump 2>/dev/null | grep '^Acquire::' >"$root/etc/apt/apt.conf.d/90as-outside"
    # npm's way to its registry, without passwords.
    grep -E '^(registry|proxy|https-proxy|noproxy|maxsockets|fetch-[a-z-]+) *=' "${HOME:-/root}/.npmrc" >"$root/root/.npmrc" 2>/dev/null
    mkdir -p "$root$AUTHORITIES"
    [ ! -d $AUTHORITIES ] || cp -RL $AUTHORITIES/. "$root$AUTHORITIES"
    # node reads them from one file.
    find $AUTHORITIES -name '*.crt' -exec cat {} + 2>/dev/null |
        cat - ${NODE_EXTRA_CA_CERTS:+"$NODE_EXTRA_CA_CERTS"} >"$root/root/authorities.pem"
    true
}
# The last commit. Git needs permission to read another user's tree.
clone() {
    git config --file "$work/.gitconfig" safe.directory '*' &&
        HOME=$work git clone --quiet --no-local "$tree" "$root/root/tree"
}

# One suite; its verdict is a line of the verdicts.
try() {
    root=$work/$suite
    log=$logs/$suite.log
    : >"$log"
    step 'a bare system' system || { echo "$suite: debootstrap failed"; return 1; } >>"$work/verdicts"
    network
    step 'a clone' clone || { echo "$suite: no clone"; return 1; } >>"$work/verdicts"
    words=""
    status=0
    while [ $status -eq 0 ] && read -r goal; do
        # shellcheck disable=SC2086 # words, on purpose
        step "make $goal" inside "$root" make -C /root/tree --no-print-directory $goal
        status=$?
        [ $status -eq 0 ] && verdict="$took s" || verdict="failed after $took s"
        words="$words${words:+, }'make $goal' $verdict"
    done <<EOF
$(echo "$goals" | tr , '\n')
EOF
    counts=$(grep -E '^[0-9]+ passed, [0-9]+ failed$' "$log" | tail -n 1)
    echo "$suite: $words${counts:+: $counts}" >>"$work/verdicts"
    left=$(git -C "$root/root/tree" -c safe.directory='*' status --porcelain)
    if [ -n "$left" ]; then
        printf '    the tests left files in the tree:\n%s\n' "$left" >>"$work/verdicts"
        status=1
    fi
    sed -n '/^Not tested here:/,/^[0-9]* passed/ s/^  /    not tested: /p' "$log" >>"$work/verdicts"
    return $status
}

failed=0
for suite; do
    try || failed=1
    rm -rf --one-file-system "${work:?}/$suite"
done
echo
cat "$work/verdicts"
exit $failed

#!/usr/bin/env bash
# How long new users wait for a first C file, for the C and the Structured Text of a plant of their own, a first picture
# and a first verified loop, a crate with the macro, and a run in Python.
#
#     bench/new-user.sh [COMMAND...]
#
# In a fresh Debian root, with what README.md says one needs, Python and nothing else, it clones HEAD and runs the
# first `emit`, `simulate` and `verify` of README.md, the steps of docs/start.md and docs/guide/python.md, and any
# COMMAND after them, each a line of shell such as 'cargo test --workspace'. It prints the table that `ptc-bench report` puts into docs/benchmarks/builds.md. It needs
# root and debootstrap; without them it says so, and uses an empty home on this system.
#
# RUST    the toolchain, mounted read-only in place of the one that rustup would download; default: this one
# MIRROR  where Debian's packages come from
# FOLDER  where the root is made, and removed at the end
set -euo pipefail
cd "$(dirname "$0")/.."
RUST=${RUST:-$(rustc --print sysroot)}
MIRROR=${MIRROR:-http://deb.debian.org/debian}
FOLDER=${FOLDER:-$(mktemp -d)}
needed=ca-certificates,git,gcc,libc6-dev,python3-venv
trap 'rm -rf "$FOLDER"' EXIT

# user COMMAND: runs it as the new user, in the clone where there is one.
user() {
    local script='cd; cd ptc 2>/dev/null || true; '"$1"
    if [[ $system == debian ]]; then
        chroot "$FOLDER" env -i HOME=/root PATH=/opt/rust/bin:/usr/bin:/bin sh -ec "$script"
    else
        env -i HOME="$FOLDER/root" PATH="$RUST/bin:/usr/bin:/bin" sh -ec "$script"
    fi
}

measured() {
    local TIMEFORMAT='%R %U %S' all=0 used what command
    if [[ $system == debian ]]; then
        debootstrap --variant=minbase --include="$needed" bookworm "$FOLDER" "$MIRROR" >/dev/null ||
            { tail "$FOLDER/debootstrap/debootstrap.log" >&2; exit 1; }
        mkdir -p "$FOLDER/opt/rust"
        mount --bind "$RUST" "$FOLDER/opt/rust"
        mount -o remount,bind,ro "$FOLDER/opt/rust"
        mount -t proc proc "$FOLDER/proc"
        mount --bind /dev "$FOLDER/dev"
        cp -L /etc/resolv.conf "$FOLDER/etc/"
        cp -L /etc/ssl/certs/ca-certificates.crt "$FOLDER/etc/ssl/certs/"
    fi
    user 'git -c advice.detachedHead=false clone --quiet "$HOME/ptc.bundle" ptc'
    printf '| command | minutes | processor s | minutes from the clone on |\n| --- | ---: | ---: | ---: |\n'
    while IFS=$'\t' read -r what command; do
        used=$({ time user "$command" </dev/null >"$FOLDER/told" 2>&1; } 2>&1) || { tail -n 40 "$FOLDER/told" >&2; exit 1; }
        all=$(awk -v all="$all" '{ print all + $1 }' <<<"$used")
        awk -v what="$what" -v all="$all" '{ printf "| %s | %.1f | %.0f | %.1f |\n", what, $1 / 60, $2 + $3, all / 60 }' <<<"$used"
    done <"$FOLDER/commands"
}

# The first line of README.md that runs a sub-command, without its comment.
shown() { sed -n "s/ *#.*//; /^cargo run .* -- $1 /{p;q}" README.md; }

# A crate beside the clone, with the program of docs/start.md.
crate="mkdir -p ../robot/src && cp examples/encoder.toml ../robot && \
awk '/^\`\`\`rust\$/ { on = 1; next } /^\`\`\`\$/ { on = 0 } on' docs/start.md | sed 's|examples/||' >../robot/src/main.rs && \
cd ../robot && printf '[package]\nname = \"robot\"\nedition = \"2024\"\n[dependencies]\nptc = { path = \"../ptc\" }\n' >Cargo.toml && cargo run -q"
python="python3 -m venv ../python && ../python/bin/pip install -q . && ../python/bin/python -c \"import ptc_codegen as ptc; \
ptc.simulate(ptc.Design.load('examples/table.toml', t0=0), [1, 0.5]).plot().save('table.svg')\""
own='cargo run -q -p ptc-codegen --'

if [[ $(id -u) == 0 ]] && command -v debootstrap >/dev/null; then
    system=debian
else
    echo 'no fresh Debian, for want of root or debootstrap: an empty home on this system' >&2
    system=own
fi
export RUST FOLDER MIRROR needed system
mkdir -p "$FOLDER/root"
git bundle create --quiet "$FOLDER/root/ptc.bundle" HEAD
{
    printf '%s\t%s\n' 'first C' "$(shown emit)" \
        'a plant of their own: `new` and `check`' "$own new belt --plant stage --limit 100 && $own check belt.toml" \
        'its C' "$own emit belt.toml --lang c -o out" 'its Structured Text' "$own emit belt.toml --lang st -o out" \
        'first picture' "$(shown simulate)" 'first verified loop' "$(shown verify)" \
        'a crate with the macro' "$crate" 'Python: `pip install .` and a picture' "$python"
    for command in "$@"; do printf '`%s`\t%s\n' "$command" "$command"; done
} >"$FOLDER/commands"
# The mounts end with their name space, before the folder is removed.
export -f user measured
results=$(realpath -m "${CARGO_TARGET_DIR:-target}/ptc-bench")
mkdir -p "$results"
if [[ $system == debian ]]; then unshare --mount bash -euo pipefail -c measured; else measured; fi |
    tee "$results/new-user.md"

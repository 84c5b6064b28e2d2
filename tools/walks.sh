#!/bin/bash
# The first results of newcomers: a fresh clone in which nothing is built, then the commands of README,
# docs/start.md and docs/guide/python.md. Prints seconds and processor seconds of each.
# Downloads of crates and of the wheel's tools count where they are not cached.
#
#   bash tools/walks.sh [FOLDER]     # a folder that does not exist yet, /tmp/ptc-walks if not given
set -eu

project=$(git -C "$(dirname "$0")" rev-parse --show-toplevel)
folder=${1:-/tmp/ptc-walks}
mkdir "$folder"
cd "$folder"
unset CARGO_TARGET_DIR CARGO_INCREMENTAL
git clone -q "$project" clone
cd clone

# Runs a command, and prints what it took.
walk() {
    local what=$1
    shift
    /usr/bin/time -o "$folder/took" -f '%e %U %S' "$@" >"$folder/log" 2>&1 || { cat "$folder/log"; exit 1; }
    awk -v what="$what" '{ printf "| %s | %.0f | %.0f |\n", what, $1, $2 + $3 }' "$folder/took"
}

ptc=(cargo run -q -p ptc-codegen --)

echo '| | s | processor s |'
echo '| --- | ---: | ---: |'
walk 'firmware in C: the first C' "${ptc[@]}" emit --lang c --n 3 --mu exp -o out
walk 'an own plant: `new`' "${ptc[@]}" new belt --plant stage --limit 100 -o "$folder"
walk 'an own plant: `check`' "${ptc[@]}" check "$folder/belt.toml"
walk 'an own plant: C' "${ptc[@]}" emit "$folder/belt.toml" --lang c -o out
walk 'a PLC: Structured Text of the own plant' "${ptc[@]}" emit "$folder/belt.toml" --lang st -o out

mkdir -p "$folder/robot/src"
printf '[package]\nname = "robot"\nversion = "0.1.0"\nedition = "2024"\n\n[dependencies]\nptc = { path = "%s/clone" }\n\n[workspace]\n' \
    "$folder" >"$folder/robot/Cargo.toml"
cp examples/encoder.toml "$folder/robot/"
awk '/^```rust$/ { inside = 1; next } /^```$/ { inside = 0 } inside' docs/start.md |
    sed 's|examples/encoder|encoder|' >"$folder/robot/src/main.rs"
walk 'a robot in Rust: the macro, compiled and run' cargo run -q --manifest-path "$folder/robot/Cargo.toml"

walk 'research: the first picture, built with `--release --features lab`' \
    cargo run -q --release -p ptc-codegen --features lab -- \
    simulate examples/encoder.toml --x0 0.1,0 --plot out/x.svg -o out/x.csv

python3 -m venv "$folder/python"
walk 'Python: `pip install .`' "$folder/python/bin/pip" install -q .
walk 'Python: a run and its picture' "$folder/python/bin/python" -c "
import ptc_codegen as ptc
design = ptc.Design.load('examples/table.toml', t0=0)
ptc.simulate(design, [1, 0.5]).plot().save('out/table.svg')"

#!/bin/sh
# The first lines of someone who has what is in FOLDER and none of our tools.
#   run.sh FOLDER SCRIPT
# Runs SCRIPT in an empty home, with nothing on the path but what every system has, and FOLDER as $FILES. Who takes the crates has Rust
# and a linker too.
set -eu
files=$(cd "$1" && pwd)
script=$(cd "$(dirname "$2")" && pwd)/$(basename "$2")
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
mkdir "$place/bin" "$place/home"
for program in sh bash env cat cp ls mkdir rm mv grep sed head tail cut tr sort wc test expr dirname basename uname sha256sum \
    tar xz unzip gzip python3 dpkg dpkg-deb dpkg-query dpkg-split chmod touch find ldconfig start-stop-daemon ln readlink; do
    found=$(command -v "$program" 2>/dev/null) && ln -s "$found" "$place/bin/$program"
done
for browser in chromium chromium-browser google-chrome; do
    found=$(command -v "$browser" 2>/dev/null) && ln -sf "$found" "$place/bin/browser"
done
case $script in
*/crates.sh)
    # The programs themselves: those that rustup puts on the path look for rustup's own folder in the home.
    rust=$(rustc --print sysroot)/bin
    for program in "$rust/cargo" "$rust/rustc" $(for name in cc ld as ar; do command -v $name; done); do
        ln -s "$program" "$place/bin/"
    done
    ;;
esac
cd "$place/home"
env -i HOME="$place/home" PATH="$place/bin" LANG=C.UTF-8 FILES="$files" sh -eu "$script"

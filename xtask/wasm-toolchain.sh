#!/usr/bin/env bash
# A Rust toolchain for wasm32-unknown-unknown from Debian's packages, for machines where rustup cannot fetch one.
# Nothing is installed; everything lies in the folder given. Usage: wasm-toolchain.sh FOLDER; afterwards `. FOLDER/env`.
#
# Debian's rustc-web is a current compiler, but comes without the standard library for wasm; that is compiled from
# the matching sources.
set -euo pipefail

folder=$(mkdir -p "$1" && cd "$1" && pwd)
[[ -f $folder/env ]] && exit 0
root=$folder/root
work=$folder/making
rm -rf "$root" "$work"
mkdir -p "$root" "$work/packages" "$work/std/src"

if ! apt-cache show rustc-web >/dev/null 2>&1; then
  apt-get -qq update
fi
rust=$(apt-cache show rustc-web | sed -n 's/^Version: \([0-9]*\.[0-9]*\).*/\1/p' | head -n 1)
[[ -n $rust ]] || { echo "Debian's package rustc-web is not known here" >&2; exit 1; }
llvm=$(apt-cache depends "libstd-rust-web-$rust" | sed -n 's/.*Depends: libllvm\([0-9]*\)$/\1/p' | head -n 1)
(
  cd "$work/packages"
  apt-get -qq download rustc-web libstd-rust-web-dev "libstd-rust-web-$rust" rust-web-src rust-web-llvm \
    "libllvm$llvm" "lld-$llvm"
)
for package in "$work"/packages/*.deb; do
  dpkg -x "$package" "$root"
done

host=$root/usr/lib/$(uname -m)-linux-gnu
cat > "$work/env" <<ENV
export RUSTC=$root/usr/bin/rustc
export LD_LIBRARY_PATH=$host:$root/usr/lib/llvm-$llvm/lib
export PATH=$root/usr/bin:\$PATH
ENV

# An empty library makes cargo compile the standard one; RUSTC_BOOTSTRAP stays in this subshell.
printf '[package]\nname = "seed"\nversion = "0.0.0"\nedition = "2024"\n[lib]\ncrate-type = ["cdylib"]\n[workspace]\n' \
  > "$work/std/Cargo.toml"
touch "$work/std/src/lib.rs"
(
  . "$work/env"
  cd "$work/std"
  CARGO_TARGET_DIR=$work/std/target RUSTC_BOOTSTRAP=1 \
    cargo build --quiet --release --target wasm32-unknown-unknown -Z build-std=std,panic_abort
)
library=$root/usr/lib/rustlib/wasm32-unknown-unknown/lib
mkdir -p "$library"
cp "$work"/std/target/wasm32-unknown-unknown/release/deps/*.rlib "$library/"
mv "$work/env" "$folder/env"
rm -rf "$work" "$root/usr/src" "$root/usr/share"

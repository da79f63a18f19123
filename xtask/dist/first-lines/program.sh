# An engineer unpacks the archive and assesses an example.
grep "linux-x86_64.tar.xz" "$FILES/SHA256SUMS" > sum
cp "$FILES"/standfast-*-linux-x86_64.tar.xz .
sha256sum --quiet --check sum
tar -xf standfast-*-linux-x86_64.tar.xz
cd standfast-*-linux-x86_64
./standfast --version | grep -q "commit"
./standfast assess examples/goda-2000.toml > answer.txt
grep -q "At 112.5 % of the wave" answer.txt
test -s examples/goda-2000-section.svg
./standfast new caisson -o my.toml
./standfast assess my.toml --brief

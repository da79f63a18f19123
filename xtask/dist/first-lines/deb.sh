# An office installs the package, here into a folder, and makes a sheet.
package=$(ls "$FILES"/standfast_*_amd64.deb)
dpkg-deb --extract "$package" root
root/usr/bin/standfast sheet root/usr/share/doc/standfast/examples/goda-2000.toml --date 2026-11-21 -o sheet.html
grep -q "Goda" sheet.html
test -s root/usr/share/man/man1/standfast-assess.1.gz
test -s root/usr/share/bash-completion/completions/standfast

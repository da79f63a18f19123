# A visitor opens the page from a disk.
page=$(ls "$FILES"/standfast-explorer-*.html)
cp "$page" page.html
browser --headless --no-sandbox --disable-gpu --virtual-time-budget=20000 --dump-dom "file://$PWD/page.html" 2>/dev/null > page.txt
grep -q "slides and rocks about O" page.txt

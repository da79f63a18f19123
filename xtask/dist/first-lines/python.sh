# A professor installs the wheel and types three lines.
python3 -m venv own
own/bin/python -m pip --quiet --disable-pip-version-check install "$FILES"/standfast-*manylinux*x86_64.whl
cat > three.py <<'LINES'
import standfast
case = {"body": {"width": "15 m", "height": "12 m", "mass": "378 t/m", "friction": 0.6}, "load": [{"force": "2700 kN/m", "elevation": "11.5 m"}]}
print(standfast.assess(case).summary.answer)
LINES
own/bin/python three.py > answer.txt
grep -q "slides and rocks" answer.txt

"""``python -m standfast``: what this is, and what to type first."""

from . import __version__, _standfast

KINDS = "\n".join(f'  standfast.new("{name}", "my.toml"){"":<{8 - len(name)}}  # {title}' for name, title, _ in _standfast.beginnings())

print(
    f"""standfast {__version__}, a Python package. The program of the same name is a file of its own.

In python:

  import standfast
{KINDS}
  print(standfast.assess("my.toml").summary.answer)

help(standfast) lists the rest."""
)

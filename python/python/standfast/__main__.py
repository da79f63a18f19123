"""``python -m standfast``: what this is, and what to type first."""

from . import _standfast

COMMIT = f", commit {_standfast.__commit__}" if _standfast.__commit__ else ""
KINDS = "\n".join(f'  standfast.new("{name}", "my.toml"){"":<{8 - len(name)}}  # {title}' for name, title, _ in _standfast.beginnings())

print(
    f"""standfast {_standfast.__version__}{COMMIT}, a Python package. The program of the same name is a file of its own.

In python:

  import standfast
{KINDS}
  standfast.examples()                    # all examples of README and book, into the folder examples
  print(standfast.assess("my.toml").summary.answer)

help(standfast) lists the rest."""
)

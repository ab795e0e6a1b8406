"""The command line ``skylight-sh``: a group that imports a command, one file beside this, where it is called."""

from __future__ import annotations

import atexit
import gc
import os
import sys
from importlib import import_module
from typing import Any, NamedTuple, NoReturn

import click

from skylight_sh import MissingExtraError, UserError, __version__


class Entry(NamedTuple):
    """What ``--help`` says of a command, and the extra that brings what it imports."""

    summary: str
    extra: str = ""


# The command NAME is the function NAME of the file NAME.py.
COMMANDS = {
    "run": Entry("Run a config: sample, fit, select, export, report.", "pipeline"),
    "configs": Entry("List the configs that come with the package."),
    "init": Entry("Start a config of your own."),
    "tables": Entry("List and compare the tables of runs, and advise which to take."),
    "evaluate": Entry("Print one sky of an exported table, also as an engine reads it."),
    "export": Entry("Write a day of skies at a place on Earth, as an engine reads them.", "solar"),
    "project": Entry("Print the SH weights of a picture of the whole sphere.", "images"),
    "lightmap": Entry("Bake a table's light at the texels of a mesh, for normal maps.", "transfer"),
    "transfer": Entry("Compute what the vertices of a mesh make of the light around it.", "transfer"),
    "render": Entry("Render a config's mesh under its sky and sun, through transfer or by brute force.", "pipeline"),
    "verify": Entry("Run a released result again and compare every byte.", "pipeline"),
    "artifacts": Entry("List, show, verify and clean the artifact store.", "pipeline"),
    "config": Entry("Describe and check configs.", "pipeline"),
    "bench": Entry("Measure error against time of a config that has run.", "pipeline"),
    "stability": Entry("Stress the numerics of a config that has run.", "pipeline"),
}


class Group(click.Group):
    """Imports the command that is called alone; ends in one message where the text of an error tells all."""

    def list_commands(self, _: click.Context) -> list[str]:
        """Return the names of all commands."""
        return list(COMMANDS)

    def get_command(self, _: click.Context, cmd_name: str) -> click.Command | None:
        """Import a command."""
        if cmd_name not in COMMANDS:
            return None
        command: click.Command = getattr(import_module(f"{__name__}.{cmd_name}"), cmd_name)
        return command

    def resolve_command(self, ctx: click.Context, args: list[str]) -> tuple[str | None, click.Command | None, list[str]]:
        """Find a command by its name; a name that is not one gets the nearest one told."""
        if args[0] not in COMMANDS:
            from difflib import get_close_matches

            close = get_close_matches(args[0], COMMANDS, n=1)
            ctx.fail(f"No such command {args[0]!r}." + (f" Did you mean {close[0]!r}?" if close else ""))
        return super().resolve_command(ctx, args)

    def format_commands(self, _: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the list of commands, none of which is imported for that."""
        with formatter.section("Commands"):
            formatter.write_dl([(name, entry.summary) for name, entry in COMMANDS.items()])

    def invoke(self, ctx: click.Context) -> Any:
        """Run the command; see ``main`` for the exit codes."""
        try:
            return super().invoke(ctx)
        except BrokenPipeError:
            # Whoever read the output has seen enough.
            sys.stdout = None
            ctx.exit(0)
        except KeyboardInterrupt:
            _end(ctx, "Interrupted.", 130)
        except UserError as error:
            _end(ctx, str(error), error.code)
        except OSError as error:
            _end(ctx, str(error), 1)
        except ModuleNotFoundError as error:
            extra = COMMANDS[ctx.invoked_subcommand or ""].extra
            if not extra or (error.name or __package__).startswith(__package__.partition(".")[0]):
                raise
            told = f"`{ctx.invoked_subcommand}` needs the extra {extra}, which brings {error.name}"
            _end(ctx, f"{told}: pip install 'skylight-sh[{extra}]'", MissingExtraError.code)


def _end(ctx: click.Context, text: str, code: int) -> NoReturn:
    click.echo(f"Error: {text}", err=True)
    ctx.exit(code)


@click.group(
    cls=Group,
    epilog="""\b
Examples:
  skylight-sh run preetham              the default config; its report is reports/preetham/index.html
  skylight-sh init my.toml              a config of your own, then: skylight-sh run my.toml
  skylight-sh evaluate reports/preetham/export/skylight_sh.npz --sun-zenith 0.8 --turbidity 3

Exit codes: 0 success, 2 bad input (the message names the field and the remedy), 130 Ctrl-C, 1 any other failure.""",
)
@click.version_option(__version__, prog_name="skylight-sh")
def main() -> None:
    """Turn a light on the sphere into tiny polynomial tables of its spherical-harmonics weights.

    Results go under the current folder: reports/ for people and programs, artifacts/ for what need not be computed again.
    `skylight-sh COMMAND --help` tells more.
    """


def warn(text: str) -> None:
    """Tell the user something that ends nothing."""
    click.echo(f"Warning: {text}", err=True)


def start() -> None:
    """Run the command line as a program."""
    # A run computes with one BLAS thread in each of its own; starting more takes as long as importing NumPy.
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
    atexit.register(_leave)
    main(prog_name="skylight-sh")


def _leave() -> None:
    """Let a program that ends be: Python would look through all it has loaded for circles, a fifth of a short command.

    Two packages take what then stays for a leak, and say so: where one is loaded, Python may look.
    """
    if not sys.modules.keys() & {"OpenImageIO", "drjit"}:
        gc.freeze()

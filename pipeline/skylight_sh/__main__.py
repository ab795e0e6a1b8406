"""``python -m skylight_sh``, and the console command ``skylight-sh``."""

from skylight_sh.cli.main import main


def run() -> None:
    """Run the command line."""
    main(prog_name="skylight-sh")


if __name__ == "__main__":
    run()

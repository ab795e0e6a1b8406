"""``python -m skylight_sh``: the console command ``skylight-sh``."""

from skylight_sh.cli import start

if __name__ == "__main__":
    start()

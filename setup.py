"""What pyproject.toml cannot say: what of the source's root becomes part of a built package."""

import shutil
from pathlib import Path

from setuptools import setup
from setuptools.command.build_py import build_py

# The released benchmark's figures, which reports show.
_SPEED = Path("reports", "reference", "speed.json")


class BuildWithConfigs(build_py):
    """Copies the shipped configs, their pictures and the released figures; an editable install reads them where they are."""

    def run(self) -> None:
        """Build as usual, from nothing, then copy: what an earlier build has left is no part of this one."""
        if not self.editable_mode:
            shutil.rmtree(Path(self.build_lib, "skylight_sh"), ignore_errors=True)
        super().run()
        if not self.editable_mode:
            self.mkpath(str(Path(self.build_lib, "skylight_sh", "configs")))
            for source, target in self._configs().items():
                self.copy_file(source, target, preserve_mode=False)

    def get_outputs(self, include_bytecode: bool = True) -> list[str]:
        """Return the files of a build."""
        return super().get_outputs(include_bytecode) + list(self._configs().values())

    def _configs(self) -> dict[str, str]:
        files = sorted(path for path in Path("configs").iterdir() if path.is_file())
        found = {str(path): str(Path(self.build_lib, "skylight_sh", path)) for path in files}
        return found | {str(_SPEED): str(Path(self.build_lib, "skylight_sh", _SPEED.name))}


setup(cmdclass={"build_py": BuildWithConfigs})

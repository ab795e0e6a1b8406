"""A scene's place and dates: the light's peak then goes no higher and no lower than the sun does there."""

from __future__ import annotations

from skylight_sh import MissingExtraError
from skylight_sh.config.schema import Config


def narrowed(config: Config) -> Config:
    """Return the config with the axis of the light's peak narrowed to its scene's sun; as it is where no sun is given.

    Raises ValueError telling what is wrong with the sun's place or dates.
    """
    asked, peak = config.scene.sun, config.light.hints.peak_axis
    if asked is None or all(axis.name != peak for axis in config.axes):
        return config
    from skylight_sh.scene import solar

    try:
        least, largest = solar.zenith_range(asked.latitude, *asked.dates)
    except MissingExtraError as error:
        raise ValueError(str(error)) from error
    except ValueError as error:
        raise ValueError(f"{error}. Give two ISO dates, the first not after the second, on which the sun rises.") from error
    axes = tuple(
        axis.model_copy(update={"range": (max(least, axis.range[0]), min(largest, axis.range[1]))})
        if axis.name == peak
        else axis
        for axis in config.axes
    )
    return config.model_copy(update={"axes": axes})

"""Cameras, tone mapping, picture files and what pictures are compared by."""

from __future__ import annotations

import numpy as np
import OpenImageIO
import pytest
from skylight_sh import UserError
from skylight_sh.render import files, metrics, tone
from skylight_sh.render.camera import Camera, spread


def test_camera_field_and_handedness() -> None:
    along = Camera((1.0, 2.0, 3.0), (1.0, 9.0, 3.0), 60.0, 40, 20).directions(np.array([[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]]))
    top, bottom = along[0, 20, 0], along[-1, 20, 2]
    assert np.degrees(np.arctan2(top[2], top[1])) == pytest.approx(30.0)
    assert np.degrees(np.arctan2(bottom[2], bottom[1])) == pytest.approx(-30.0)
    # Looking north, east is on the right.
    assert along[10, 0, 0, 0] == pytest.approx(-along[10, -1, 1, 0])
    assert along[10, -1, 1, 0] > 0.0
    assert along[10, -1, 1, 0] / along[10, -1, 1, 1] == pytest.approx(2.0 * np.tan(np.pi / 6))
    assert np.linalg.norm(along, axis=-1) == pytest.approx(1.0)


@pytest.mark.parametrize("wrong", [{"field": 0.0}, {"width": 0}, {"target": (0.0, 0.0, 9.0)}, {"eye": (np.nan, 0.0, 0.0)}])
def test_camera_refuses(wrong: dict[str, object]) -> None:
    given = {"eye": (0.0, 0.0, 1.0), "target": (0.0, 5.0, 1.0), "field": 40.0, "width": 8, "height": 8} | wrong
    with pytest.raises(UserError, match="Invalid"):
        Camera(**given)


def test_spread_is_even() -> None:
    """Any box from the corner has its share of points."""
    points = spread(256)
    corners = spread(500, start=0.137)
    share = (points[np.newaxis] < corners[:, np.newaxis]).all(axis=-1).mean(axis=1)
    assert np.abs(share - corners.prod(axis=1)).max() < 4.0 / 256


def test_tone_keeps_hue_and_order() -> None:
    grey = np.geomspace(1e-3, 5.0, 50)[:, np.newaxis] * np.ones(3)
    shown = tone.display(grey, 1.0)
    assert np.diff(shown[:, 0]).min() > 0.0
    assert np.ptp(shown, axis=1).max() < 1e-12
    bright = tone.display(np.array([[3.0, 0.8, 0.1]]), 1.0)[0]
    assert 0.97 < bright[0] <= 1.0
    assert bright[0] > bright[1] > bright[2]
    # Ever brighter, one hue has no kink: the steps of all channels change little from one to the next.
    ramp = tone.display(np.geomspace(0.01, 8.0, 400)[:, np.newaxis] * np.array([1.0, 0.35, 0.15]), 1.0)
    assert np.abs(np.diff(ramp, n=2, axis=0)).max() < 0.003
    assert np.diff(ramp[:, 1]).min() > 0.0
    # Reinhard 2002, eq. 4, at luminance 1 with white 2.
    linear = (1.0 + 0.25) / 2.0
    assert tone.display(np.ones(3), 1.0, white=2.0) == pytest.approx(1.055 * linear ** (1 / 2.4) - 0.055)


def test_png_is_read_by_others(tmp_path) -> None:
    random = np.random.default_rng(1)
    smooth = np.linspace(0.0, 1.0, 23 * 17 * 3).reshape(23, 17, 3)
    for name, picture in {"noise": random.random((31, 7, 3)), "smooth": smooth}.items():
        path = tmp_path / f"{name}.png"
        path.write_bytes(files.png(picture))
        read = OpenImageIO.ImageBuf(str(path)).get_pixels(OpenImageIO.UINT8)
        assert (read == np.rint(picture * 255.0)).all()
    assert len(files.png(np.full((64, 64, 3), 0.3))) < 200


@pytest.mark.parametrize("rows", [1, 16, 37])
def test_exr_is_read_by_others(tmp_path, rows: int) -> None:
    smooth = np.linspace(-3.0, 4e4, rows * 9 * 3).reshape(rows, 9, 3)
    for name, picture in {"noise": np.random.default_rng(2).normal(size=(rows, 9, 3)) * 1e4, "smooth": smooth}.items():
        path = tmp_path / f"{name}.exr"
        path.write_bytes(files.encoded(path, picture, picture))
        read = OpenImageIO.ImageBuf(str(path))
        assert (read.get_pixels(OpenImageIO.FLOAT) == picture.astype(np.float32)).all()
        told = {attribute.name.lower() for attribute in read.spec().extra_attribs}
        assert not told & {"datetime", "software", "capdate", "hostcomputer"}
    assert len(files.exr(np.full((64, 64, 3), 0.3))) < 1000
    with pytest.raises(UserError, match=r"\.png"):
        files.check(tmp_path / "a.jpg")


def test_relative_rmse_leaves_noise_of_halves_out() -> None:
    random = np.random.default_rng(3)
    true = 1.0 + random.random(200_000)
    one, other = (true + 0.1 * random.normal(size=true.size) for _ in range(2))
    picture = true + 0.05 * random.normal(size=true.size)
    expected = metrics.relative_rmse(picture, true)
    assert expected == pytest.approx(0.05 / np.sqrt(7.0 / 3.0), rel=0.02)
    assert metrics.relative_rmse_of_halves(picture, one, other) == pytest.approx(expected, rel=0.05)


def test_flip_of_alike_and_of_opposites() -> None:
    black, white = np.zeros((32, 32, 3)), np.ones((32, 32, 3))
    assert metrics.flip(white, white) == pytest.approx(0.0, abs=1e-6)
    assert metrics.flip(black, white) > 0.9

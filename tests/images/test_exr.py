"""Images keep every layer to the last bit, and a file that cannot be trusted says so."""

import numpy as np
import OpenImageIO as oiio
import pytest

from vitrail.images import exr
from vitrail.images.exr import ImageError, read_image, write_image, write_png


@pytest.fixture
def picture():
    return np.random.default_rng(1).random((7, 11, 3)).astype(np.float32).astype(float)


def test_every_layer_survives(tmp_path, picture):
    path = tmp_path / "a.exr"
    layers = {"caustic": picture * 2, "total_internal_reflection": picture / 4}
    metadata = {"vitrail:scene_hash": "ab" * 32, "vitrail:settings": '{"photons": 1000}'}
    write_image(
        path, picture, half_a=picture / 2, half_b=picture * 4, variance=picture, layers=layers, metadata=metadata
    )
    image = read_image(path)
    np.testing.assert_array_equal(image.radiance, picture)
    np.testing.assert_array_equal(image.half_a, picture / 2)
    np.testing.assert_array_equal(image.half_b, picture * 4)
    np.testing.assert_array_equal(image.variance, picture)
    assert set(image.layers) == set(layers)
    np.testing.assert_array_equal(image.layers["caustic"], picture * 2)
    assert {key: image.metadata[key] for key in metadata} == metadata
    assert (image.width, image.height, image.pixel_type) == (11, 7, "float")


def test_a_variance_that_is_not_written_is_that_of_the_halves(tmp_path, picture):
    write_image(tmp_path / "a.exr", picture, half_a=picture * 0.5, half_b=picture * 1.5)
    image = read_image(tmp_path / "a.exr")
    np.testing.assert_array_equal(image.variance, (image.half_a - image.half_b) ** 2 / 4)
    assert image.variance.max() > 0
    write_image(tmp_path / "b.exr", picture)
    assert read_image(tmp_path / "b.exr").variance is None


def test_values_beyond_display_survive(tmp_path):
    odd = np.array([[[-1.5, 1e30, 1e-30], [np.nan, np.inf, 0.0]]], float)
    write_image(tmp_path / "odd.exr", odd)
    np.testing.assert_allclose(read_image(tmp_path / "odd.exr").radiance, odd, rtol=1e-7)


def test_missing_and_corrupt_files_are_named(tmp_path, picture):
    with pytest.raises(ImageError, match="no such image"):
        read_image(tmp_path / "none.exr")
    junk = tmp_path / "junk.exr"
    junk.write_bytes(b"this is not an image" * 40)
    with pytest.raises(ImageError, match="junk.exr: is not a readable image"):
        read_image(junk)
    whole = tmp_path / "whole.exr"
    write_image(whole, np.random.default_rng(0).random((64, 64, 3)))
    whole.write_bytes(whole.read_bytes()[: whole.stat().st_size // 2])
    with pytest.raises(ImageError, match="whole.exr"):
        read_image(whole)
    empty = tmp_path / "empty.exr"
    empty.touch()
    with pytest.raises(ImageError, match="empty.exr"):
        read_image(empty)


def test_an_8_bit_image_tells_its_type(tmp_path, picture):
    write_png(tmp_path / "a.png", picture)
    assert read_image(tmp_path / "a.png").pixel_type == "uint8"


def test_a_lone_half_is_refused(tmp_path, picture):
    write_image(tmp_path / "a.exr", picture, half_a=picture)
    with pytest.raises(ImageError, match="one of half_a, half_b"):
        read_image(tmp_path / "a.exr")


def test_an_image_without_radiance_lists_what_it_has(tmp_path, picture):
    import OpenImageIO as oiio

    spec = oiio.ImageSpec(11, 7, 1, oiio.FLOAT)
    spec.channelnames = ("depth.Z",)
    target = oiio.ImageOutput.create(str(tmp_path / "z.exr"))
    target.open(str(tmp_path / "z.exr"), spec)
    target.write_image(picture[..., :1].astype(np.float32).copy())
    target.close()
    with pytest.raises(ImageError, match="only .*Z.*rename"):
        read_image(tmp_path / "z.exr")


def test_a_cropped_image_is_refused(tmp_path, picture):
    import OpenImageIO as oiio

    spec = oiio.ImageSpec(11, 7, 3, oiio.FLOAT)
    spec.x, spec.full_width, spec.full_height = 2, 20, 7
    target = oiio.ImageOutput.create(str(tmp_path / "c.exr"))
    target.open(str(tmp_path / "c.exr"), spec)
    target.write_image(picture.astype(np.float32))
    target.close()
    with pytest.raises(ImageError, match="whole picture"):
        read_image(tmp_path / "c.exr")


def test_a_layer_of_another_size_is_not_written(tmp_path, picture):
    with pytest.raises(ImageError, match="layer caustic"):
        write_image(tmp_path / "a.exr", picture, layers={"caustic": picture[:-1]})
    with pytest.raises(ImageError, match="cannot be written"):
        write_image(tmp_path / "nowhere" / "a.exr", picture)


def with_header(path, picture, key: str, value) -> None:
    height, width = picture.shape[:2]
    spec = oiio.ImageSpec(width, height, 3, oiio.FLOAT)
    spec.attribute(key, "float[8]", value)
    target = oiio.ImageOutput.create(str(path))
    target.open(str(path), spec)
    target.write_image(np.ascontiguousarray(picture, np.float32))
    target.close()


def test_other_primaries_are_refused_and_those_of_rec_709_are_not(tmp_path, picture):
    aces = (0.713, 0.293, 0.165, 0.83, 0.128, 0.044, 0.32168, 0.33767)
    with_header(tmp_path / "aces.exr", picture, "chromaticities", aces)
    with pytest.raises(ImageError, match="has the primaries 0.713.*convert it to linear Rec. 709"):
        read_image(tmp_path / "aces.exr")
    with_header(tmp_path / "own.exr", picture, "chromaticities", (0.64, 0.33, 0.3, 0.6, 0.15, 0.06, 0.3127, 0.329))
    np.testing.assert_allclose(read_image(tmp_path / "own.exr").radiance, picture, rtol=1e-6)


def test_an_image_larger_than_any_memory_is_refused_by_its_header(tmp_path, picture, monkeypatch):
    write_image(tmp_path / "large.exr", picture)
    monkeypatch.setattr(exr, "MOST_NUMBERS", picture.size - 1)
    with pytest.raises(ImageError, match="announces 11 x 7 pixels of 3 channels"):
        read_image(tmp_path / "large.exr")


def test_integers_are_called_by_their_size(tmp_path):
    spec = oiio.ImageSpec(4, 4, 3, oiio.UINT32)
    target = oiio.ImageOutput.create(str(tmp_path / "whole.exr"))
    target.open(str(tmp_path / "whole.exr"), spec)
    target.write_image(np.ones((4, 4, 3), np.uint32))
    target.close()
    assert read_image(tmp_path / "whole.exr").pixel_type == "uint32"

# SPDX-License-Identifier: BSD-3-Clause
"""Field files are unpacked array by array, in parallel, and only as far as they are asked for."""

import struct
import zlib

import numpy as np
import pytest
from percolith import VtuError, compressed_blocks, read_vtu, vtu
from synthetic_run import write_mechanics_run

BLOCK = 1024


def packed(values: np.ndarray, block: int = BLOCK, levels: tuple[int, ...] = (1,)) -> bytes:
    """An array as the program writes it, in blocks of these levels in turn; 0 stores one as it is."""
    raw = values.tobytes()
    parts = [zlib.compress(raw[i:i + block], levels[i // block % len(levels)])
             for i in range(0, len(raw), block)]
    header = np.array([len(parts), block, len(raw) % block, *map(len, parts)], "<u8")
    return header.tobytes() + b"".join(parts)


@pytest.fixture(params=["deflate", "zlib"])
def way(request, monkeypatch):
    """Both ways to unpack a block."""
    if request.param == "zlib":
        monkeypatch.setattr(compressed_blocks, "deflate", None)
    elif compressed_blocks.deflate is None:
        pytest.skip("deflate is not installed")


@pytest.mark.parametrize("levels", [(1,), (0,), (0, 1)])
@pytest.mark.parametrize("count", [0, 1, 128, 129, 1000, 128 * 40, 128 * 40 + 77])
def test_blocks_come_together_again(way, count, levels):
    values = np.random.default_rng(count).random(count)
    unpacked = compressed_blocks.unpack(memoryview(b"before" + packed(values, levels=levels)), 6)
    assert np.array_equal(unpacked.view("<f8"), values)


@pytest.mark.parametrize("levels", [(1,), (0,)])
def test_damage_in_any_block_is_found(way, levels):
    good = packed(np.random.default_rng(1).random(128 * 40), levels=levels)
    for place in (len(good) // 3, len(good) - 3):
        damaged = bytearray(good)
        damaged[place] ^= 0xFF
        with pytest.raises(ValueError):
            compressed_blocks.unpack(memoryview(bytes(damaged)), 0)
    with pytest.raises(ValueError, match="it ends within an array"):
        compressed_blocks.unpack(memoryview(good[:-1]), 0)


def test_a_block_of_another_size_is_damage(way):
    content = bytearray(packed(np.zeros(256)))
    content[8:16] = np.array([BLOCK - 8], "<u8").tobytes()
    with pytest.raises(ValueError):
        compressed_blocks.unpack(memoryview(bytes(content)), 0)


def test_only_what_is_asked_for_is_unpacked(tmp_path, monkeypatch):
    file = write_mechanics_run(tmp_path / "run") / "fields/matrix_000001.vtu"
    asked = []
    unpack = vtu.unpack
    monkeypatch.setattr(vtu, "unpack", lambda data, offset: asked.append(offset)
                        or unpack(data, offset))
    grid = read_vtu(file)
    assert len(asked) == 1 and grid.time == 2e-3  # the time alone
    first = grid.points
    assert grid.points is first and len(asked) == 2
    assert len(grid.cells) == 1600 and len(asked) == 3
    assert "damage" in grid.cell_data and len(asked) == 3


def test_a_large_file_is_mapped_and_reads_the_same(tmp_path, monkeypatch):
    file = write_mechanics_run(tmp_path / "run") / "fields/matrix_000001.vtu"
    whole = read_vtu(file)
    monkeypatch.setattr(vtu, "_SMALL", 0)
    mapped = read_vtu(file)
    file.unlink()  # as a run does that writes its results anew
    assert np.array_equal(mapped.points, whole.points)
    assert np.array_equal(mapped.cells, whole.cells)
    for name, values in whole.cell_data.items():
        assert np.array_equal(mapped.cell_data[name], values), name


def test_an_empty_file_and_a_wrong_number_of_cells_are_told(tmp_path, monkeypatch):
    file = write_mechanics_run(tmp_path / "run") / "fields/matrix_000001.vtu"
    content = file.read_bytes()
    file.write_bytes(content.replace(b'NumberOfCells="1600"', b'NumberOfCells="1700"'))
    with pytest.raises(VtuError, match="matrix_000001.vtu"):
        _ = read_vtu(file).cells
    monkeypatch.setattr(vtu, "_SMALL", -1)
    file.write_bytes(b"")
    with pytest.raises(VtuError, match="matrix_000001.vtu"):
        read_vtu(file)


def test_zeros_in_place_of_the_arrays_are_told(tmp_path):
    file = write_mechanics_run(tmp_path / "run") / "fields/matrix_000001.vtu"
    content = file.read_bytes()
    start = content.index(b"_", content.index(b"<AppendedData")) + 1
    file.write_bytes(content[:start] + bytes(len(content) - start))
    with pytest.raises(VtuError, match="matrix_000001.vtu"):
        _ = read_vtu(file).points
    end = content.rindex(b"</AppendedData>")
    file.write_bytes(content[:start] + bytes(end - start) + content[end:])
    with pytest.raises(VtuError, match="matrix_000001.vtu"):
        _ = read_vtu(file).points


def test_a_block_of_one_byte_does_not_fill_its_place():
    block = zlib.compress(b"7")
    with pytest.raises(ValueError, match="a block of 1 bytes in place of 16"):
        compressed_blocks.unpack(memoryview(struct.pack("<4Q", 1, 16, 0, len(block)) + block), 0)

#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the notebooks of docs/notebooks and writes what they show into them.

Usage: notebooks.py [NOTEBOOK...], all of them where none is named. The package with its extension
must be importable, for instance by PYTHONPATH=build/developer/python. A notebook that fails is left
as it was, and the exit code is 1.
"""

import base64
import io
import os
import sys
import tempfile
from pathlib import Path

import nbformat
from nbclient import NotebookClient
from nbclient.exceptions import CellExecutionError
from PIL import Image
from traitlets.config import Config

FOLDER = Path(__file__).resolve().parent.parent / "docs/notebooks"
METADATA = {"kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
            "language_info": {"name": "python"}}
COLOURS = 256  # of a picture
CELL_SECONDS = 120


def notebooks() -> list[Path]:
    """All notebooks, by their names."""
    return sorted(FOLDER.glob("*.ipynb"))


def executed(path: Path, folder: Path) -> nbformat.NotebookNode:
    """The notebook as a kernel of Jupyter leaves it that runs it in `folder`. Raises
    CellExecutionError with the trace of a cell that fails."""
    notebook = nbformat.read(path, as_version=4)
    # Sockets are files, whose names must be short, and nothing is left in the home of the user.
    with tempfile.TemporaryDirectory() as own:
        config = Config()
        config.KernelManager.transport = "ipc"
        config.KernelManager.connection_file = f"{own}/kernel.json"
        surroundings = {**os.environ, "IPYTHONDIR": own, "OMP_WAIT_POLICY": "passive"}
        surroundings.pop("MPLBACKEND", None)  # figures go into the notebook
        client = NotebookClient(notebook, timeout=CELL_SECONDS, kernel_name="python3",
                                resources={"metadata": {"path": str(folder)}}, config=config)
        client.execute(env=surroundings)
    return notebook


def lighter(png: str) -> str:
    """A picture, base64, of few colours."""
    picture = Image.open(io.BytesIO(base64.b64decode(png))).convert("RGB")
    few = picture.quantize(COLOURS, Image.Quantize.FASTOCTREE, dither=Image.Dither.NONE)
    file = io.BytesIO()
    few.save(file, "png", optimize=True)
    return base64.b64encode(file.getvalue()).decode()


def shown(text: str) -> str:
    """What a screen is left with of lines that were written over."""
    return "\n".join(line.rstrip("\r").rpartition("\r")[2].rstrip() if "\r" in line else line
                     for line in text.split("\n"))


def joined(outputs: list) -> list:
    """The same with what was printed one after the other in one piece."""
    kept: list = []
    for output in outputs:
        if kept and output.output_type == "stream" and kept[-1].get("name") == output.name:
            kept[-1].text += output.text
        else:
            kept.append(output)
    return kept


def tidy(notebook: nbformat.NotebookNode) -> nbformat.NotebookNode:
    """The same with light pictures and without what differs from one run to the next."""
    notebook.metadata = nbformat.from_dict(METADATA)
    for cell in notebook.cells:
        cell.metadata = nbformat.from_dict({})
        if "outputs" in cell:
            cell.outputs = joined(cell.outputs)
        for output in cell.get("outputs", []):
            if output.output_type == "stream":
                output.text = shown(output.text)
        for output in cell.get("outputs", []):
            data = output.get("data", {})
            if "image/png" in data:
                data["image/png"] = lighter(data["image/png"])
                output["metadata"] = nbformat.from_dict({})
    return notebook


def main(names: list[str]) -> int:
    failed = 0
    for path in map(Path, names) if names else notebooks():
        try:
            with tempfile.TemporaryDirectory() as folder:
                notebook = executed(path, Path(folder))
        except CellExecutionError as error:
            print(f"{path}: {error}", file=sys.stderr)
            failed = 1
            continue
        nbformat.write(tidy(notebook), path)
        print(f"{path}: {path.stat().st_size / 1000:.0f} kB")
    return failed


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

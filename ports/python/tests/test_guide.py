"""The examples of `docs/python.md` and the notebook are run."""

from __future__ import annotations

import doctest
import os
import re
import sys
import types
from pathlib import Path
from typing import Any

import pytest

import badlog

ROOT = Path(__file__).parents[3]
GUIDE = ROOT / "docs" / "python.md"
NOTEBOOK = ROOT / "ports" / "python" / "examples" / "brownout.ipynb"


def _blocks() -> list[str]:
    return re.findall(r"```python\n(.*?)```", GUIDE.read_text(encoding="utf-8"), re.DOTALL)


def test_the_guides_examples_give_the_shown_output(monkeypatch: pytest.MonkeyPatch) -> None:
    for library in ("numpy", "pandas", "polars", "pyarrow"):
        pytest.importorskip(library)
    monkeypatch.chdir(ROOT)
    sessions = "\n".join(block for block in _blocks() if block.startswith(">>>"))
    test = doctest.DocTestParser().get_doctest(sessions, {}, "docs/python.md", str(GUIDE), 0)
    told: list[str] = []
    result = doctest.DocTestRunner(verbose=False).run(test, out=told.append)
    assert result.failed == 0, "".join(told)
    assert result.attempted > 20


def test_the_robot_of_the_guide_logs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (program,) = [block for block in _blocks() if "class Robot" in block]
    path = tmp_path / "match.bag"
    program = program.replace('"/home/lvuser/logs/match.bag"', repr(os.fspath(path)))
    wpilib: Any = types.ModuleType("wpilib")
    wpilib.TimedRobot = object
    wpilib.Timer = types.SimpleNamespace(getFPGATimestamp=lambda: 12.5)
    monkeypatch.setitem(sys.modules, "wpilib", wpilib)
    names: dict[str, Any] = {}
    exec(compile(program, str(GUIDE), "exec"), names)
    robot = names["Robot"]()
    robot.robotInit()
    for _ in range(40):
        robot.robotPeriodic()
    robot.log.close()
    recording = badlog.read(path)
    assert recording.row_count == 40 and [problem.kind.value for problem in recording.problems] == ["TRUTH_VALUES"]
    assert recording.events == [badlog.Event(12.5, "Arm/Events", "arm leaves home")]
    assert recording["Arm/Angle"].samples[-1] == 45


def test_the_notebook_runs_and_finds_the_brownout() -> None:
    nbclient = pytest.importorskip("nbclient")
    nbformat = pytest.importorskip("nbformat")
    for library in ("ipykernel", "matplotlib", "pandas", "pyarrow"):
        pytest.importorskip(library)
    notebook = nbformat.read(NOTEBOOK, as_version=4)
    cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert all(not cell.outputs for cell in cells), "Clear the notebook's outputs before it is committed."
    cells[0].source = f"import sys; sys.path.insert(0, {os.fspath(ROOT / 'ports/python/src')!r})\n{cells[0].source}"
    nbclient.NotebookClient(notebook, timeout=600, startup_timeout=600, kernel_name="python3", resources={"metadata": {"path": NOTEBOOK.parent}}).execute()
    shown = "".join(str(output) for cell in cells for output in cell.outputs)
    assert "6.73" in shown and "image/png" in shown

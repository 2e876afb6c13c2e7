"""The built package: mypy accepts its types, and its wheel has all of the package."""

from __future__ import annotations

import os
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[1]


def test_mypy_finds_no_errors() -> None:
    for library in ("mypy", "numpy"):
        pytest.importorskip(library)
    checked = subprocess.run([sys.executable, "-m", "mypy"], cwd=ROOT, capture_output=True, text=True, check=False)
    assert checked.returncode == 0, checked.stdout + checked.stderr


def test_the_wheel_contains_the_package_and_is_marked_as_typed(tmp_path: Path) -> None:
    for library in ("build", "setuptools"):
        pytest.importorskip(library)
    sources = tmp_path / "sources"
    for name in ("pyproject.toml", "README.md", "src"):
        _copy(ROOT / name, sources / name)
    command = [sys.executable, "-m", "build", "--wheel", "--no-isolation", "--outdir", str(tmp_path), str(sources)]
    subprocess.run(command, check=True, capture_output=True)
    (wheel,) = tmp_path.glob("*.whl")
    assert wheel.name.endswith("-py3-none-any.whl")
    with zipfile.ZipFile(wheel) as packed:
        held = {name for name in packed.namelist() if name.startswith("badlog/")}
    expected = {path.relative_to(ROOT / "src").as_posix() for path in (ROOT / "src" / "badlog").rglob("*") if path.suffix in (".py", ".typed")}
    assert held == expected
    imported = subprocess.run(
        [sys.executable, "-c", "import badlog, badlog.robot; print(badlog.__file__)"],
        env={**os.environ, "PYTHONPATH": str(wheel)},
        check=True,
        capture_output=True,
        text=True,
    )
    assert str(wheel) in imported.stdout


def test_a_robot_loads_no_table_library() -> None:
    program = "import sys, badlog.robot; print([name for name in ('numpy', 'pyarrow', 'pandas', 'polars') if name in sys.modules])"
    environment = {**os.environ, "PYTHONPATH": str(ROOT / "src")}
    output = subprocess.run([sys.executable, "-c", program], env=environment, check=True, capture_output=True, text=True).stdout
    assert output == "[]\n"


def _copy(source: Path, target: Path) -> None:
    if source.is_dir():
        for path in source.iterdir():
            if path.name not in ("__pycache__", "badlog.egg-info"):
                _copy(path, target / path.name)
    else:
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(source.read_bytes())

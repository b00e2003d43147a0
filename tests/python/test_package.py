# SPDX-License-Identifier: LGPL-2.1-or-later
"""The package can be built and installed without the sources and without a network, and has the program's version."""
import pathlib
import shutil
import subprocess
import sys
import zipfile

import pytest


def done(*words):
    """What a command prints."""
    said = subprocess.run([str(word) for word in words], capture_output=True, text=True)
    assert said.returncode == 0, f"{words}\n{said.stdout}{said.stderr}"
    return said.stdout


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    """The wheel, built from a copy: setuptools leaves files behind."""
    sources, copy = pathlib.Path(__file__).parents[2], tmp_path_factory.mktemp("wheel")
    for file in ("pyproject.toml", "VERSION", "LICENSE"):
        shutil.copy(sources / file, copy)
    shutil.copytree(sources / "python", copy / "python", ignore=shutil.ignore_patterns("__pycache__", "*.egg-info"))
    done(sys.executable, "-m", "pip", "wheel", "--no-build-isolation", "--no-deps", "--no-index", "--wheel-dir", copy, copy)
    file, = copy.glob("*.whl")
    return file


@pytest.fixture(scope="module")
def python(wheel):
    """A virtual environment with the wheel and the packages of the system."""
    environment = wheel.parent / "environment"
    done(sys.executable, "-m", "venv", "--without-pip", "--system-site-packages", environment)
    done(sys.executable, "-m", "pip", "--python", environment / "bin/python", "install", "--no-deps", "--no-index", wheel)
    return environment / "bin/python"


def test_its_version_is_that_of_the_program(wheel, request):
    version = done(request.config.getoption("--program"), "--version").split()[1]
    assert wheel.name == f"chaindrive-{version}-py3-none-any.whl"


def test_it_has_every_file_of_the_package(wheel, repository):
    package = repository / "python/chaindrive"
    files = {str(path.relative_to(package.parent)) for path in package.rglob("*") if path.is_file() and "__pycache__" not in path.parts}
    packed = set(zipfile.ZipFile(wheel).namelist())
    assert {"chaindrive/run.py", "chaindrive/report/page.css", "chaindrive/py.typed"} <= files
    assert files == {name for name in packed if name.startswith("chaindrive/")}


def test_it_is_imported_from_where_it_is_installed(python):
    file = done(python, "-c", "import chaindrive; print(chaindrive.__file__)").strip()
    assert file.startswith(str(python.parents[1]))


def test_it_reads_and_reports(python, simple):
    code = f"import chaindrive; print(chaindrive.open({str(simple.folder)!r}).history('spans/tight_tension', units='kN').attrs['unit'])"
    assert done(python, "-c", code).strip() == "kN"
    done(python, "-m", "chaindrive.report", simple.folder, "--output", "page.html")
    page = pathlib.Path("page.html").read_text()
    style = (pathlib.Path(__file__).parents[2] / "python/chaindrive/report/page.css").read_text()
    assert style in page


@pytest.mark.parametrize(("options", "status"), [((), 2), (("--after-run",), 0)])
def test_a_report_without_the_packages_of_debian_says_what_it_needs(repository, options, status):
    said = subprocess.run([sys.executable, "-S", "-B", repository / "python/start.py", "report", *options, "nowhere"],
                          capture_output=True, text=True)
    assert said.returncode == status
    assert "that are not installed: apt install --no-install-recommends python3-h5py" in said.stderr and "Traceback" not in said.stderr

"""Every MoorDyn file of the reference data is read; MoorDyn-F's driver files too."""

import re
import shutil
import warnings

import pytest

from moorage.errors import ModelError, MotionError
from moorage.io import read, read_driver


def _models(folder):
    for path in sorted(folder.rglob("*")):
        if path.suffix in (".dat", ".txt") and re.search(r"---.*LINE (TYPES|DICT)", path.read_text(errors="replace")):
            yield path


def test_all_models_are_read(reference):
    files = list(_models(reference))
    assert len(files) > 80
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for path in files:
            if path.name == "seafloor.txt":  # names a depth file that does not come with it
                with pytest.raises(ModelError, match=r"depth file not found: tried .*seafloor_profile_3d.txt"):
                    read(path)
            else:
                model = read(path)
                assert model.lines or model.rods, path


def test_all_drivers_are_read(reference, tmp_path):
    files = sorted(reference.rglob("md_driver*.inp"))
    assert len(files) > 20
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for k, driver in enumerate(files):
            folder = tmp_path / str(k)
            shutil.copytree(driver.parent, folder)
            if (folder / "moordyn_F.dat").exists():  # its name when it was run
                shutil.copy(folder / "moordyn_F.dat", folder / "moordyn.dat")
            try:
                case = read_driver(folder / driver.name)
            except MotionError as error:
                assert "motion file not found" in str(error)  # noqa: PT017 - some motions do not come with the cases
            else:
                assert case.duration > 0.0
                assert case.interval > 0.0


def test_case_2_starts_as_given(reference):
    model = read(reference / "r-test" / "md_case2" / "moordyn.dat")
    assert model.start == "as-given"
    assert [p.kind for p in model.points] == ["fixed", "free", "fixed"]


def test_driver_motion_moves_the_body(reference, tmp_path):
    shutil.copytree(reference / "rm3_umbilical" / "still", tmp_path / "still")
    shutil.copy(tmp_path / "still" / "moordyn_F.dat", tmp_path / "still" / "moordyn.dat")
    case = read_driver(tmp_path / "still" / "md_driver_F.inp")
    assert case.motion.coupled.shape[1] == 6
    assert (case.duration, case.interval) == (60.0, 0.01)

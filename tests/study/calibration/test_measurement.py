"""Measured curves read from CSV files."""

import math

import pytest

from asperity.errors import InputError
from asperity.study.calibration.measurement import read_measurement


def read(tmp_path, text, **options):
    path = tmp_path / "data.csv"
    path.write_text(text)
    return read_measurement(path, **options)


def test_units_in_brackets(tmp_path):
    found = read(tmp_path, "# a comment\ntorque [N*mm],angle [arcmin],time [min]\n1000,60,0\n-2000,-120,2\n")
    assert found.torque == pytest.approx([1.0, -2.0])
    assert found.angle == pytest.approx([math.pi / 180, -math.pi / 90])
    assert found.time == pytest.approx([0.0, 120.0])
    assert found.repetition == pytest.approx([0.0, 0.0])


def test_units_behind_an_underscore(tmp_path):
    found = read(tmp_path, "torque_Nm;stiffness_Nm_per_arcmin;repetition\n1;2;1\n2;3;2\n")
    assert found.stiffness == pytest.approx([2 * 180 * 60 / math.pi, 3 * 180 * 60 / math.pi])
    assert found.angle is None


@pytest.mark.parametrize(
    ("header", "rows", "expected"),
    [
        ("drift [arcmin]", "60,-30", [math.pi / 180.0, -math.pi / 360.0]),
        ("drift [arcmin/turn]", "60,-30", [math.pi / 180.0, -math.pi / 360.0]),
        ("drift_deg_per_rev", "1,-0.5", [math.pi / 180.0, -math.pi / 360.0]),
        ("drift [rad]", "0.01,-0.02", [0.01, -0.02]),
        # a joint that loses 1 % of its speed turns 0.99 of a turn while it should one: 1/99 of a turn behind each
        ("speed loss [%]", "1,-1", [2.0 * math.pi / 99.0, -2.0 * math.pi / 101.0]),
        ("Speed_Loss", "0.01,-0.01", [2.0 * math.pi / 99.0, -2.0 * math.pi / 101.0]),
        ("speed_loss [ppm]", "10000,0", [2.0 * math.pi / 99.0, 0.0]),
        # the sun turns 9.09 times for one turn of the output instead of 9 times
        ("speed ratio", "9.09,8.91", [0.02 * math.pi, -0.02 * math.pi]),
        ("speed ratio [1]", "-9.09,-9", [0.02 * math.pi, 0.0]),
    ],
)
def test_drift_from_whatever_states_it(tmp_path, header, rows, expected):
    one, other = rows.split(",")
    found = read(tmp_path, f"torque [N*m],{header}\n1,{one}\n-1,{other}\n", unloaded_ratio=-9.0)
    assert found.drift == pytest.approx(expected, rel=1e-12, abs=1e-15)
    assert found.angle is None
    assert found.stiffness is None
    assert found.measured is found.drift
    assert found.quantity.name == "drift per output turn"
    assert found.unloaded_ratio == (-9.0 if "ratio" in header else None)


def test_a_ratio_of_another_joint_or_upside_down(tmp_path):
    text = "torque [N*m],speed ratio\n1,0.111\n2,0.11\n"
    with pytest.raises(
        InputError, match=r"the speed ratio 0\.11 is far from 9, .* the speed of the input over"
    ):
        read(tmp_path, text, unloaded_ratio=-9.0)
    with pytest.raises(InputError, match="needs the ratio of the joint without creep"):
        read(tmp_path, text)


@pytest.mark.parametrize(
    ("heading", "rows"),
    [
        ("torque [N*m];angle [arcmin]", ["0,5;1,25", "1,5;2,5", "-2,0;-3,75"]),
        ("torque [N*m]\tangle [arcmin]", ["0.5\t1.25", "1.5\t2.5", "-2.0\t-3.75"]),
        ("torque,angle\nN*m,arcmin", ["0.5,1.25", "1.5,2.5", "-2.0,-3.75"]),
        ("Torque / N*m;Angle / arcmin", ["0,5;1,25", "1,5;2,5", "-2,0;-3,75"]),
        ("Moment (Nm),Twist (arcmin)", ["0.5,1.25", "1.5,2.5", "-2.0,-3.75"]),
        ('"torque [N*m]","angle [arcmin]"', ['"0.5","1.25"', '"1.5","2.5"', '"-2.0","-3.75"']),
        ("Joint: 7\nOperator,B. Smith\ntorque [N*m],angle [arcmin]", ["0.5,1.25", "1.5,2.5", "-2.0,-3.75"]),
        ("angle [arcmin]  torque [N*m]", ["1.25 0.5", "2.5 1.5", "-3.75 -2.0"]),
        ("torque [1e-3 kN*m],angle [x10 arcmin]", ["0.5,0.125", "1.5,0.25", "-2.0,-0.375"]),
    ],
)
@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16", "latin-1"])
def test_layouts_are_those_of_every_text_table(tmp_path, heading, rows, encoding):
    path = tmp_path / "data.txt"
    path.write_bytes("\r\n".join([heading, *rows]).encode(encoding))
    found = read_measurement(path)
    assert found.torque == pytest.approx([0.5, 1.5, -2.0])
    assert found.angle == pytest.approx([math.radians(angle / 60.0) for angle in (1.25, 2.5, -3.75)])


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("torque [N*m],drift\n1,2\n", "column 'drift' states no unit"),
        ("torque [N*m],drift [%]\n1,2\n", "column 'drift \\[%\\]': expected an angle"),
        ("torque [N*m],drift [mm/turn]\n1,2\n", "expected a dimensionless number"),
        ("torque [N*m],speed\n1,2\n", "column 'speed'; did you mean 'speed "),
        ("torque [N*m],speed loss [%]\n1,30\n2,1\n", "30 is not allowed; it must be between -20 and 20"),
        ("torque [N*m],speed loss [%]\n1,3\n2,3\n", "all 2 rows have the speed loss 3 %"),
        ("torque [N*m],drift [deg]\n2,3\n2,4\n", "all 2 rows have the torque 2 N"),
        ("torque [N*m],drift [deg],angle [deg]\n1,2,3\n", "one of 'angle', .* got torque, drift, angle"),
        ("", "empty"),
        ("torque,angle [rad]\n1,2\n", "states no unit"),
        ("torque [N],angle [rad]\n1,2\n", "expected a torque"),
        ("torqe [N*m],angle [rad]\n1,2\n", "did you mean 'torque'"),
        (
            "torque [N*m]\n1\n",
            "one of 'angle', 'stiffness', 'drift', 'speed loss' or 'speed ratio', got torque",
        ),
        ("torque [N*m],angle [rad]\n1,2\n1,x\n", "'x' in line 3 is not a number"),
        ("torque [N*m],angle [rad]\n1,nan\n2,1\n", "line 2, column 'angle': the value is missing"),
        (
            "torque [N*m],angle [rad]\n1,2\n1,-1e4\n",
            "line 3, column 'angle': -10000 is not allowed; .* -1000 and 1000",
        ),
        (
            "torque [kN*m],angle [rad]\n1e300,2\n",
            "1e.300 is not allowed; it must be between -1e.06 and 1e.06",
        ),
        (
            "torque [N*m],angle [rad]\n1\n",
            "no line above the table has a heading for each of its 1 column",
        ),
        ("torque [N*m],angle [rad],time [s]\n1,2,1\n2,3,0\n", "line 3: time runs backwards"),
        ("torque [N*m],stiffness [N*m/rad]\n1,2\n1,0\n", "line 3: the stiffness 0 must be positive"),
        ("torque [N*m],angle [rad],angle [deg]\n1,2,3\n", "2 columns 'angle'"),
        ("torque [N*m],angle [rad]\n", "holds no table of numbers"),
        ("torque [N*m],angle [rad]\n1,2\n", "needs at least 2 rows of numbers, got 1"),
        ("torque [N*m],angle [arcmin]\n0,0\n1,0\n", "all 2 rows have the angle 0"),
        ("torque [N*m],angle [arcmin]\n1,0\n1,2\n", "all 2 rows have the torque 1 N"),
    ],
)
def test_bad_files(tmp_path, text, message):
    with pytest.raises(InputError, match=message.replace("(", r"\(")):
        read(tmp_path, text)


def test_stiffnesses_may_all_belong_to_one_torque(tmp_path):
    found = read(tmp_path, "torque [N*m],stiffness [N*m/rad]\n2,5\n2,4\n")
    assert found.torque.tolist() == [2.0, 2.0]


def test_missing_file(tmp_path):
    with pytest.raises(InputError, match="there is no such file"):
        read_measurement(tmp_path / "none.csv")


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ('torque [N*m],angle [rad]\n"1,2\n3,4\n', "'.1' in line 2 is not a number"),
        (
            "torque [N*m],angle [rad]\n1," + "2" * 200_000 + "\n",
            "line 2 holds a number that is not finite",
        ),
        ('torque [N*m],angle [rad]\n1,"2"3\n', "holds no table of numbers"),
        ("\x1b[31m" * 1000 + "\n1\n", "data.csv: .*x1b"),
    ],
)
def test_rows_that_are_no_rows(tmp_path, text, reason):
    with pytest.raises(InputError, match=reason) as refused:
        read(tmp_path, text)
    assert str(refused.value).isprintable()


def test_only_regular_files_of_a_bounded_size(tmp_path, monkeypatch):
    for path, reason in (
        ("/dev/zero", "pipe or a device"),
        (tmp_path, "directory"),
        (tmp_path / "x", "no such"),
    ):
        with pytest.raises(InputError, match=reason):
            read_measurement(path)
    monkeypatch.setattr("asperity.study.calibration.measurement.MOST_ROWS", 2)
    assert read(tmp_path, "torque [N*m],angle [rad]\n1,2\n3,4\n").torque.size == 2
    monkeypatch.setattr("asperity.study.calibration.measurement.MOST_ROWS", 1)
    with pytest.raises(InputError, match="2 rows; at most 1 are allowed"):
        read(tmp_path, "torque [N*m],angle [rad]\n1,2\n3,4\n")
    monkeypatch.setattr("asperity.study.calibration.measurement.LARGEST_FILE", 10)
    with pytest.raises(InputError, match="at most 10 bytes are read here"):
        read(tmp_path, "torque [N*m],angle [rad]\n1,2\n3,4\n")


def test_lines_that_are_not_used_are_named(tmp_path):
    found = read(tmp_path, "Joint 7\n# warm\ntorque [N*m],angle [rad]\n1,0.1\n# pause\n2,0.2\n3,0.3\n")
    assert found.notes == (
        "not used around the table: line 1, 'Joint 7', line 2, '# warm'",
        "not used between the rows: line 5, '# pause'",
    )
    assert [found.place(row) for row in range(3)] == ["line 4", "line 6", "line 7"]


@pytest.mark.parametrize(
    "name", ["torque_comma.csv", "torque_units_row.csv", "torque_N-m.csv", "torque_in-lb.csv"]
)
def test_the_same_curve_in_other_layouts_and_units(reproducers, name):
    expected, found = (read_measurement(reproducers / each) for each in ("torque_ok.csv", name))
    assert found.torque == pytest.approx(expected.torque, abs=1e-5)  # in-lb have four decimals
    assert found.angle == pytest.approx(expected.angle, rel=1e-12)

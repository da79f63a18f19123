//! Record files: what is in them, and what is said of those that are wrong.

use standfast_motion::record::{Baseline, Record, RecordUnit};

/// The header of each component says its peak; text and numbers were put there by the agency that recorded it.
#[test]
fn smc_of_a_real_earthquake() {
    for (file, count, peak) in [
        (include_str!("../../../examples/records/np01002p_4225a_a.smc"), 7183, 222.5),
        (include_str!("../../../examples/records/np01002p_4225b_a.smc"), 7165, 84.5),
        (include_str!("../../../examples/records/np01002p_4225c_a.smc"), 7184, 272.3),
    ] {
        let record = Record::parse("a.smc", file, None, None).unwrap();
        assert_eq!(record.values.len(), count);
        assert_eq!(record.unit, RecordUnit::CentimetrePerSecondSquared);
        assert!((record.times[200] - 1.0).abs() < 1e-12);
        // The header has one digit behind the point.
        assert!((record.peak() - peak).abs() < 0.06, "{}", record.peak());
    }
}

const VALUES: &str = "  .1E-01  -.2E-01\n .3E-01 .0\n";

#[test]
fn at2_with_either_header() {
    let head =
        "PEER STRONG MOTION DATABASE RECORD\nSOMEWHERE 01/01/90\nACCELERATION TIME HISTORY IN UNITS OF G\n";
    for line in ["NPTS=    4, DT= .0050 SEC", "4   0.0050   NPTS, DT"] {
        let record = Record::parse("x.AT2", &format!("{head}{line}\n{VALUES}"), None, None).unwrap();
        assert_eq!(record.values, [0.01, -0.02, 0.03, 0.0]);
        assert_eq!((record.times[3], record.unit), (3.0 * 0.005, RecordUnit::Gravity));
    }
}

#[test]
fn csv_with_units() {
    let read = |text: &str, column| Record::parse("a.csv", text, column, None).unwrap();
    let one = read("# a pulse\ntime_s,a_g\n0,0\n0.5,0.25\n2,-0.125\n", None);
    assert_eq!(
        (one.times, one.values, one.unit),
        (vec![0.0, 0.5, 2.0], vec![0.0, 0.25, -0.125], RecordUnit::Gravity)
    );
    let two = read("time_s;x;force_kN\n0;1;2\n1;3;4\n", Some("force_kN"));
    assert_eq!((two.values, two.unit), (vec![2.0, 4.0], RecordUnit::Kilonewton));
    let three = Record::parse("a.csv", "a_cm_s2\n1\n2\n3\n", None, Some(0.25)).unwrap();
    assert_eq!((three.times, three.unit), (vec![0.0, 0.25, 0.5], RecordUnit::CentimetrePerSecondSquared));
    for (heading, unit) in [
        ("g", RecordUnit::Gravity),
        ("acc [g]", RecordUnit::Gravity),
        ("acc (G)", RecordUnit::Gravity),
        ("a [m/s²]", RecordUnit::MetrePerSecondSquared),
        ("a (cm/s^2)", RecordUnit::CentimetrePerSecondSquared),
        ("Gal", RecordUnit::CentimetrePerSecondSquared),
        ("force [kN/m]", RecordUnit::KilonewtonPerMetre),
        ("n", RecordUnit::Unnamed),
        ("swing", RecordUnit::Unnamed),
        ("force [kip]", RecordUnit::Unnamed),
    ] {
        assert_eq!(read(&format!("time_s,{heading}\n0,0\n1,1\n"), None).unit, unit, "{heading}");
    }
}

/// As pySLAMMER keeps records: a name and the heading as comments, then rows of numbers.
#[test]
fn a_header_that_is_a_comment() {
    let read = |text: &str| Record::parse("r.csv", text, None, None);
    let one = read("# Time Series: Morgan Hill 1984\n# Time (s),Acceleration (g's)\n0.00,0.01\n0.02,-0.03\n")
        .unwrap();
    assert_eq!((one.times, one.values, one.unit), (vec![0.0, 0.02], vec![0.01, -0.03], RecordUnit::Gravity));
    let steps = Record::parse("r.csv", "# a [m/s²]\n1\n2\n", None, Some(0.5)).unwrap();
    assert_eq!((steps.times, steps.unit), (vec![0.0, 0.5], RecordUnit::MetrePerSecondSquared));
    let chosen = Record::parse("r.csv", "#t [s];a [g];b [g]\n0;1;2\n1;3;4\n", Some("b [g]"), None).unwrap();
    assert_eq!((chosen.times, chosen.values), (vec![0.0, 1.0], vec![2.0, 4.0]));
    // A comment of other words, one below the first row, and times that are not in seconds are no such header.
    for (text, line) in [("# from a shaking table\n0,0\n1,1\n", 2), ("0,0\n# t,a_g\n1,1\n", 1)] {
        let said = read(text).unwrap_err().to_string();
        assert_eq!(
            said,
            format!(
                "r.csv, line {line}: \"0,0\" is not understood; expected a header with units, as time_s,a_g"
            )
        );
    }
    let twice = read("# t,t\n0,0\n1,1\n").unwrap_err().to_string();
    assert!(twice.starts_with("r.csv, line 1: there are two columns"), "{twice}");
    let thousandths = read("# time (ms),a (g)\n0,0\n20,1\n").unwrap_err().to_string();
    assert!(thousandths.starts_with("r.csv, line 1: there are several columns of values"), "{thousandths}");
}

/// Every error has the file, the line and the value.
#[test]
fn wrong_files() {
    let csv = |text: &str| Record::parse("r.csv", text, None, None).unwrap_err().to_string();
    assert_eq!(csv("time_s,a_g\n0,0\n0.1,x1\n"), "r.csv, line 3: \"x1\" is not a number");
    assert_eq!(csv("time_s,a_g\n0,0\n0.1,inf\n"), "r.csv, line 3: \"inf\" is not a finite number");
    assert_eq!(
        csv("time_s,a_g\n0,0\n0,1\n"),
        "r.csv, line 3: the time 0 is not after 0; expected times that rise"
    );
    assert_eq!(csv("time_s,a_g\n0,0\n"), "r.csv: 1 values; expected two at least");
    assert_eq!(csv("time_s,a_g\n0,0\n1\n"), "r.csv, line 3: the row 1 has 1 cells; expected 2");
    assert_eq!(
        csv("0,0\n1,1\n"),
        "r.csv, line 1: \"0,0\" is not understood; expected a header with units, as time_s,a_g"
    );
    assert_eq!(csv(" \n"), "r.csv: the file is empty");
    assert!(csv("time_s,a,b\n0,0,0\n").contains("several columns of values: \"a\", \"b\""));
    assert!(csv("a_g\n0\n").contains("no column of times"));
    let missing = Record::parse("r.csv", "time_s,a\n0,0\n1,1\n", Some("b"), None).unwrap_err();
    assert_eq!(missing.to_string(), "r.csv, line 1: there is no column \"b\"; there are \"a\"");
    let at2 = |third: &str, fourth: &str| {
        Record::parse("r.AT2", &format!("a\nb\n{third}\n{fourth}\n{VALUES}"), None, None)
            .unwrap_err()
            .to_string()
    };
    let g = "ACCELERATION TIME SERIES IN UNITS OF G";
    assert_eq!(at2(g, "NPTS= 5, DT= .01 SEC"), "r.AT2: the header says 5 values, and there are 4");
    assert!(at2(g, "NPTS= 4, DT= 0 SEC").starts_with("r.AT2, line 4: the step of time is 0"));
    assert!(at2(g, "4 values").starts_with("r.AT2, line 4: \"4 values\" is not understood"));
    assert!(at2("IN UNITS OF FURLONGS", "NPTS= 4, DT= .01").starts_with("r.AT2, line 3: "));
    let smc = include_str!("../../../examples/records/np01002p_4225a_a.smc");
    let cut: String = smc.lines().take(400).map(|line| format!("{line}\n")).collect();
    let error = Record::parse("r.smc", &cut, None, None).unwrap_err().to_string();
    assert!(error.starts_with("r.smc: the header says 7183 values, and there are "), "{error}");
}

/// A comma within a number is no other number, and quotes are those of every table.
#[test]
fn commas_and_quotes() {
    let read = |text: &str, dt| Record::parse("r.csv", text, Some("a"), dt);
    let said = |text: &str, dt| read(text, dt).unwrap_err().to_string();
    assert_eq!(
        said("a\n0,0\n9,5\n", Some(0.5)),
        "r.csv, line 2: the row 0,0 has 2 cells; expected 1, as the header has, and numbers with a decimal point, not a comma"
    );
    let comma = |value| {
        format!("\"{value}\" is written with a comma; expected a decimal point and nothing between thousands")
    };
    assert_eq!(said("t,a\n0,0\n1,\"2,500\"\n", None), format!("r.csv, line 3: {}", comma("2,500")));
    assert_eq!(said("# c\nt;a\n0;0\n\n0,5;1\n", None), format!("r.csv, line 5: {}", comma("0,5")));
    assert_eq!(said("t\ta\n0\t1.234,5\n", None), format!("r.csv, line 2: {}", comma("1.234,5")));
    assert!(
        said("t,a\n0,0\n1,2,3\n", None).starts_with("r.csv, line 3: the row 1,2,3 has 3 cells; expected 2")
    );
    assert_eq!(
        said("t,a,b,a\n0,0,0,0\n", None),
        "r.csv, line 1: there are two columns \"a\"; expected names that differ"
    );
    let quoted = read("\"t\",\"what, how\",\"a\"\n0,\"x, \"\"y\"\"\",\"1.5\"\n\n1,,2\n", None).unwrap();
    assert_eq!((quoted.times, quoted.values), (vec![0.0, 1.0], vec![1.5, 2.0]));
    assert!(said("t,a\n0,0\n1, \"2\"\n", None).starts_with("r.csv, line 3: \"2\": a quote"));
    assert!(said("t,a\n0,0\n1,\"2\n2,3\n", None).starts_with("r.csv, line 3: 1,\"2: a quote"));
    assert!(said("t, \"a\"\n0,0\n", None).starts_with("r.csv, line 1: \"a\": a quote"));
}

/// Bytes that are no lines of text are not shown as if they were.
#[test]
fn other_encodings() {
    let said = |text: &str| Record::parse("r.csv", text, None, None).unwrap_err().to_string();
    assert_eq!(said("t,a_g\r0,0\r1,1\r"), "r.csv: its lines end in CR alone; expected LF or CR LF");
    let wide: Vec<u8> = "\u{feff}t,a_g\n0,0\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    let wide = said(&String::from_utf8_lossy(&wide));
    assert_eq!(wide, "r.csv: it has bytes of value 0, as UTF-16 text has; expected UTF-8");
    assert_eq!(said("t\u{1},a\u{2},b\n0,1,2\n").matches(char::is_control).count(), 0);
    let wide: Vec<String> = (0..1000).map(|i| format!("a{i}")).collect();
    assert!(said(&(wide.join(",") + "\n")).len() < 200);
    let crlf = Record::parse("r.csv", "t,a_g\r\n0,0\r\n1,1\r\n", None, None).unwrap();
    assert_eq!(crlf.values, [0.0, 1.0]);
}

/// Points that no instrument takes are refused by their values.
#[test]
fn steps_that_are_no_seconds() {
    use standfast::number::exact;
    let said = |text: &str, dt| Record::parse("r.csv", text, None, dt).unwrap_err().to_string();
    assert!(said("a_g\n0\n1\n", Some(1e-300)).contains("is 1e-300; expected"));
    for dt in [1e-300, 9e-10, 0.0, -1.0, f64::INFINITY, f64::NAN] {
        let expected = format!(
            "r.csv, line 1: the step of time is {}; expected a number of seconds, 1e-9 at least",
            exact(dt)
        );
        assert_eq!(said("a_g\n0\n1\n", Some(dt)), expected);
    }
    assert_eq!(
        said("t,a_g\n0,0\n1e-12,1\n", None),
        "r.csv, line 3: the time 1e-12 is less than 1e-9 s after 0; expected times in s"
    );
    assert!(Record::parse("r.csv", "a_g\n0\n1\n2\n3\n", None, Some(1e-9)).is_ok());
}

/// A line under a record is found again, and the drift of a constant acceleration is that of a falling stone.
#[test]
fn baselines_and_drift() {
    let times: Vec<f64> = (0..200).map(|i| f64::from(i) * 0.01).collect();
    let record = |f: &dyn Fn(f64) -> f64| Record {
        times: times.clone(),
        values: times.iter().map(|t| f(*t)).collect(),
        unit: RecordUnit::Gravity,
    };
    let line = record(&|t| 0.3 - 0.7 * t);
    assert!(line.clone().corrected(Baseline::Linear).peak() < 1e-14);
    let mean: f64 = line.corrected(Baseline::Mean).values.iter().sum();
    assert!(mean.abs() < 1e-12);
    let [v, x] = record(&|_| 2.0).drift();
    assert!((v - 2.0 * 1.99).abs() < 1e-12 && (x - 1.99 * 1.99).abs() < 1e-12);
    let [v, x] = record(&|t| t).drift();
    assert!((v - 1.99f64.powi(2) / 2.0).abs() < 1e-12 && (x - 1.99f64.powi(3) / 6.0).abs() < 1e-12);
}

/// Bodies of many sizes under a real record at many strengths, both components: thousands of impacts near rest, and each motion comes to an
/// end with its energy accounted for.
#[test]
fn bodies_under_a_real_record() {
    use standfast::contact::Block;
    use standfast_motion::{End, Impact, Keep, MotionProblem, simulate};
    let read = |text| Record::parse("a.smc", text, None, None).unwrap();
    let horizontal = read(include_str!("../../../examples/records/np01002p_4225c_a.smc"));
    let vertical = read(include_str!("../../../examples/records/np01002p_4225b_a.smc"));
    let (mut impacts, mut ends) = (0, [0; 5]);
    for (b, γ) in [(0.05, 1.0_f64), (0.2, 4.0), (1.0, 2.0), (0.1, 8.0)] {
        for μ in [0.1, 0.4, 1.0] {
            for scale in [0.5, 1.5, 4.0] {
                for law in [Impact::Inelastic, Impact::Ratio(0.97)] {
                    let mut block = Block::uniform(γ, μ);
                    (block.b1, block.b2, block.d) = (b, b, γ * b);
                    block.rho2 *= b * b;
                    let mut problem = MotionProblem::new(block, 9.81);
                    problem.impact = law;
                    problem.base.horizontal = Some(horizontal.history(0.01 * scale).unwrap());
                    problem.base.vertical = Some(vertical.history(0.01 * scale).unwrap());
                    let outcome = simulate(&problem, Keep::default()).unwrap();
                    let largest =
                        outcome.work.abs().max(outcome.impact_loss).max(outcome.potential.abs()).max(1e-9);
                    assert!(outcome.energy_residual().abs() < 1e-10 * largest, "{b} {γ} {μ} {scale} {law:?}");
                    ends[outcome.end as usize] += 1;
                    impacts += outcome.impacts;
                }
            }
        }
    }
    assert_eq!(ends[End::AtRest as usize] + ends[End::Overturned as usize], 72, "{ends:?}");
    assert!(impacts > 5000 && ends[End::Overturned as usize] > 5, "{impacts} {ends:?}");
}

/// A slip of units is refused before a motion is followed under it, whatever the unit of gravity.
#[test]
fn shakings_beyond_all_measure_are_refused() {
    use standfast::contact::Block;
    use standfast_motion::{Keep, MotionError, MotionProblem, simulate};
    let record = Record::parse("r.csv", "t,a_g\n0,0\n1,2\n2,-3\n3,0\n", None, None).unwrap();
    let followed = |factor: f64, gravity: f64, vertical: bool| {
        let mut problem = MotionProblem::new(Block::uniform(2.0, 0.5), gravity);
        let history = Some(record.history(factor).unwrap());
        if vertical {
            problem.base.vertical = history;
        } else {
            problem.base.horizontal = history;
        }
        simulate(&problem, Keep::default())
    };
    for (vertical, name) in [(false, "horizontal"), (true, "vertical")] {
        for (factor, gravity) in [(1e308, 9.81), (1e7, 9.81), (1e6, 1.0), (-4e6, 9.81)] {
            let error = followed(factor, gravity, vertical).unwrap_err();
            let peak = 3.0 * f64::abs(factor);
            assert_eq!(error, MotionError::Acceleration { name, peak, most: 1e6 * gravity });
        }
    }
    assert_eq!(
        followed(1e7, 9.81, true).unwrap_err().to_string(),
        "the acceleration `vertical` of the base has a peak of 30000000; expected 9810000 at most, a million times gravity"
    );
    assert!(followed(10.0, 9.81, true).is_ok() && followed(10.0, 9.81, false).is_ok());
}

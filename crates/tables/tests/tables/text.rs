//! Tables of text against scalar calls of the library; whatever a text holds, it is answered or refused.

use proptest::prelude::*;
use standfast::Point;
use standfast::Wrench;
use standfast::contact::{Block, solve};
use standfast::ground::strength::CrushPoint;
use standfast_tables::{OnError, ResultColumn, TableError, TableOptions, TablePlace, TableProblem, run};

use crate::mutated::{mutated, number};

/// Text that may stand where it should not.
const ODD: &[&str] = &["-1e999", ",,,"];

const TABLE: &str = include_str!("../../../../examples/points.csv");

/// Numbers from 0 to 1, the same in every run.
fn random() -> impl FnMut() -> f64 {
    let mut state: u64 = 2026;
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1_u64 << 53) as f64
    }
}

/// A column omega makes bases that crush; without it, and where it is zero, the base is rigid.
#[test]
fn a_column_omega_is_the_share_of_a_base_that_crushes() {
    let mut random = random();
    let mut table = String::from("omega,gamma,k_prime,k,mu\n");
    let mut points = Vec::new();
    for i in 0..600 {
        let [gamma, k_prime] = [0.3 + 3.0 * random(), 3.0 * random() - 1.8];
        let [k, mu] = [4.0 * random(), 3.0 * random()];
        let omega = if i % 3 == 0 { 0.0 } else { 1.2 * random() };
        table += &format!("{omega},{gamma},{k_prime},{k},{mu}\n");
        points.push(CrushPoint::new(gamma, k_prime, k, mu, omega).expect("a point"));
    }
    let answered = |options: &TableOptions| {
        let mut answer = Vec::new();
        run(table.as_bytes(), &mut answer, options).expect("a table");
        let mut reader = csv::Reader::from_reader(&answer[..]);
        reader.records().map(|record| record.expect("a row")).collect::<Vec<_>>()
    };
    let all = answered(&TableOptions::new("table"));
    let modes = answered(&TableOptions { columns: vec![ResultColumn::Mode], ..TableOptions::new("table") });
    let mut failed = 0;
    for ((record, only), point) in all.iter().zip(&modes).zip(&points) {
        let verdict = point.verdict();
        assert_eq!([&record[5], &only[5]], [verdict.symbol(); 2], "{point:?}");
        assert_eq!([&record[6], &record[7]], [point.is_unique().to_string(), point.others().to_string()]);
        let found: Vec<&str> = record.iter().skip(8).collect();
        match point.motion() {
            Some(begun) => {
                let found: Vec<f64> = found.iter().map(|field| field.parse().expect("a number")).collect();
                let motion = begun.motion;
                assert_eq!((found[2], found[5]), (motion.theta_ddot, motion.xi));
            }
            None => {
                assert!(found.iter().all(|field| field.is_empty()));
                failed += 1;
            }
        }
    }
    assert!(failed > 30, "{failed} of them fail");

    // It is said once that it is no angular frequency, of the rows in which it is not zero; not where one has said so.
    let said = |options: &TableOptions| run(table.as_bytes(), Vec::new(), options).expect("a table").minded;
    for threads in [1, 3] {
        let minded = said(&TableOptions { threads, ..TableOptions::new("table") });
        let [warning] = &minded[..] else { panic!("{minded:?}") };
        let (name, rows, first) = (warning.name, warning.rows, warning.first);
        assert_eq!((name, rows, first), ("omega-as-share", 400, 1));
        let value = table.lines().nth(2).and_then(|line| line.split(',').next()).expect("a value");
        assert!(
            warning.words.contains(value) && warning.words.contains("--map \"omega=omega\""),
            "{warning}"
        );
    }
    let map = vec!["omega=omega".parse().expect("a mapping")];
    assert_eq!(said(&TableOptions { map, ..TableOptions::new("table") }), []);

    let mapped = "gamma,k_prime,k,mu,share\n0.8,0.9167,0.61,0.6,0.08\n";
    let options =
        TableOptions { map: vec!["omega=share".parse().expect("a mapping")], ..TableOptions::new("table") };
    for (options, mode) in [(options, "RO"), (TableOptions::new("table"), "SL")] {
        let mut answer = Vec::new();
        run(mapped.as_bytes(), &mut answer, &options).expect("a table");
        let answer = String::from_utf8(answer).expect("text");
        assert!(answer.lines().nth(1).expect("a row").contains(&format!(",{mode},true,")), "{answer}");
    }
    let wrong = "omega,gamma,k_prime,k,mu\n-0.2,1,0.4,0.5,0.6\n";
    let error = run(wrong.as_bytes(), Vec::new(), &TableOptions::new("table")).expect_err("an error");
    let text = error.to_string();
    assert!(text.contains("omega") && text.contains("-0.2") && text.contains("from 0 to 1e50"), "{text}");
}

#[test]
fn every_row_is_a_scalar_call() {
    let mut random = random();
    let mut points = Vec::new();
    let mut table = String::from("name,mu,k_prime,\"a, b\",gamma,k\n");
    for i in 0..2000 {
        let gamma = 10_f64.powf(2.0 * random() - 1.0);
        let k_prime = 3.0 * random() - 1.8;
        let k = 6.0 * random();
        let mu = 4.0 * random();
        table += &format!("\"row {i}, \"\"so\"\"\",{mu},{k_prime},,{gamma},{k}\n");
        points.push(Point::new(gamma, k_prime, k, mu).expect("a point"));
    }
    let mut answer = Vec::new();
    let summary = run(table.as_bytes(), &mut answer, &TableOptions::new("table")).expect("a table");
    assert_eq!((summary.rows, summary.bad), (2000, 0));

    let mut reader = csv::Reader::from_reader(&answer[..]);
    let header = reader.headers().expect("a header").clone();
    assert_eq!(
        header.iter().collect::<Vec<_>>().join("|"),
        "name|mu|k_prime|a, b|gamma|k|mode|unique|also|x_ddot|y_ddot|theta_ddot|f_x|f_y|xi"
    );
    let mut seen = std::collections::BTreeSet::new();
    let mut rows = 0;
    for (i, (record, point)) in reader.records().zip(&points).enumerate() {
        let record = record.expect("a row");
        assert_eq!(&record[0], format!("row {i}, \"so\""));
        assert_eq!(record[4].parse(), Ok(point.gamma()));
        assert_eq!(&record[6], point.mode().symbol());
        assert_eq!(&record[7], point.is_unique().to_string());
        assert_eq!(&record[8], point.others().to_string());
        let motion = point.motion();
        let expected = [motion.x_ddot, motion.y_ddot, motion.theta_ddot, motion.f_x, motion.f_y, motion.xi];
        let found: Vec<f64> = record.iter().skip(9).map(|field| field.parse().expect("a number")).collect();
        assert_eq!(found, expected);
        seen.insert(point.mode().symbol());
        rows += 1;
    }
    assert_eq!(rows, 2000);
    assert_eq!(seen.into_iter().collect::<Vec<_>>().join(" "), "RE RO RO' SL SRO'- SRO+ SRO-");
}

#[test]
fn every_wrench_is_a_scalar_call() {
    let mut random = random();
    let mut table = String::from("m,p,x,id,mu_k,mu_s,m_y,m_x,rho2,d,b2,b1\n");
    let mut answers = Vec::new();
    for i in 0..2000 {
        let mut between = |low: f64, high: f64| low + (high - low) * random();
        let [b1, b2, d] = [(); 3].map(|()| between(0.3, 2.0));
        let (rho2, m_x, m_y) = (between(0.2, 2.0), between(1.0, 2.0), between(1.0, 1.5));
        let mu_s = between(0.0, 3.0);
        let mu_k = if i % 2 == 0 { mu_s } else { mu_s * between(0.5, 1.0) };
        let wrench = Wrench { x: between(-3.0, 3.0), p: between(-0.3, 1.5), m: between(-3.0, 3.0) };
        let Wrench { x, p, m } = wrench;
        table += &format!("{m},{p},{x},row {i},{mu_k},{mu_s},{m_y},{m_x},{rho2},{d},{b2},{b1}\n");
        answers.push(solve(&Block { b1, b2, d, rho2, m_x, m_y, mu_s, mu_k }, &wrench).expect("an answer"));
    }
    let options = TableOptions { problem: TableProblem::Wrench, ..TableOptions::new("table") };
    let mut output = Vec::new();
    let summary = run(table.as_bytes(), &mut output, &options).expect("a table");
    assert_eq!((summary.rows, summary.bad), (2000, 0));

    let mut reader = csv::Reader::from_reader(&output[..]);
    let header = reader.headers().expect("a header").iter().skip(12).collect::<Vec<_>>().join(",");
    assert_eq!(header, "modes,mode,x_ddot,y_ddot,theta_ddot,f_x,f_y,xi");
    let mut seen = std::collections::BTreeSet::new();
    for (record, answer) in reader.records().zip(&answers) {
        let record = record.expect("a row");
        assert_eq!(&record[12], answer.modes.to_string());
        let mode = answer.mode().expect("a mode");
        assert_eq!(&record[13], mode.symbol());
        let motion = answer.motion(mode).expect("a motion");
        let expected = [motion.x_ddot, motion.y_ddot, motion.theta_ddot, motion.f_x, motion.f_y, motion.xi];
        let found: Vec<f64> = record.iter().skip(14).map(|field| field.parse().expect("a number")).collect();
        assert_eq!(found, expected);
        seen.insert(mode.symbol());
    }
    assert_eq!(seen.len(), 10, "{seen:?}");
}

#[test]
fn lines_are_counted_through_blank_lines_quoted_fields_and_both_line_ends() {
    for end in ["\n", "\r\n"] {
        for mark in ["", "\u{feff}"] {
            let lines =
                ["k,mu,gamma,k_prime,n", "1,1,1,1,\"a", "b\"", "", "", "1,1,1,1,x", "1,-1,1,1,x", "", "1,1"];
            for (last, expected) in [(7, 7), (9, 7)] {
                for tail in ["", end] {
                    let table = mark.to_owned() + &lines[..last].join(end) + tail;
                    match run(table.as_bytes(), Vec::new(), &TableOptions::new("t")) {
                        Err(TableError::Row { place, .. }) => {
                            assert_eq!(place, TablePlace::Line(expected), "{table:?}")
                        }
                        other => panic!("{other:?}"),
                    }
                }
            }
        }
    }
}

#[test]
fn bad_rows_may_stay_empty() {
    let table = "gamma,k_prime,k,mu,id\n0,1,1,1,a\n1,1,2,5,b\n1,1\n";
    let options = TableOptions { on_error: OnError::Null, ..TableOptions::new("points.csv") };
    let mut answer = Vec::new();
    let summary = run(table.as_bytes(), &mut answer, &options).expect("a table");
    assert_eq!((summary.rows, summary.bad), (3, 2));
    let first = summary.first.expect("a bad row").to_string();
    assert_eq!(
        first,
        "points.csv, line 2, column gamma: \"0\"; expected a number above zero, from 1e-50 to 1e50"
    );
    let lines: Vec<_> = std::str::from_utf8(&answer).expect("text").lines().collect();
    assert_eq!(lines[1], "0,1,1,1,a,,,,,,,,,");
    assert_eq!(lines[2], "1,1,2,5,b,RO,true,,-1.125,1.125,1.125,0.875,2.125,-1.0");
    assert_eq!(lines[3], "1,1,,,,,,,,,,,,");
}

fn try_table(bytes: &[u8]) {
    for on_error in [OnError::Stop, OnError::Null] {
        let options = TableOptions { on_error, ..TableOptions::new("t") };
        if let Err(error) = run(bytes, Vec::new(), &options) {
            assert!(!standfast_cases::report(&error).is_empty());
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn any_bytes_are_no_table(bytes in any::<Vec<u8>>()) {
        try_table(&bytes);
    }

    #[test]
    fn mutated_tables(bytes in mutated(TABLE, ODD)) {
        try_table(&bytes);
    }

    #[test]
    fn rows_of_any_bytes(bytes in any::<Vec<u8>>()) {
        try_table(&[b"gamma,k_prime,k,mu,id\n1,1,1,1,".as_slice(), &bytes].concat());
    }

    #[test]
    fn extreme_rows(gamma in number(), k_prime in number(), k in number(), mu in number(), below in any::<bool>()) {
        let k_prime = if below { -k_prime } else { k_prime };
        try_table(format!("gamma,k_prime,k,mu\n{gamma},{k_prime},{k},{mu}\n").as_bytes());
    }
}

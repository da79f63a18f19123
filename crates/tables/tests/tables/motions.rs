//! Tables of motions against tables of cases: one text, one error.

use standfast_cases::{CaseFile, Explained};
use standfast_tables::{CaseTable, MotionTable, OnError, TableError, TableHead, TableOptions, run};

const AT_REST: &str = "[body]\nwidth = 2\nheight = 3\ndensity = 800\nfriction = 0.3\n\
    [[load]]\nforce = 25e3\nelevation = 1.2\n";
const IN_TIME: &str = "history = { shape = \"triangle\", rise = 0.5, duration = 1 }\n[motion]\n";

fn file(text: &str) -> CaseFile {
    CaseFile::parse("case.toml", text).unwrap()
}

fn no_file(file: &str) -> Result<String, String> {
    Err(format!("no file {file}"))
}

/// The error of a table whose rows are cases.
fn of_cases(text: &[u8]) -> Option<TableError> {
    let case = CaseTable::of(file(AT_REST)).unwrap();
    let options =
        TableOptions { case: Some(case.into()), on_error: OnError::Stop, ..TableOptions::new("table.csv") };
    run(text, Vec::new(), &options).err()
}

/// The error of a table whose rows are motions.
fn of_motions(text: &[u8]) -> Option<TableError> {
    let answered = || {
        let table = MotionTable::read(text, "table.csv", TableHead::default())?;
        let rows = table.varying(&file(&format!("{AT_REST}{IN_TIME}")))?;
        for (i, row) in table.rows().iter().enumerate() {
            let cells: Vec<&str> = row.cells.iter().map(String::as_str).collect();
            let fault = |fault| table.problem(i, fault);
            let problem = row.problem.clone().or_else(|| rows.answer(&cells, &no_file).map_err(fault).err());
            if let Some(problem) = problem {
                return Err(table.error(i, problem));
            }
        }
        Ok(())
    };
    answered().err()
}

/// What a person gets wrong in a table is refused in the same words, with the same place, whatever its rows are.
#[test]
fn errors_are_those_of_tables_of_cases() {
    let wrong: [&[u8]; 19] = [
        b"",
        b"\n\n",
        b"friction|body.width\n0,3|2\n",
        b"friction;body.width\n0,3;two\n",
        b"friction\tbody.width\n0.3\t2\t5\n",
        b"friction,body.width\n0.3,2\n\n0.3,2,5\n",
        b"friction,body.width\n0.3,2\n0.3\n",
        b"friction,note\r\n0.3,\"two\r\nlines\"\r\n0.3\r\n",
        b"friction,body.width\n0,3,2\n",
        b"friction,body.width\n0.3,two\n",
        b"friction,body.width\n0.3,\n",
        b"friction,body.width\n0.3,-2\n",
        b"friction,body.width [kg]\n0.3,2\n",
        b"body.width,body.width\n2,3\n",
        b"friction,body.friction\n0.3,0.3\n",
        b"friction,note\n0.3,\xff\n",
        b"friction,body.width\n0.3,2\n\"0.3,2\n",
        b"body.widht\n2\n",
        b"load[1].forse,friction\n2,1\n",
    ];
    for text in wrong {
        let shown = String::from_utf8_lossy(text);
        let expected = of_cases(text).unwrap_or_else(|| panic!("{shown}: not refused"));
        let found = of_motions(text).unwrap_or_else(|| panic!("{shown}: not refused"));
        assert_eq!(found.to_string(), expected.to_string(), "{shown}");
        // The numbers that a help lists are those of either case.
        let advice =
            |error: TableError| error.help().map(|help| help.split("its numbers").next().map(str::to_owned));
        assert_eq!(advice(found), advice(expected), "{shown}");
    }
}

/// Nothing is wrong with a mark of byte order, with lines that end as on Windows, or with blank ones.
#[test]
fn what_is_right_is_read() {
    let right: [&[u8]; 3] =
        [b"\xef\xbb\xbffriction\n0.3\n", b"friction,note\r\n0.3,\"a,b\"\r\n", b"friction\n\n0.3\n\n\n"];
    for text in right {
        assert_eq!(of_motions(text).map(|error| error.to_string()), None);
        let table = MotionTable::read(text, "table.csv", TableHead::default()).unwrap();
        assert_eq!((table.columns()[0].as_str(), table.rows().len()), ("friction", 1));
        assert_eq!(table.rows()[0].cells[0], "0.3");
    }
}

//! Rows of CSV text as columns of Arrow.

use std::sync::Arc;

use arrow_array::{ArrayRef, Float64Array, RecordBatch, StringArray};
use arrow_schema::{DataType, Field, Schema, SchemaRef};

use crate::text::{Header, Parsed, Rows, lossy};

impl Header {
    /// The fields of a table with these columns: text, but for the columns of the problem.
    pub(crate) fn schema(&self) -> SchemaRef {
        let field = |(place, name): (usize, &String)| {
            let number = self.places.contains(&place);
            Field::new(name, if number { DataType::Float64 } else { DataType::Utf8 }, true)
        };
        Arc::new(Schema::new(self.names.iter().enumerate().map(field).collect::<Vec<_>>()))
    }

    /// The rows as columns of Arrow, followed by the results.
    pub(crate) fn batch(&self, parsed: &Parsed, results: Vec<ArrayRef>, schema: &SchemaRef) -> RecordBatch {
        let number = |place: usize| self.places.iter().position(|&number| number == place);
        // A number in another unit than its value's stays as it is written.
        let in_unit = |place: usize| number(place).and_then(|i| self.task.unit(i));
        let as_text: Vec<bool> =
            (0..self.names.len()).map(|place| number(place).is_none() || in_unit(place).is_some()).collect();
        let mut texts: Vec<Vec<Option<String>>> = vec![Vec::new(); self.names.len()];
        if as_text.contains(&true) {
            let mut rows = Rows::new(&parsed.bytes, self.separators);
            while rows.advance() {
                for (place, column) in texts.iter_mut().enumerate().filter(|(place, _)| as_text[*place]) {
                    let field = rows.record.get(place).filter(|field| !field.is_empty());
                    column.push(field.map(lossy));
                }
            }
        }
        let column = |(place, texts): (usize, Vec<Option<String>>)| -> ArrayRef {
            let Some(numbers) = number(place).map(|i| &parsed.numbers[i]) else {
                return Arc::new(StringArray::from(texts));
            };
            let present = |number: f64| (!number.is_nan()).then_some(number);
            match in_unit(place) {
                None => Arc::new(Float64Array::from_iter(numbers.iter().map(|number| present(*number)))),
                Some(unit) => {
                    let written = |text: &Option<String>| text.as_ref()?.trim().parse().ok();
                    let number = |(number, text): (&f64, &Option<String>)| {
                        present(*number).map(|number| written(text).unwrap_or_else(|| unit.of_si(number)))
                    };
                    Arc::new(Float64Array::from_iter(numbers.iter().zip(&texts).map(number)))
                }
            }
        };
        let columns = texts.into_iter().enumerate().map(column).chain(results).collect();
        RecordBatch::try_new(schema.clone(), columns)
            .expect("columns of one length and of the schema's types")
    }
}

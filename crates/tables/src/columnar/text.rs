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
        let mut texts: Vec<Vec<Option<String>>> = vec![Vec::new(); self.names.len()];
        if self.places.len() < self.names.len() {
            let mut rows = Rows::new(&parsed.bytes);
            while rows.advance() {
                for (place, column) in texts.iter_mut().enumerate() {
                    let field = rows.record.get(place).filter(|field| !field.is_empty());
                    if !self.places.contains(&place) {
                        column.push(field.map(lossy));
                    }
                }
            }
        }
        let column = |(place, texts): (usize, Vec<Option<String>>)| -> ArrayRef {
            match self.places.iter().position(|&number| number == place) {
                Some(i) => Arc::new(Float64Array::from_iter(
                    parsed.numbers[i].iter().map(|number| (!number.is_nan()).then_some(*number)),
                )),
                None => Arc::new(StringArray::from(texts)),
            }
        };
        let columns = texts.into_iter().enumerate().map(column).chain(results).collect();
        RecordBatch::try_new(schema.clone(), columns)
            .expect("columns of one length and of the schema's types")
    }
}

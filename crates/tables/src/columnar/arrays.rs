//! Results as columns of Arrow.

use std::sync::Arc;

use arrow_array::types::Int8Type;
use arrow_array::{ArrayRef, BooleanArray, DictionaryArray, Float64Array, Int8Array, StringArray};
use arrow_schema::{DataType, Field};
use standfast::Mode;

use crate::ResultColumn;
use crate::answers::{NO_MODE, Task, Values};

impl Task {
    /// The results' names and types in Arrow.
    pub(crate) fn fields(&self) -> Vec<Field> {
        let field = |&column: &ResultColumn| Field::new(column.name(), Values::data_type(column), true);
        self.results.iter().map(field).collect()
    }
}

impl Values {
    fn data_type(column: ResultColumn) -> DataType {
        match column {
            // One byte a row in memory, and three or four bits in Parquet.
            ResultColumn::Mode => DataType::Dictionary(Box::new(DataType::Int8), Box::new(DataType::Utf8)),
            ResultColumn::Modes | ResultColumn::Also => DataType::Utf8,
            ResultColumn::Unique => DataType::Boolean,
            _ => DataType::Float64,
        }
    }

    /// The results as an array of Arrow.
    pub(crate) fn into_array(self, symbols: &ArrayRef) -> ArrayRef {
        match self {
            Values::Mode(codes) => {
                let missing = codes.contains(&NO_MODE);
                let keys: Int8Array = if missing {
                    codes.into_iter().map(|code| (code != NO_MODE).then_some(code.cast_signed())).collect()
                } else {
                    Int8Array::from_iter_values(codes.into_iter().map(u8::cast_signed))
                };
                Arc::new(DictionaryArray::<Int8Type>::new(keys, symbols.clone()))
            }
            Values::Modes(sets) => {
                let texts = sets.into_iter().map(|set| set.map(|modes| modes.to_string()));
                Arc::new(texts.collect::<StringArray>())
            }
            Values::Flag(flags) => Arc::new(BooleanArray::from(flags)),
            Values::Number(numbers) => {
                let numbers = Float64Array::from(numbers);
                if !numbers.values().iter().any(|number| number.is_nan()) {
                    return Arc::new(numbers);
                }
                Arc::new(
                    numbers
                        .iter()
                        .map(|number| number.filter(|number| !number.is_nan()))
                        .collect::<Float64Array>(),
                )
            }
        }
    }
}

/// The symbols of all modes, in the order of their codes: the dictionary of the column `mode`.
pub(crate) fn symbols() -> ArrayRef {
    Arc::new(StringArray::from_iter_values(Mode::ALL.map(Mode::symbol)))
}

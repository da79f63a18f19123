//! Results as columns of Arrow.

use std::sync::Arc;

use arrow_array::types::{ArrowDictionaryKeyType, Int8Type, Int32Type};
use arrow_array::{
    ArrayRef, BooleanArray, DictionaryArray, Float64Array, Int8Array, PrimitiveArray, StringArray,
};
use arrow_schema::{DataType, Field};

use crate::results::{ColumnWords, FieldKind, NO_NAME, NO_WORD, ResultField, Values};
use crate::task::Task;

impl Task {
    /// The results' names and types in Arrow, with what is said of them.
    pub(crate) fn fields(&self) -> Vec<Field> {
        self.fields.iter().map(ResultField::in_arrow).collect()
    }
}

impl ResultField {
    fn in_arrow(&self) -> Field {
        let field = Field::new(self.heading(), self.kind.data_type(), true);
        let Some(ColumnWords { unit, words }) = self.said else { return field };
        let unit = unit.map(|unit| ("unit", unit));
        let said = unit.into_iter().chain([("description", words)]);
        field.with_metadata(said.map(|(key, words)| (key.to_owned(), words.to_owned())).collect())
    }
}

impl FieldKind {
    fn data_type(&self) -> DataType {
        let dictionary = |keys| DataType::Dictionary(Box::new(keys), Box::new(DataType::Utf8));
        match self {
            // One byte a row in memory, and three or four bits in Parquet.
            FieldKind::Word(_) => dictionary(DataType::Int8),
            FieldKind::Name(_) => dictionary(DataType::Int32),
            FieldKind::Modes | FieldKind::Text => DataType::Utf8,
            FieldKind::Flag => DataType::Boolean,
            FieldKind::Number => DataType::Float64,
        }
    }
}

impl Values {
    /// The results as an array of Arrow.
    pub(crate) fn into_array(self) -> ArrayRef {
        match self {
            Values::Word(words, codes) => {
                let keys: Int8Array = if codes.contains(&NO_WORD) {
                    codes.into_iter().map(|code| (code != NO_WORD).then_some(code.cast_signed())).collect()
                } else {
                    Int8Array::from_iter_values(codes.into_iter().map(u8::cast_signed))
                };
                dictionary::<Int8Type>(keys, words.iter().copied())
            }
            Values::Name(names, places) => {
                let keys = places.into_iter().map(|place| (place != NO_NAME).then_some(place.cast_signed()));
                dictionary::<Int32Type>(keys.collect(), names.iter().map(String::as_str))
            }
            Values::Modes(sets) => {
                let texts = sets.into_iter().map(|set| set.map(|modes| modes.to_string()));
                Arc::new(texts.collect::<StringArray>())
            }
            Values::Flag(flags) => Arc::new(BooleanArray::from(flags)),
            Values::Text(texts) => Arc::new(StringArray::from(texts)),
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

/// A column of words; a row without key has none.
fn dictionary<'a, K: ArrowDictionaryKeyType>(
    keys: PrimitiveArray<K>,
    words: impl Iterator<Item = &'a str>,
) -> ArrayRef {
    Arc::new(DictionaryArray::<K>::new(keys, Arc::new(StringArray::from_iter_values(words))))
}

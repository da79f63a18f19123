//! The day a sheet bears.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

/// A day of the calendar.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Date {
    year: u16,
    month: u8,
    day: u8,
}

/// A text that is no day.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Error)]
pub enum DateError {
    /// Not four digits, two, two, with hyphens between.
    #[error("expected a date like 2026-11-21")]
    Form,
    /// No such day.
    #[error("there is no such day")]
    NoDay,
}

impl FromStr for Date {
    type Err = DateError;

    fn from_str(text: &str) -> Result<Date, DateError> {
        let parts: Vec<_> = text.split('-').collect();
        let digits = |part: &&str| part.bytes().all(|byte| byte.is_ascii_digit());
        let [year, month, day] = parts[..] else { return Err(DateError::Form) };
        if [year.len(), month.len(), day.len()] != [4, 2, 2] || !parts.iter().all(digits) {
            return Err(DateError::Form);
        }
        let number = |part: &str| part.parse::<u16>().map_err(|_| DateError::Form);
        let (year, month, day) = (number(year)?, number(month)?, number(day)?);
        let leap = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
        let days = match month {
            1 | 3 | 5 | 7 | 8 | 10 | 12 => 31,
            4 | 6 | 9 | 11 => 30,
            2 if leap => 29,
            2 => 28,
            _ => 0,
        };
        if year == 0 || day == 0 || day > days {
            return Err(DateError::NoDay);
        }
        Ok(Date { year, month: month as u8, day: day as u8 })
    }
}

impl fmt::Display for Date {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:04}-{:02}-{:02}", self.year, self.month, self.day)
    }
}

#[cfg(test)]
mod tests {
    use super::{Date, DateError};

    #[test]
    fn days_of_the_calendar_only() {
        for text in ["2026-11-21", "2024-02-29", "2000-02-29", "1999-12-31"] {
            assert_eq!(text.parse::<Date>().map(|date| date.to_string()), Ok(text.to_owned()));
        }
        for text in
            ["2026-02-29", "1900-02-29", "2026-13-01", "2026-04-31", "2026-00-10", "0000-01-01", "2026-01-00"]
        {
            assert_eq!(text.parse::<Date>(), Err(DateError::NoDay), "{text}");
        }
        for text in ["", "21.11.2026", "2026-1-2", "2026-11-21T10:00", "26-11-21", "+026-11-21", "2026-11"] {
            assert_eq!(text.parse::<Date>(), Err(DateError::Form), "{text}");
        }
    }
}

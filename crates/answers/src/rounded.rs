//! Numbers of a few digits on the safe side of a bound.

/// A decimal number with so many significant digits, which a text shows to the last.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Decimal {
    digits: i64,
    exponent: i32,
}

/// The side to which a number is rounded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Towards {
    /// To smaller numbers.
    Less,
    /// To larger numbers.
    More,
}

impl Towards {
    /// The other side.
    pub(crate) fn other(self) -> Towards {
        match self {
            Towards::Less => Towards::More,
            Towards::More => Towards::Less,
        }
    }
}

impl Decimal {
    /// `x`, which is finite, or the nearest number of `count` significant digits, 17 at most, towards a side of it.
    pub(crate) fn of(x: f64, count: usize, towards: Towards) -> Decimal {
        let scientific = format!("{x:.*e}", count - 1);
        let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
        let digits: i64 = mantissa.replace('.', "").parse().unwrap_or(0);
        let exponent = exponent.parse().unwrap_or(0) - (count as i32 - 1);
        let nearest = Decimal { digits, exponent };
        let is_beyond = match towards {
            Towards::Less => nearest.value() > x,
            Towards::More => nearest.value() < x,
        };
        let tenfold = 10i64.pow(count as u32 - 1);
        match is_beyond {
            // Rounded up to a power of ten: before it stand as many nines.
            true if digits.abs() == tenfold && x.abs() < nearest.value().abs() => {
                Decimal { digits: digits.signum() * (10 * tenfold - 1), exponent: exponent - 1 }
            }
            true => nearest.next(towards),
            false => nearest,
        }
    }

    /// Round numbers from `least` to `greatest`, multiples of 1, 2 or 5 times a power of ten, some four to eight; and in each of
    /// the steps between them ten.
    pub(crate) fn steps(least: f64, greatest: f64) -> (Vec<Decimal>, Vec<Decimal>) {
        const MOST: f64 = 8.0;
        let size = greatest - least;
        let power = (size / MOST).log10().floor() as i32;
        let rough = [1, 2, 5, 10]
            .into_iter()
            .find(|step| size / Decimal { digits: *step, exponent: power }.value() <= MOST);
        let step = rough.unwrap_or(10);
        let multiples = |exponent: i32| {
            let unit = Decimal { digits: step, exponent }.value();
            // A quotient may be rounded past a whole number.
            let (first, last) = ((least / unit).floor() as i64, (greatest / unit).ceil() as i64);
            let all = (first..=last).map(|times| Decimal { digits: times * step, exponent });
            all.filter(|one| (least..=greatest).contains(&one.value())).collect()
        };
        (multiples(power), multiples(power - 1))
    }

    /// One more, or less, in the last digit.
    pub(crate) fn next(self, towards: Towards) -> Decimal {
        let step = match towards {
            Towards::Less => -1,
            Towards::More => 1,
        };
        Decimal { digits: self.digits + step, ..self }
    }

    /// The f64 nearest to it.
    pub(crate) fn value(self) -> f64 {
        let Decimal { digits, exponent } = self;
        // What Rust reads is rounded correctly; a product by a power of ten is not.
        format!("{digits}e{exponent}").parse().unwrap_or(f64::NAN)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rounded_to_either_side() {
        let cases = [
            (15.4601, 15.46, 15.47),
            (15.46, 15.46, 15.46),
            (-0.12345, -0.1235, -0.1234),
            (282_201.0, 282_200.0, 282_300.0),
            (9.9996, 9.999, 10.0),
            (-9.9996, -10.0, -9.999),
            (10.0004, 10.0, 10.01),
            (1e-9, 1e-9, 1e-9),
            (2.0f64.powi(70), 1.180e21, 1.181e21),
        ];
        for (x, less, more) in cases {
            let found = [Towards::Less, Towards::More].map(|towards| Decimal::of(x, 4, towards).value());
            assert_eq!(found, [less, more], "{x}");
        }
        assert_eq!(Decimal::of(0.0, 4, Towards::More).next(Towards::Less).value(), -0.001);
        assert_eq!(Decimal::of(15.46, 4, Towards::More).next(Towards::Less).value(), 15.45);
    }

    #[test]
    fn steps_are_round() {
        let (rough, fine) = Decimal::steps(0.3, 1.2);
        let rough: Vec<_> = rough.into_iter().map(Decimal::value).collect();
        assert_eq!(rough, [0.4, 0.6, 0.8, 1.0, 1.2]);
        assert_eq!(fine.len(), 46);
        assert_eq!(fine[15].value(), 0.6);
        assert_eq!(Decimal::steps(-2e5, 3e5).0.len(), 6);
    }

    /// Seventeen digits are the number itself.
    #[test]
    fn all_digits_change_nothing() {
        for x in [0.1, 1.0 / 3.0, 5e-324, f64::MAX, -1.7e-8, 123_456_789.123_456_78] {
            assert_eq!(Decimal::of(x, 17, Towards::More).value(), x);
            assert_eq!(Decimal::of(x, 17, Towards::Less).value(), x);
        }
    }
}

//! Where a function of one number passes zero.

/// The search for where a function passes zero between two numbers at which its signs differ, a value at a time: the largest number at which it is not above, to
/// two units in the last place; where it jumps, exactly. By Chandrupatla's choice between inverse quadratic interpolation and bisection (Advances
/// in Engineering Software 28, 1997).
#[derive(Debug, Clone, Copy)]
pub(crate) struct Crossing {
    a: f64,
    fa: f64,
    b: f64,
    fb: f64,
    /// Where between `a` and `b` the next value is taken.
    t: f64,
    steps: u32,
}

impl Crossing {
    /// Most steps: 64 halvings of a distance reach the last bit; as many again for steps that are less, and some.
    const MOST: u32 = 200;

    /// Between `low`, at which the function is not above zero, and `high`, at which it is.
    pub(crate) fn new((low, at_low): (f64, f64), (high, at_high): (f64, f64)) -> Crossing {
        Crossing { a: high, fa: at_high, b: low, fb: at_low, t: 0.5, steps: 0 }
    }

    /// The number at which the function is to be known next, unless the root is found.
    pub(crate) fn next(&self) -> Option<f64> {
        let (below, above) = self.ends();
        let is_found = self.fa == 0.0 || below.next_up() >= above || self.steps >= Crossing::MOST;
        let x = self.a + self.t * (self.b - self.a);
        (!is_found).then(|| x.clamp(self.a.min(self.b), self.a.max(self.b)))
    }

    /// Takes the function's value at the number that [`next`](Self::next) gave.
    pub(crate) fn met(&mut self, x: f64, fx: f64) {
        let is_above = |f: f64| f > 0.0;
        let (c, fc) = if is_above(fx) == is_above(self.fa) { (self.a, self.fa) } else { (self.b, self.fb) };
        if is_above(fx) != is_above(self.fa) {
            (self.b, self.fb) = (self.a, self.fa);
        }
        (self.a, self.fa) = (x, fx);
        self.steps += 1;
        let Crossing { a, fa, b, fb, .. } = *self;
        let (below, above) = self.ends();
        let width = (b - a).abs();
        let least = (above.abs().max(below.abs()) * f64::EPSILON).max(f64::MIN_POSITIVE) / width;
        let (xi, phi) = ((a - b) / (c - b), (fa - fb) / (fc - fb));
        let is_smooth = phi * phi < xi && (1.0 - phi) * (1.0 - phi) < 1.0 - xi;
        let inverse = fa / (fb - fa) * fc / (fb - fc) + (c - a) / (b - a) * fa / (fc - fa) * fb / (fc - fb);
        let least = least.min(0.5);
        self.t = if is_smooth && inverse.is_finite() { inverse.clamp(least, 1.0 - least) } else { 0.5 };
    }

    /// The root.
    pub(crate) fn root(&self) -> f64 {
        self.ends().0
    }

    /// The ends: where the function is not above zero, and where it is.
    fn ends(&self) -> (f64, f64) {
        if self.fa > 0.0 { (self.b, self.a) } else { (self.a, self.b) }
    }
}

/// Where a function that rises from `low` to `high` passes zero, as a [`Crossing`] finds it; an end where it does not.
pub(crate) fn where_met(low: f64, high: f64, f: impl Fn(f64) -> f64) -> f64 {
    if low >= high {
        return low;
    }
    let (at_low, at_high) = (f(low), f(high));
    if at_high <= 0.0 {
        return high;
    }
    if at_low > 0.0 {
        return low;
    }
    let mut crossing = Crossing::new((low, at_low), (high, at_high));
    while let Some(x) = crossing.next() {
        crossing.met(x, f(x));
    }
    crossing.root()
}

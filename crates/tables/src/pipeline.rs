//! Work on all cores, results in order.

use std::collections::BTreeMap;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

use crate::guard::guarded;

/// Takes pieces from `source`, works on them on `threads` threads, and gives the results to `sink` in the order of
/// the pieces, until the source ends or something fails: then with the error that comes first in that order.
///
/// No more than two pieces a thread are under way at once. `panicked` makes an error of a panic.
pub(crate) fn run<Piece: Send, Done: Send, E: Send>(
    threads: usize,
    mut source: impl FnMut() -> Result<Option<Piece>, E> + Send,
    work: impl Fn(Piece) -> Result<Done, E> + Sync,
    mut sink: impl FnMut(Done) -> Result<(), E>,
    panicked: impl Fn(String) -> E + Sync,
) -> Result<(), E> {
    if threads <= 1 {
        while let Some(done) = guarded(&panicked, || source()?.map(&work).transpose())? {
            sink(done)?;
        }
        return Ok(());
    }

    let source = Mutex::new((source, 0_usize));
    let shared = Mutex::new(Shared { done: BTreeMap::new(), next: 0, end: None });
    let changed = Condvar::new();
    // The next piece and its turn, if there is one.
    let take = || -> Option<(usize, Result<Piece, E>)> {
        let mut source = lock(&source);
        let turn = source.1;
        let mut state = lock(&shared);
        while state.end.is_none() && turn >= state.next + 2 * threads {
            state = changed.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
        if state.end.is_some() {
            return None;
        }
        drop(state);
        source.1 += 1;
        let piece = match guarded(&panicked, || (source.0)()) {
            Ok(Some(piece)) => return Some((turn, Ok(piece))),
            Ok(None) => None,
            Err(error) => Some((turn, Err(error))),
        };
        lock(&shared).end = Some(turn + usize::from(piece.is_some()));
        changed.notify_all();
        piece
    };
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while let Some((turn, piece)) = take() {
                    let done = piece.and_then(|piece| guarded(&panicked, || work(piece)));
                    lock(&shared).done.insert(turn, done);
                    changed.notify_all();
                }
            });
        }
        let mut outcome = Ok(());
        while let Some(done) = Shared::take(&shared, &changed) {
            outcome = done.and_then(|done| guarded(&panicked, || sink(done)));
            let mut state = lock(&shared);
            state.next += 1;
            if outcome.is_err() {
                state.end = Some(0);
            }
            drop(state);
            changed.notify_all();
            if outcome.is_err() {
                break;
            }
        }
        outcome
    })
}

/// State that the threads share.
struct Shared<Done, E> {
    /// Finished and not yet taken, by turn.
    done: BTreeMap<usize, Result<Done, E>>,
    /// The turn whose result is to be taken next.
    next: usize,
    /// Number of turns, once that is known; no more pieces are taken from then on.
    end: Option<usize>,
}

impl<Done, E> Shared<Done, E> {
    /// Waits for the next result in order; `None` at the end.
    fn take(shared: &Mutex<Self>, changed: &Condvar) -> Option<Result<Done, E>> {
        let mut state = lock(shared);
        loop {
            let next = state.next;
            if let Some(done) = state.done.remove(&next) {
                return Some(done);
            }
            if state.end.is_some_and(|end| next >= end) {
                return None;
            }
            state = changed.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
    }
}

fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use std::sync::Mutex;
    use std::time::Duration;

    /// Pieces of `0..pieces` that the sink gets, and the error; `work` fails for those in `bad`, the source at
    /// `broken`.
    fn outcome(threads: usize, pieces: u32, bad: &[u32], broken: u32) -> (Vec<u32>, Result<(), String>) {
        let mut next = 0;
        let source = || {
            if next == broken {
                return Err(format!("source {next}"));
            }
            next += 1;
            Ok((next <= pieces).then_some(next - 1))
        };
        let work = |piece: u32| {
            // The first of every five is the slowest.
            std::thread::sleep(Duration::from_micros(u64::from(4 - piece % 5) * 50));
            assert!(piece != 55 || bad != [55], "at 55");
            if bad.contains(&piece) { Err(format!("work {piece}")) } else { Ok(piece) }
        };
        let got = Mutex::new(Vec::new());
        let sink = |piece: u32| {
            got.lock().unwrap().push(piece);
            if piece == 66 { Err("sink 66".to_owned()) } else { Ok(()) }
        };
        let result = super::run(threads, source, work, sink, |words| format!("panic {words}"));
        (got.into_inner().unwrap(), result)
    }

    #[test]
    fn order_and_the_first_error_do_not_depend_on_the_threads() {
        for threads in [1, 2, 3, 8] {
            for pieces in [0, 1, 2, 50] {
                assert_eq!(outcome(threads, pieces, &[], u32::MAX), ((0..pieces).collect(), Ok(())));
            }
            let failed = |bad: &[u32], broken| outcome(threads, 60, bad, broken);
            assert_eq!(failed(&[20, 10, 11], 30), ((0..10).collect(), Err("work 10".to_owned())));
            assert_eq!(failed(&[40], 30), ((0..30).collect(), Err("source 30".to_owned())));
            assert_eq!(failed(&[], 0), (vec![], Err("source 0".to_owned())));
            assert_eq!(failed(&[55], u32::MAX), ((0..55).collect(), Err("panic at 55".to_owned())));
            let full = outcome(threads, 90, &[], u32::MAX);
            assert_eq!(full, ((0..=66).collect(), Err("sink 66".to_owned())));
        }
    }
}

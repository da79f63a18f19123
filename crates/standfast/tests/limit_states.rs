//! Limit states: their signs decide the mode by the table of their module, and their values are the reactions of the motions.

mod common;

use common::{Random, tries};
use standfast::initiation::{LimitState, LimitStates};
use standfast::{Corner, Mode, Point};

//! The options of `standfast sheet` that go into its title block: one for each of the keys a case file may have for it, from the
//! same table.

use clap::{Arg, ArgMatches, Args, Command, Error, FromArgMatches};
use standfast_cases::Key;
use standfast_cases::key::TITLE_BLOCK;

/// Entries of the title block from the command line.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct TitleBlock(pub Vec<(Key, String)>);

impl FromArgMatches for TitleBlock {
    fn from_arg_matches(matches: &ArgMatches) -> Result<TitleBlock, Error> {
        let given = |key: Key| Some((key, matches.get_one::<String>(key.name())?.clone()));
        Ok(TitleBlock(TITLE_BLOCK.into_iter().filter_map(given).collect()))
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), Error> {
        *self = TitleBlock::from_arg_matches(matches)?;
        Ok(())
    }
}

impl Args for TitleBlock {
    fn augment_args(command: Command) -> Command {
        TITLE_BLOCK.into_iter().fold(command, |command, key| {
            let words = key.info().words;
            let help = format!("In the title block: {words} [default: as in the case file]");
            command.arg(Arg::new(key.name()).long(key.name()).value_name("TEXT").help(help))
        })
    }

    fn augment_args_for_update(command: Command) -> Command {
        TitleBlock::augment_args(command)
    }
}

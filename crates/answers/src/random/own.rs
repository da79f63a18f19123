//! Numbers of a limit state that is the user's own: names and laws, without a case.

use standfast_inputs::random::{Lifetime, RandomProblem};
use standfast_inputs::{CaseError, CaseText};
use standfast_probability::problem::RandomVector;

use super::resolve::{Names, Resolve};

/// Numbers of a limit state that is the user's own.
#[derive(Debug, Clone)]
pub struct OwnNumbers {
    /// Their names; behind those of the table the parameters of laws that are fitted.
    pub names: Vec<String>,
    /// Number of those that stand in the table, which the limit state is a function of.
    pub arguments: usize,
    /// Their laws, and how they are correlated.
    pub laws: RandomVector,
}

/// The names and laws of a text that is a table `[random]`, and how they are correlated. Any name is one of a number of the user's own.
///
/// # Errors
/// If there is no such table, or a law or a correlation is wrong.
///
/// ```
/// use standfast_answers::random::own_laws;
/// use standfast_inputs::CaseText;
///
/// let text = "[random]\nresistance = { normal = { mean = 0.6, sd = 0.06 } }\nload = { gumbel = { mean = 0.3, cov = 0.2 } }\n";
/// let own = own_laws(&CaseText::parse("laws.toml", text)?)?;
/// assert_eq!((own.names, own.arguments), (vec!["resistance".to_owned(), "load".to_owned()], 2));
/// # Ok::<(), standfast_inputs::CaseError>(())
/// ```
pub fn own_laws(text: &CaseText) -> Result<OwnNumbers, CaseError> {
    let Some(random) = text.random() else {
        return Err(text.random_error(RandomProblem::Nothing, 0..0));
    };
    if random.lifetime != Lifetime::default() || random.target_beta.is_some() || random.sensitivities {
        let message =
            "a limit state of your own is asked for one event; expected laws and correlations alone";
        return Err(text.random_error(RandomProblem::Other(message.to_owned()), random.span.clone()));
    }
    let found = Resolve(Names::Own).all(random);
    let (inputs, laws) = found.map_err(|(problem, span)| text.random_error(problem, span))?;
    let arguments = random.named.len();
    Ok(OwnNumbers { names: inputs.into_iter().map(|input| input.name).collect(), arguments, laws })
}
